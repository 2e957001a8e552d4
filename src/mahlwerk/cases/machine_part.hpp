// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mahlwerk/cases/material.hpp"
#include "mahlwerk/scene/machine_part.hpp"

namespace mahlwerk::cases {

/// A part of the mill in the jar, [[parts]].
struct MachinePart {
  std::string name;         ///< by which results and contact rules call it: "parts.stirrer"
  scene::MachinePart body;  ///< its shape, place and motion
  std::string file, unit;   ///< of a mesh, as written; the file is relative to the case file
  /// [m], [1] Of a mesh whose file is a section: its length, and copies about its own axis.
  double length = 0;
  std::int64_t rows = 1;
  std::string motion_file;  ///< of a tabulated motion, as written
  std::string moves_with;   ///< name of the part whose motion it shares, or empty
  std::string material;     ///< name in the catalogue, or empty
  contact::ElasticConstants elastic = steel;
  Substance substance = hardened_steel;
  double density = hardened_steel_density;  ///< [kg/m3]
  /// [1] Of its contacts with all balls; none: those of [contact].
  std::optional<double> friction = std::nullopt, restitution = std::nullopt;
  bool operator==(const MachinePart&) const = default;
};

}  // namespace mahlwerk::cases
