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

/// collisions.h5: every record of every replicate, as /replicate_1/collisions and so on; replicates
/// may be written from several threads. Every function throws InputError if the file cannot be
/// written.
class CollisionFile {
 public:
  /// `case_text` (case.resolved.toml) and `version` travel inside.
  CollisionFile(const std::filesystem::path& file, std::string_view case_text,
                std::string_view version);
  ~CollisionFile();
  CollisionFile(const CollisionFile&) = delete;
  CollisionFile& operator=(const CollisionFile&) = delete;

  /// `replicate` counts from 0.
  void append(int replicate, std::span<const scene::Collision> records);
  /// Ends the file; a failure nobody has heard of yet is thrown here. Call it before the folder's
  /// commit.
  void close();

 private:
  friend class CollisionLog;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Writes what it hears to one replicate of a file, in large pieces; the last when it is destroyed.
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

/// The records of one replicate, counted from 0. Throws InputError if they are not there.
std::vector<scene::Collision> read_collisions(const std::filesystem::path& file, int replicate);

}  // namespace mahlwerk::results
