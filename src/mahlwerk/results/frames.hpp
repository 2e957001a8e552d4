// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::results {

/// frames-1.xyz: where the balls of one replicate are, frame after frame, in extended XYZ, which
/// OVITO and other viewers read (docs/formats.md). Every frame is in the file once it is added, so
/// that a run that is killed leaves what it had.
class FrameFile {
 public:
  /// Throws InputError, as `add` does, if the file cannot be written.
  FrameFile(std::filesystem::path file, const cases::Case& what);

  /// The balls in the jar frame at `time` [s] since the start of the run.
  void add(double time, const std::vector<scene::Ball>& balls);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  scene::Chamber chamber_;
  std::string cell_;  // keys of the box drawn around the jar
};

/// "frames-1.xyz" for `replicate` 0.
std::string frames_name(int replicate);

/// Times [s] since the start of the run at which frames are due; none unless the case asks for
/// them.
class FrameTimes {
 public:
  explicit FrameTimes(const cases::Case& what);
  double next() const;  ///< infinite after the last
  void go_on() { ++done_; }

 private:
  double settle_, end_, every_;
  std::int64_t count_ = 0, done_ = 0;
};

}  // namespace mahlwerk::results
