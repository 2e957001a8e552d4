// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/hdf5.hpp"

namespace mahlwerk::campaign {

/// Files that runs write while they proceed, for points that request them: all collisions, and
/// frames for replay.
class Streams {
 public:
  /// `version` of the program is written to the files.
  explicit Streams(std::string_view version) : version_(version) {}

  /// Adds the next point of the run; its files go into `folder`, with the prefix `below`.
  void add(const cases::Case& point, const results::Folder& folder, const std::string& below);

  std::unique_ptr<scene::Observer> records(std::size_t point, int replicate) const;
  std::unique_ptr<results::FrameFiles> frames(std::size_t point, int replicate) const;
  /// Lets a run of all added points write its files; the run must end before this object does.
  void attach(RunOptions& options) const;

  /// Closes the files. Call it before the folders' commit.
  void close();

 private:
  struct Point {
    std::unique_ptr<results::CollisionFile> collisions;  // or null
    /// Makes the frame files of a replicate; empty: no frames.
    std::function<std::unique_ptr<results::FrameFiles>(int replicate)> frames;
  };
  std::string version_;
  std::vector<Point> points_;
};

}  // namespace mahlwerk::campaign
