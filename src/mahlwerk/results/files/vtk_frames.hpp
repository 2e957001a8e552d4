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

/// frames-1.pvd, the times of all frames, and beside it a folder frames-1 with the balls and the
/// jar of each, as VTK's PolyData in XML: ParaView opens the first, any program with VTK the
/// others. The list is whole XML after every frame.
class VtkFrames {
 public:
  /// A jar that looks still is written once.
  VtkFrames(std::filesystem::path list, const geometry::AnyShape& shape, bool still);
  void add(const Frame& frame);

 private:
  std::string jar_text(const Frame& frame) const;
  void write(const std::string& name, std::string_view text) const;
  void end_list(std::string_view entries);

  std::filesystem::path path_, folder_;
  OpenFile list_;
  long written_ = 0;  // bytes of the list but for its end
  Indirect<geometry::AnyShape> shape_;
  bool still_;
  std::vector<JarMesh> jar_;
  std::size_t frames_ = 0;
};

}  // namespace mahlwerk::results
