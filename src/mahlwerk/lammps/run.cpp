// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/lammps/output_files.hpp"

namespace mahlwerk::lammps {
namespace fs = std::filesystem;
namespace {

constexpr const char* cpu_file = "cpu.txt";  // [s] of all runs of the folder that have ended

}  // namespace

Run::Run(const Launch& launch) : folder_(launch.folder), ranks_(std::max(1, launch.ranks)) {
  if (folder_.empty()) {
    std::string made = (fs::temp_directory_path() / "mahlwerk-lammps-XXXXXX").string();
    if (::mkdtemp(made.data()) == nullptr)
      throw RunError(fmt::format("the folder {} cannot be made", made));
    folder_ = made;
    temporary_ = true;
  }
  resumes_ = launch.resume && fs::exists(folder_ / "in.lammps");
  if (resumes_) std::ifstream(folder_ / cpu_file) >> earlier_cpu_;
}

Run::~Run() {
  stop();
  std::error_code ignored;
  if (temporary_) fs::remove_all(folder_, ignored);
}

bool Run::ended() {
  if (!running_) return true;
  const bool now = running_->ended();
  if (now) keep_cpu_seconds();
  return now;
}

void Run::stop() {
  if (!running_) return;
  running_->stop();
  keep_cpu_seconds();
  earlier_cpu_ = cpu_seconds();
  running_.reset();
}

void Run::keep_cpu_seconds() const {
  std::ofstream(folder_ / cpu_file) << fmt::format("{:.6g}\n", cpu_seconds());
}

void Run::start(const cases::Case& mill_case, std::int64_t last) {
  if (resumes_) {
    wait_for_others(folder_);
    check_case(mill_case);
    if (is_complete(last)) return;
  }
  if (resumes_ && start_from_restart_file()) return;
  for (const auto& entry : fs::directory_iterator(folder_))  // ended before its first restart file
    if (entry.path().extension() == ".txt") fs::remove(entry.path());
  running_ = std::make_unique<Running>(folder_, command());
}

/// What the folder holds must be of this case.
void Run::check_case(const cases::Case& mill_case) const {
  std::ifstream file(folder_ / "case.toml");
  const std::string kept(std::istreambuf_iterator<char>(file), {});
  if (kept == cases::write(mill_case)) return;
  throw InputError(
      Fault{folder_.string(), "the folder is that of another case, or of other values",
            "give the options of the run that is to be resumed, or begin again without --resume",
            "bad-checkpoint"});
}

/// Whether LAMMPS has written the last line of the balance.
bool Run::is_complete(std::int64_t last) const {
  OutputFile balance(folder_, "balance", OutputFile::Kind::table, balance_columns);
  const std::vector<Session> all = sessions(folder_);
  std::int64_t reached = 0;
  while (const Rows* row = balance.next(all)) reached = row->step;
  return reached == last;
}

std::vector<std::string> Run::command() const {
  const Installed lmp = installed(ranks_);
  if (!lmp.faults.empty()) throw InputError(lmp.faults);
  std::vector<std::string> words;
  if (ranks_ > 1 && ::geteuid() == 0)  // Open MPI asks root twice
    words = {"env", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"};
  if (ranks_ > 1)
    for (const std::string& word :
         {std::string("mpirun"), std::string("-np"), std::to_string(ranks_)})
      words.push_back(word);
  for (const std::string& word : {lmp.command, std::string("-in"), std::string("in.lammps"),
                                  std::string("-screen"), std::string("none")})
    words.push_back(word);
  return words;
}

/// A restart file that was being written when a process ended cannot be read; the other one can.
/// Where the first one was being written there is no other: false, and the run begins again.
bool Run::start_from_restart_file() {
  const std::vector<fs::path> files = restart_files();
  const std::vector<std::string> begin = command();
  for (const fs::path& file : files) {
    const std::size_t before = sessions(folder_).size();
    std::vector<std::string> words = begin;
    for (const std::string& word :
         {std::string("-var"), std::string("from"), file.filename().string(), std::string("-var"),
          std::string("session"), std::to_string(before)})
      words.push_back(word);
    running_ = std::make_unique<Running>(folder_, words);
    while (sessions(folder_).size() == before && !running_->ended())
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (sessions(folder_).size() > before) return true;
  }
  if (files.size() > 1) end_early(0);
  running_.reset();
  return false;
}

/// The newest first.
std::vector<fs::path> Run::restart_files() const {
  std::vector<fs::path> found;
  for (const char* name : {"restart.a", "restart.b"})
    if (fs::exists(folder_ / name)) found.push_back(folder_ / name);
  std::ranges::sort(found, std::ranges::greater(),
                    [](const fs::path& file) { return fs::last_write_time(file); });
  return found;
}

void Run::end_early(double time) const {
  const std::string error = last_error(folder_);
  const char* log = fs::exists(folder_ / "log.lammps") ? "log.lammps" : "screen.txt";
  throw RunError(fmt::format(
      "LAMMPS stopped at {:.6g} s{}. Its messages are in {}. --resume goes on from its last "
      "restart file, once the cause is removed (a full disk leaves no message)",
      time, error.empty() ? "" : ": " + error, (folder_ / log).string()));
}

}  // namespace mahlwerk::lammps
