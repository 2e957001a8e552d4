// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::results {

/// Writer of collisions.h5: every record of every replicate, as /replicate_1/collisions and so on.
/// Several threads may write replicates. Every function throws InputError on failure.
class CollisionFile {
 public:
  /// `case_text` (case.resolved.toml) and `version` become attributes of the file.
  CollisionFile(const std::filesystem::path& file, std::string_view case_text,
                std::string_view version);
  ~CollisionFile();
  CollisionFile(const CollisionFile&) = delete;
  CollisionFile& operator=(const CollisionFile&) = delete;

  /// `replicate` counts from 0.
  void append(int replicate, std::span<const scene::Collision> records);
  /// Closes the file and throws any pending error of a CollisionLog. Call it before the folder's
  /// commit.
  void close();

 private:
  friend class CollisionLog;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Observer that writes collisions of one replicate to a file, through a buffer. The destructor
/// writes the last records.
class CollisionLog final : public scene::Observer {
 public:
  CollisionLog(CollisionFile& file, int replicate);
  ~CollisionLog() override;
  CollisionLog(const CollisionLog&) = delete;
  CollisionLog& operator=(const CollisionLog&) = delete;
  void collisions(std::span<const scene::Collision> finished) override;

 private:
  void flush();

  CollisionFile& file_;
  int replicate_;
  std::vector<scene::Collision> buffer_;
};

/// Reads the records of one replicate, counted from 0. Throws InputError if there are none.
std::vector<scene::Collision> read_collisions(const std::filesystem::path& file, int replicate);

}  // namespace mahlwerk::results
