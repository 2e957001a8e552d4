// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/results/files/frame.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"

namespace mahlwerk::results {

/// Writes frames-1.pvd with the times of all frames, and a folder frames-1 with the balls and the
/// jar of each frame as VTK PolyData in XML. ParaView opens the .pvd file, any program with VTK the
/// others. The list is valid XML after every frame.
class VtkFrames {
 public:
  /// `still`: the jar does not move in its frame and is written once.
  VtkFrames(std::filesystem::path list, const scene::Chamber& mill, bool still);
  void move_with(const kinematics::AnyMotion& motion) { mill_.motion = motion; }
  void add(const Frame& frame);

 private:
  std::string jar_text(const Frame& frame) const;
  void write(const std::string& name, std::string_view text) const;
  void end_list(std::string_view entries);

  std::filesystem::path path_, folder_;
  OpenFile list_;
  long written_ = 0;  // bytes of the list without its end
  scene::Chamber mill_;
  bool still_;
  std::vector<JarMesh> jar_, parts_;
  std::size_t frames_ = 0;
};

}  // namespace mahlwerk::results
