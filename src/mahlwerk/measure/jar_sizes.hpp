// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "mahlwerk/measure/finding.hpp"

// Sizes of a jar from a caliper, a balance and water.
namespace mahlwerk::measure {

/// Repeated readings, in any number; NaN are left out.
struct JarReadings {
  std::vector<double> diameter;     ///< [m] inner
  std::vector<double> depth;        ///< [m] inner length, with the lid's share, from end to end
  std::vector<double> water;        ///< [kg] of the water that fills it
  std::vector<double> empty, full;  ///< [kg] of the jar; in place of `water`
  std::vector<double> wall;         ///< [m] thickness
};

/// 95 % half-widths of the instruments.
struct JarInstruments {
  double caliper = 1e-4;  ///< [m]
  double balance = 1e-4;  ///< [kg]
};

/// Shapes whose sizes follow from these readings.
constexpr std::array<std::string_view, 4> measured_shapes{"capsule", "cylinder", "rounded-cylinder",
                                                          "sphere"};

struct JarFound {
  Findings sizes;              ///< jar.diameter, jar.height, jar.fillet, jar.wall; mass if weighed
  observe::Estimate volume;    ///< [m3] by water; NaN without it
  observe::Estimate by_sizes;  ///< [m3]
};

/// The sizes of a shape of `measured_shapes` (mea.12), with the volume by water of 15 to 25 degC.
/// The fillet of a rounded cylinder follows from the volume. Throws InputError if a reading that
/// the shape needs is missing, if sizes contradict each other, or if the volume by water differs
/// from that of the sizes by more than a tenth.
JarFound jar_sizes(std::string_view shape, const JarReadings& readings,
                   const JarInstruments& instruments);

}  // namespace mahlwerk::measure
