// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/results/files/vtk_frames.hpp"
#include "mahlwerk/results/files/xyz_frames.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::results {

/// Writes the frames of one replicate's balls to the files that the case asks for
/// (docs/formats.md). Each frame is flushed to disk, so that the frames of a killed run remain.
class FrameFiles {
 public:
  /// `stem`: path of the files without their extension, as frames-1. This constructor and `add`
  /// throw InputError if the files cannot be written.
  FrameFiles(const std::filesystem::path& stem, const cases::Case& mill_case);

  /// The jar moves so; else as its case says, which does not know the speed that a motor reaches.
  void move_with(const kinematics::AnyMotion& motion);
  /// Adds a frame: the balls in the jar frame at `time` [s] since the start of the run, and the
  /// forces on them, if known (scene::Engine::forces).
  void add(double time, const std::vector<scene::Ball>& balls,
           const std::vector<Vec3>& forces = {});
  /// `keep` takes the first failure of add(), which then throws none and adds no more frames.
  void on_failure(std::function<void(std::exception_ptr)> keep) { keep_ = std::move(keep); }

 private:
  void write(const Frame& frame);

  std::function<void(std::exception_ptr)> keep_;
  bool failed_ = false;
  scene::Chamber chamber_;
  std::vector<scene::BodyShape> shapes_;  // by ball set; none: all are spheres
  std::optional<XyzFrames> xyz_;
  std::optional<VtkFrames> vtk_;
};

/// "frames-1" for `replicate` 0.
std::string frames_name(int replicate);

/// Times [s] of frames since the start of the run; none unless the case asks for frames.
class FrameTimes {
 public:
  explicit FrameTimes(const cases::Case& mill_case);
  void begin(double time) { begin_ = time; }  ///< [s] of the first frame, where counting begins
  double next() const;  ///< [s] of the next frame; infinite after the last and before begin()
  void advance() { ++done_; }

 private:
  double begin_, length_, every_;
  std::int64_t count_ = 0, done_ = 0;
};

}  // namespace mahlwerk::results
