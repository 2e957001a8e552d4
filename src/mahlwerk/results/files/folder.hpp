// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/files/file_lock.hpp"

namespace mahlwerk::results {

/// Where, in a campaign's folder, the results of its runs are.
constexpr std::string_view campaign_runs = "runs";

/// A result folder in the making. Files are written aside, into a hidden folder beside the wanted
/// one, and appear all at once by `commit`, with a list of them (manifest.hpp). Until then nothing
/// that exists is touched; without `commit` nothing stays behind. The name is this process's alone
/// as long as the folder lives.
class Folder {
 public:
  /// Makes sure, before anything is computed, that the result can be written to `target`, and
  /// removes what starts that were killed left beside it. Throws InputError if it is a file, is not
  /// empty and `force` is off, holds what is not a result of ours, another process is at work on
  /// it, or its place cannot be written to.
  Folder(const std::filesystem::path& target, bool force);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& target() const { return target_; }  ///< where the result will be
  /// Where the file of this name is written now; folders in the name are made.
  std::filesystem::path file(std::string_view name) const;
  void write(std::string_view name, std::string_view text) const;

  /// Puts the folder in its place. What it replaces goes only once the new one is there. If that
  /// fails the result is kept where it was written, and the InputError says where.
  void commit();

 private:
  void put_in_place() const;
  void keep_complete();

  std::filesystem::path target_, staging_;
  std::optional<FileLock> lock_;
  bool force_, done_ = false;
};

/// That a file or folder cannot be written, and why.
InputError cannot_write(const std::filesystem::path& place, const std::string& why);

/// Writes a whole file; throws InputError with the reason if any byte could not be written.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Makes a folder and those above it, unless it is there. Throws InputError where it cannot.
void make_folder(const std::filesystem::path& place);

}  // namespace mahlwerk::results
