// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/results/files/vtk_frames.hpp"
#include "mahlwerk/results/files/xyz_frames.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::results {

/// Where the balls of one replicate are, frame after frame, in the files that the case asks for
/// (docs/formats.md). Every frame is on disk once it is added, so that a run that is killed leaves
/// what it had.
class FrameFiles {
 public:
  /// `stem` is the files' name without its ending: frames-1. Throws InputError, as `add` does, if
  /// they cannot be written.
  FrameFiles(const std::filesystem::path& stem, const cases::Case& what);

  /// The balls in the jar frame at `time` [s] since the start of the run, and the forces on them,
  /// if they are known (scene::Engine::forces).
  void add(double time, const std::vector<scene::Ball>& balls,
           const std::vector<Vec3>& forces = {});

 private:
  scene::Chamber chamber_;
  std::optional<XyzFrames> xyz_;
  std::optional<VtkFrames> vtk_;
};

/// "frames-1" for `replicate` 0.
std::string frames_name(int replicate);

/// Times [s] since the start of the run at which frames are due; none unless the case asks for
/// them.
class FrameTimes {
 public:
  explicit FrameTimes(const cases::Case& what);
  double next() const;  ///< infinite after the last
  void advance() { ++done_; }

 private:
  double settle_, end_, every_;
  std::int64_t count_ = 0, done_ = 0;
};

}  // namespace mahlwerk::results
