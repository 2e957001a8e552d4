// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

// The program as a user meets it, in a folder that goes away with the test.
namespace mahlwerk::tests {

struct Ended {
  int code;
  std::string said;  // on both streams
};

class ProgramTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "mahlwerk-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for a test");
    here_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(here_); }

  Ended mahlwerk(const std::string& words) const {
    const std::string command = "(cd '" + here_.string() + "' && '" +
                                std::string(MAHLWERK_PROGRAM) + "' " + words + ") 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string said;
    char part[4096];
    while (const std::size_t n = fread(part, 1, sizeof part, pipe)) said.append(part, n);
    return {WEXITSTATUS(pclose(pipe)), said};
  }
  std::string text(const std::string& name) const {
    std::ifstream in(here_ / name);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(here_ / name); }
  /// Refused as bad input, for a reason that says `because`, with nothing in "out".
  void expect_refused(const std::string& words, const std::string& because) const {
    const Ended e = mahlwerk(words);
    EXPECT_EQ(e.code, 2) << words << "\n" << e.said;
    EXPECT_NE(e.said.find(because), std::string::npos) << words << "\n" << e.said;
    EXPECT_FALSE(exists("out")) << words;
  }

  static std::string example(const std::string& name) {
    return std::string("'") + MAHLWERK_HOME + "/examples/" + name + "'";
  }

  std::filesystem::path here_;
};

}  // namespace mahlwerk::tests
