// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

// Runs the program as a user does, in a temporary folder that is removed with the test.
namespace mahlwerk::tests {

struct ProgramResult {
  int code;
  std::string output;  // on both streams
};

class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "mahlwerk-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for a test");
    here_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(here_); }

  ProgramResult mahlwerk(const std::string& words) const {
    const std::string command = "(cd '" + here_.string() + "' && '" +
                                std::string(MAHLWERK_PROGRAM) + "' " + words + ") 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string said;
    char part[4096];
    while (const std::size_t n = fread(part, 1, sizeof part, pipe)) said.append(part, n);
    return {WEXITSTATUS(pclose(pipe)), said};
  }
  /// Sends `signal` as soon as the file `once` exists, or a checkpoint in the folder `once`. The
  /// code of a program that was ended by a signal is 128 plus the signal number, as in a shell.
  ProgramResult mahlwerk_until(const std::string& once, int signal,
                               const std::string& words) const {
    const pid_t child = fork();
    if (child == 0) {
      const int said = ::open((here_ / "said").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
      dup2(said, 1);
      dup2(said, 2);
      const std::string command =
          "cd '" + here_.string() + "' && exec '" + std::string(MAHLWERK_PROGRAM) + "' " + words;
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    const auto there = [&] {
      const std::filesystem::path wanted = here_ / once;
      std::error_code none;
      if (std::filesystem::is_regular_file(wanted, none)) return true;
      for (const auto& file : std::filesystem::directory_iterator(wanted, none))
        if (file.path().extension() == ".checkpoint") return true;
      return false;
    };
    int status = 0;
    bool sent = false;
    while (waitpid(child, &status, WNOHANG) == 0) {
      if (!sent && there()) sent = kill(child, signal) == 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), text("said")};
  }
  std::string text(const std::string& name) const {
    std::ifstream in(here_ / name);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(here_ / name); }
  /// The program refuses the input with a message that contains `because`, and writes nothing to
  /// "out".
  void expect_refused(const std::string& words, const std::string& because) const {
    const ProgramResult e = mahlwerk(words);
    EXPECT_EQ(e.code, 2) << words << "\n" << e.output;
    EXPECT_NE(e.output.find(because), std::string::npos) << words << "\n" << e.output;
    EXPECT_FALSE(exists("out")) << words;
  }

  static std::string example(const std::string& name) {
    return std::string("'") + MAHLWERK_HOME + "/examples/" + name + "'";
  }

  std::filesystem::path here_;
};

}  // namespace mahlwerk::tests
