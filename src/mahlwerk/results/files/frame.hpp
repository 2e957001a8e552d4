// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::results {

/// The balls and the jar at one instant, in the jar frame: axes of the laboratory, origin at the
/// jar's centre.
struct Frame {
  double time;                            ///< [s] since the start of the run
  const std::vector<scene::Ball>& balls;  ///< of bodies, each of their spheres
  const std::vector<Vec3>& forces;        ///< [N] contact force on each ball; empty where not known
  Vec3 centre;                            ///< [m] the jar's centre in the laboratory
  Rotation turn;                          ///< from the jar's own axes to the laboratory's
  /// Number of the body of each ball; empty where all are spheres.
  std::vector<std::int32_t> bodies = {};
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// The error that frames cannot be written to `file`, with the reason in errno.
InputError cannot_write_frames(const std::filesystem::path& file);

}  // namespace mahlwerk::results
