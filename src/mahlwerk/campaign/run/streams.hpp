// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/hdf5.hpp"

namespace mahlwerk::campaign {

/// Files that runs write while they proceed, for points that request them: all collisions, and
/// frames for replay. If one of them cannot be written, the runs go on without it.
class Streams {
 public:
  /// `version` of the program is written to the files. `on_failure` is called once, by any thread,
  /// when a file cannot be written.
  explicit Streams(std::string_view version, std::function<void(const Fault&)> on_failure = {})
      : version_(version), on_failure_(std::move(on_failure)) {}

  /// Adds the next point of the run; its files go into `folder`, with the prefix `below`.
  void add(const cases::Case& point, const results::Folder& folder, const std::string& below);

  std::unique_ptr<scene::Observer> records(std::size_t point, int replicate) const;
  std::unique_ptr<results::FrameFiles> frames(std::size_t point, int replicate) const;
  /// Lets a run of all added points write its files; the run must end before this object does.
  void attach(RunOptions& options) const;

  /// Closes the files. Call it before the folders' commit. Throws the first failure, after the
  /// removal of all files that are not whole.
  void close();

 private:
  class Records;
  struct Point {
    std::unique_ptr<results::CollisionFile> collisions;  // or null
    /// Makes the frame files of a replicate; empty: no frames.
    std::function<std::unique_ptr<results::FrameFiles>(int replicate)> frames;
    std::filesystem::path folder;  // of its files
  };
  bool failed() const;
  void keep(std::exception_ptr why) const;
  static void remove_files(const Point& point);

  std::string version_;
  std::function<void(const Fault&)> on_failure_;
  std::vector<Point> points_;
  mutable std::mutex mutex_;
  mutable std::exception_ptr failure_;
};

}  // namespace mahlwerk::campaign
