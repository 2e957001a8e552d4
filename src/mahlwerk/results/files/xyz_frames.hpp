// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/results/files/frame.hpp"

namespace mahlwerk::results {

/// Writes frames-1.xyz: consecutive frames in extended XYZ, which OVITO and other viewers read.
class XyzFrames {
 public:
  XyzFrames(std::filesystem::path file, const geometry::AnyShape& shape);
  void add(const Frame& frame);

 private:
  std::filesystem::path path_;
  OpenFile file_;
  Indirect<geometry::AnyShape> shape_;
  std::string cell_;  // keys of the cell around the jar, from the first frame on
};

}  // namespace mahlwerk::results
