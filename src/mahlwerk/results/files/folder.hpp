// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/file_lock.hpp"

namespace mahlwerk::results {

/// Folder of the runs' results inside a campaign's folder.
constexpr std::string_view campaign_runs = "runs";

/// Writes a result folder atomically. Files go to a hidden staging folder beside the target;
/// `commit` renames it to the target, with a list of its files (manifest.hpp). Existing files do
/// not change before `commit`; without `commit` nothing stays behind. This process holds a lock on
/// the target's name during the lifetime of the object.
class Folder {
 public:
  /// Checks that the result can be written to `target`, and removes staging folders of killed runs.
  /// Throws InputError if `target` is a file, if it is not empty and `force` is off, if it holds
  /// files that Mahlwerk did not write, if another process writes to it, or if its parent folder
  /// is not writable.
  Folder(const std::filesystem::path& target, bool force);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& target() const { return target_; }  ///< final path of the result
  /// Path of a file in the staging folder; folders in the name are created.
  std::filesystem::path file(std::string_view name) const;
  void write(std::string_view name, std::string_view text) const;

  /// Keeps space on the disk for the files that write() writes, until the first of them. Throws
  /// InputError if the disk is too full for a result.
  void reserve();

  /// Moves the staging folder to the target. A replaced result is removed only after that. On
  /// failure the result is kept, and the InputError says where.
  void commit();

 private:
  void put_in_place() const;
  void keep_complete();

  std::filesystem::path target_, staging_;
  std::optional<FileLock> lock_;
  bool force_, done_ = false;
};

/// The error that a file or folder cannot be written, with the reason.
InputError cannot_write(const std::filesystem::path& place, const std::string& why);

/// Writes a whole file. Throws InputError with the reason on failure.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Writes a file piece by piece, so that the whole need not be in memory: `give` passes the pieces
/// to its argument. Throws InputError with the reason on failure; a part stays.
void write_pieces(const std::filesystem::path& file,
                  const std::function<void(const std::function<void(std::string_view)>&)>& give);

/// Lets `write` write the file under another name, then renames it: nobody sees a part of it, and
/// no part stays. A device is written as it is. Throws InputError with the reason on failure.
void write_whole(const std::filesystem::path& file,
                 const std::function<void(const std::filesystem::path& aside)>& write);
/// The same with a text.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// Appends to a file, or creates it. Lines that several processes append stay whole.
void append_text(const std::filesystem::path& file, std::string_view text);

/// Creates a folder and its parents, unless it exists. Throws InputError on failure.
void make_folder(const std::filesystem::path& place);

}  // namespace mahlwerk::results
