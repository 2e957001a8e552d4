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

/// What runs write while they go, for those of their points that ask for it: every collision, and
/// frames for replay.
class Streams {
 public:
  /// `version` of the program stands in the files.
  explicit Streams(std::string_view version) : version_(version) {}

  /// The next point of the run; its files go into `folder`, under `below`.
  void add(const cases::Case& point, const results::Folder& folder, const std::string& below);

  std::unique_ptr<scene::Observer> records(std::size_t point, int replicate) const;
  std::unique_ptr<results::FrameFiles> frames(std::size_t point, int replicate) const;
  /// Lets a run of all points added write its files; it must end before the streams do.
  void attach(RunOptions& options) const;

  /// Ends the files. Call it before the folders' commit.
  void close();

 private:
  struct Point {
    std::unique_ptr<results::CollisionFile> collisions;  // or null
    /// Makes the files of frames of a replicate; empty: none is kept.
    std::function<std::unique_ptr<results::FrameFiles>(int replicate)> frames;
  };
  std::string version_;
  std::vector<Point> points_;
};

}  // namespace mahlwerk::campaign
