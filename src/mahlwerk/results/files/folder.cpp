// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <system_error>
#include <vector>

#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;

InputError at_work(const fs::path& wanted) {
  return InputError(Fault{wanted.string(), "another process is at work on a result for this folder",
                          "wait until it ends, or give another folder with --out",
                          "result-at-work"});
}

void check_replaceable(const fs::path& wanted, bool force) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw InputError(Fault{wanted.string(), what, remedy, "result-exists"});
  };
  if (!fs::exists(fs::symlink_status(wanted))) return;
  if (!fs::is_directory(wanted))
    refuse("is a file, not a folder", "choose another folder with --out");
  if (fs::is_empty(wanted)) return;
  if (!is_result(wanted))
    refuse("is not empty, and what it holds is not a result of Mahlwerk, so it is left alone",
           "choose another folder with --out");
  if (!force)
    refuse("holds a result already",
           fs::exists(wanted.string() + ".checkpoint")
               ? "go on with the run that left it by --resume, replace it with --force, or choose "
                 "another folder with --out"
               : "choose another folder with --out, or replace it with --force");
  const std::vector<std::string> others = foreign_files(wanted);
  if (!others.empty())
    refuse(fmt::format(
               "holds, besides a result, what Mahlwerk did not write ({}{}), so it is left alone",
               others.front(), others.size() > 1 ? " and more" : ""),
           "move that away, or choose another folder with --out");
  if (FileLock::held(wanted / "campaign.lock")) throw at_work(wanted);
}

/// The folder as an absolute path without "..", links followed as far as the path exists.
fs::path resolved(const fs::path& wanted) {
  if (wanted.empty())
    throw InputError(
        Fault{"--out", "the name of the result folder is empty", "give a folder", "cannot-write"});
  fs::path path = fs::weakly_canonical(fs::absolute(wanted));
  if (!path.has_filename()) path = path.parent_path();
  return path;
}

/// What the name of a folder beside the wanted one begins with: ".NAME.partial-".
std::string hidden(const fs::path& wanted, std::string_view what) {
  return fmt::format(".{}.{}-", wanted.filename().string(), what);
}

fs::path beside(const fs::path& wanted, std::string_view what) {
  return wanted.parent_path() / (hidden(wanted, what) + std::to_string(::getpid()));
}

/// Whether the number that ends the name is that of a process that lives, other than this one; or
/// is none.
bool of_another(std::string_view number) {
  ::pid_t process = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), process);
  if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || process <= 0)
    return true;
  return process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
}

/// What starts that were killed left beside the wanted folder, whose name is this process's alone.
/// A complete result that could not be put in place stays.
void clear_remains(const fs::path& wanted) {
  if (wanted.parent_path().filename() == campaign_runs) return;  // the campaign has seen to it
  const std::string partial = hidden(wanted, "partial"), replaced = hidden(wanted, "replaced");
  std::vector<fs::path> remains;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(wanted.parent_path(), none)) {
    const std::string name = entry.path().filename().string();
    const auto left_by = [&](const std::string& before) {
      return name.starts_with(before) && !of_another(std::string_view(name).substr(before.size()));
    };
    if ((left_by(partial) && !listed_files(entry.path())) ||
        (left_by(replaced) && fs::exists(wanted) && foreign_files(entry.path()).empty()))
      remains.push_back(entry.path());
  }
  for (const fs::path& one : remains) fs::remove_all(one, none);
}

/// 0, or the number of the error that kept a byte from being written.
int written(const fs::path& file, std::string_view text) {
  std::FILE* out = std::fopen(file.c_str(), "wb");
  if (out == nullptr) return errno;
  int failed = 0;
  if (std::fwrite(text.data(), 1, text.size(), out) != text.size()) failed = errno;
  if (failed == 0 && std::fflush(out) != 0) failed = errno;
  if (std::fclose(out) != 0 && failed == 0) failed = errno;
  return failed;
}

}  // namespace

InputError cannot_write(const fs::path& place, const std::string& why) {
  return InputError(
      Fault{place.string(), "cannot be written: " + why,
            "free some space or mend the permissions, or choose another folder with --out",
            "cannot-write"});
}

Folder::Folder(const fs::path& wanted, bool force) : force_(force) {
  try {
    wanted_ = resolved(wanted);
    check_replaceable(wanted_, force);
    fs::create_directories(wanted_.parent_path());
    lock_.emplace(wanted_.parent_path() / fmt::format(".{}.lock", wanted_.filename().string()),
                  FileLock::Holds::alone, FileLock::After::file_goes);
    if (lock_->state() == FileLock::State::another_has_it) throw at_work(wanted_);
    check_replaceable(wanted_, force);  // again: who had the lock may just have written there
    if (lock_->state() == FileLock::State::held) clear_remains(wanted_);
    aside_ = beside(wanted_, "partial");
    while (listed_files(aside_)) aside_ += "-";  // complete, of a process of the same number
    fs::remove_all(aside_);
    fs::create_directory(aside_);
  } catch (const std::system_error& e) {
    throw cannot_write(wanted, e.code().message());
  }
}

Folder::~Folder() {
  std::error_code ignored;
  if (!done_) fs::remove_all(aside_, ignored);
}

fs::path Folder::file(std::string_view name) const {
  const fs::path path = aside_ / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw cannot_write(wanted_ / name, error.message());
  return path;
}

void Folder::write(std::string_view name, std::string_view text) const {
  if (const int failed = written(file(name), text); failed != 0)
    throw cannot_write(wanted_ / name, std::strerror(failed));
}

void Folder::commit() {
  done_ = true;  // from here on the result is kept, come what may: it may have taken hours
  try {
    list_all_files(aside_);
    put_in_place();
  } catch (const std::exception& e) {
    keep_complete();
    throw InputError(Fault{
        wanted_.string(), std::string("the result cannot be put in place: ") + e.what(),
        "it is complete in " + aside_.string() + "; move it where you want it", "cannot-write"});
  }
}

/// Under a name that nobody takes for that of a result in the making.
void Folder::keep_complete() {
  const fs::path kept = beside(wanted_, "complete");
  std::error_code failed;
  fs::rename(aside_, kept, failed);
  if (!failed) aside_ = kept;
}

void Folder::put_in_place() const {
  check_replaceable(wanted_, force_);  // again: much may have happened during the run
  if (!fs::exists(wanted_) || fs::is_empty(wanted_)) return fs::rename(aside_, wanted_);
  const fs::path old = beside(wanted_, "replaced");
  std::error_code ignored;
  fs::rename(wanted_, old);
  try {
    fs::rename(aside_, wanted_);
  } catch (const fs::filesystem_error&) {
    fs::rename(old, wanted_, ignored);
    throw;
  }
  fs::remove_all(old, ignored);
}

void write_text(const fs::path& file, std::string_view text) {
  if (const int failed = written(file, text); failed != 0)
    throw cannot_write(file, std::strerror(failed));
}

void make_folder(const std::filesystem::path& place) {
  std::error_code failed;
  std::filesystem::create_directories(place, failed);
  if (failed)
    throw InputError(Fault{place.string(), "cannot be written: " + failed.message(),
                           "check that you may write there, or give another folder with --out",
                           "cannot-write"});
}

}  // namespace mahlwerk::results
