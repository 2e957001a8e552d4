// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/folder.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <system_error>
#include <vector>

#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"
#include "mahlwerk/results/files/process.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* reserved = ".reserved";  // a file that keeps space on the disk

InputError in_use_error(const fs::path& target) {
  return InputError(Fault{target.string(), "another process is at work on a result for this folder",
                          "wait until it ends, or give another folder with --out",
                          "result-at-work"});
}

void check_replaceable(const fs::path& target, bool force) {
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw InputError(Fault{target.string(), what, remedy, "result-exists"});
  };
  if (!fs::exists(fs::symlink_status(target))) return;
  if (!fs::is_directory(target))
    refuse("is a file, not a folder", "choose another folder with --out");
  if (fs::is_empty(target)) return;
  if (!is_result(target))
    refuse("is not empty and holds no result of Mahlwerk, so it is not changed",
           "choose another folder with --out");
  if (!force)
    refuse("holds a result already",
           fs::exists(target.string() + ".checkpoint")
               ? "continue the interrupted run with --resume, replace the result with --force, or "
                 "choose another folder with --out"
               : "choose another folder with --out, or replace it with --force");
  const std::vector<std::string> others = foreign_files(target);
  if (!others.empty())
    refuse(fmt::format(
               "holds, besides a result, files that Mahlwerk did not write ({}{}), so it is not "
               "changed",
               others.front(), others.size() > 1 ? " and more" : ""),
           "move those files away, or choose another folder with --out");
  if (FileLock::held(target / "campaign.lock")) throw in_use_error(target);
}

/// The folder as an absolute path without "..". Links are followed as far as the path exists.
fs::path resolved(const fs::path& target) {
  if (target.empty())
    throw InputError(
        Fault{"--out", "the name of the result folder is empty", "give a folder", "cannot-write"});
  fs::path path = fs::weakly_canonical(fs::absolute(target));
  if (!path.has_filename()) path = path.parent_path();
  return path;
}

/// Prefix of the name of a hidden folder beside the target: ".NAME.partial-".
std::string hidden(const fs::path& target, std::string_view what) {
  return fmt::format(".{}.{}-", target.filename().string(), what);
}

fs::path sibling(const fs::path& target, std::string_view what) {
  return target.parent_path() / (hidden(target, what) + std::to_string(own_process_id()));
}

/// Whether `number` is the id of another living process, or not a number.
bool is_other_process(std::string_view number) {
  int process = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), process);
  if (read.ec != std::errc{} || read.ptr != number.data() + number.size() || process <= 0)
    return true;
  return process != own_process_id() && process_exists(process);
}

enum class Leftovers { partial, all };

/// Removes the hidden folders that killed runs left beside the target; this process holds the lock
/// of the target's name. A result whose process was killed before it was put in place goes only
/// once another one is there; one that could not be put in place (keep_complete()) stays.
void remove_leftovers(const fs::path& target, Leftovers which) {
  if (target.parent_path().filename() == campaign_runs) return;  // the campaign removes them
  const std::string partial = hidden(target, "partial"), replaced = hidden(target, "replaced");
  std::vector<fs::path> remains;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), none)) {
    const std::string name = entry.path().filename().string();
    const auto remaining = [&](const std::string& before) {
      return name.starts_with(before) &&
             !is_other_process(std::string_view(name).substr(before.size()));
    };
    if ((remaining(partial) && (which == Leftovers::all || !listed_files(entry.path()))) ||
        (remaining(replaced) && fs::exists(target) && foreign_files(entry.path()).empty()))
      remains.push_back(entry.path());
  }
  for (const fs::path& one : remains) fs::remove_all(one, none);
}

/// Writes or, with mode "ab", appends to the file; returns 0 or the errno of the first failure.
/// Without a buffer, so that a text is one write: lines that several processes append stay whole.
int write_bytes(const fs::path& file, std::string_view text, const char* mode = "wb") {
  std::FILE* out = std::fopen(file.c_str(), mode);
  if (out == nullptr) return errno;
  std::setvbuf(out, nullptr, _IONBF, 0);
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
            "free some space or correct the permissions, or choose another folder with --out",
            "cannot-write"});
}

Folder::Folder(const fs::path& target, bool force) : force_(force) {
  try {
    target_ = resolved(target);
    check_replaceable(target_, force);
    fs::create_directories(target_.parent_path());
    lock_.emplace(target_.parent_path() / fmt::format(".{}.lock", target_.filename().string()),
                  FileLock::Mode::exclusive, FileLock::AtRelease::remove_file);
    if (lock_->state() == FileLock::State::held_elsewhere) throw in_use_error(target_);
    check_replaceable(target_,
                      force);  // again: the previous holder of the lock may have written there
    if (lock_->state() == FileLock::State::held) remove_leftovers(target_, Leftovers::partial);
    staging_ = sibling(target_, "partial");
    while (listed_files(staging_))
      staging_ += "-";  // a complete result of a process with the same id
    fs::remove_all(staging_);
    fs::create_directory(staging_);
  } catch (const std::system_error& e) {
    throw cannot_write(target, e.code().message());
  }
}

Folder::~Folder() {
  std::error_code ignored;
  if (!done_) fs::remove_all(staging_, ignored);
}

fs::path Folder::file(std::string_view name) const {
  const fs::path path = staging_ / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error);
  if (error) throw cannot_write(target_ / name, error.message());
  return path;
}

void Folder::reserve() {
  constexpr std::size_t size = 4U << 20U;  // of a report with a replay, its tables and summary
  if (const int failed = reserve_space(staging_ / reserved, size); failed != 0)
    throw cannot_write(target_, fmt::format("{} ({} MB are needed for a result)",
                                            std::strerror(failed), size >> 20U));
}

void Folder::write(std::string_view name, std::string_view text) const {
  std::error_code none;
  fs::remove(staging_ / reserved, none);
  if (const int failed = write_bytes(file(name), text); failed != 0)
    throw cannot_write(target_ / name, std::strerror(failed));
}

void Folder::commit() {
  done_ = true;  // from here on the result is kept even on failure: it may have taken hours
  try {
    std::error_code none;
    fs::remove(staging_ / reserved, none);
    list_all_files(staging_);
    put_in_place();
    if (lock_->state() == FileLock::State::held) remove_leftovers(target_, Leftovers::all);
  } catch (const std::exception& e) {
    keep_complete();
    throw InputError(Fault{
        target_.string(), std::string("the result cannot be put in place: ") + e.what(),
        "it is complete in " + staging_.string() + "; move it where you want it", "cannot-write"});
  }
}

/// Renames the folder, so that no other process takes it for a partial result.
void Folder::keep_complete() {
  const fs::path kept = sibling(target_, "complete");
  std::error_code failed;
  fs::rename(staging_, kept, failed);
  if (!failed) staging_ = kept;
}

void Folder::put_in_place() const {
  check_replaceable(target_, force_);  // again: the target may have changed during the run
  if (!fs::exists(target_) || fs::is_empty(target_)) return fs::rename(staging_, target_);
  const fs::path old = sibling(target_, "replaced");
  std::error_code ignored;
  fs::rename(target_, old);
  try {
    fs::rename(staging_, target_);
  } catch (const fs::filesystem_error&) {
    fs::rename(old, target_, ignored);
    throw;
  }
  fs::remove_all(old, ignored);
}

void write_text(const fs::path& file, std::string_view text) {
  if (const int failed = write_bytes(file, text); failed != 0)
    throw cannot_write(file, std::strerror(failed));
}

void write_pieces(const fs::path& file,
                  const std::function<void(const std::function<void(std::string_view)>&)>& give) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(file.c_str(), "wb"), std::fclose);
  if (!out) throw cannot_write(file, std::strerror(errno));
  give([&](std::string_view piece) {
    if (std::fwrite(piece.data(), 1, piece.size(), out.get()) != piece.size())
      throw cannot_write(file, std::strerror(errno));
  });
  if (std::fflush(out.get()) != 0) throw cannot_write(file, std::strerror(errno));
  if (std::fclose(out.release()) != 0) throw cannot_write(file, std::strerror(errno));
}

void write_whole(const fs::path& name, const std::function<void(const fs::path&)>& write) {
  const HeldSignals held;  // a part of the file would stay
  std::error_code none;
  const fs::path file = fs::is_symlink(name, none) ? fs::weakly_canonical(name, none) : name;
  if (fs::exists(file, none) && !fs::is_regular_file(file, none)) return write(file);  // a device
  fs::path aside = file.string() + ".part";
  for (int i = 1; fs::exists(fs::symlink_status(aside, none)) && !fs::is_regular_file(aside, none);
       ++i)
    aside = fmt::format("{}.part-{}", file.string(), i);
  try {
    write(aside);
    std::error_code failed;
    fs::rename(aside, file, failed);
    if (failed) throw cannot_write(file, failed.message());
  } catch (...) {
    fs::remove(aside, none);
    throw;
  }
}

void write_whole(const fs::path& file, std::string_view text) {
  write_whole(file, [&](const fs::path& aside) {
    if (const int failed = write_bytes(aside, text); failed != 0)
      throw cannot_write(file, std::strerror(failed));
  });
}

void append_text(const fs::path& file, std::string_view text) {
  if (const int failed = write_bytes(file, text, "ab"); failed != 0)
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
