// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Warnings about valid values that are probably a mistake.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/kinematics/planetary.hpp"

namespace mahlwerk::cases {
namespace {

/// The densities of grinding media lie between light plastics and tungsten.
Notices densities(const Case& c) {
  constexpr double least = 500, most = 20000;  // [kg/m3]
  Notices found;
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    const double density = c.balls[i].density;
    if (density >= least && density <= most) continue;
    found.push_back(warning("unusual-density",
                            fmt::format("Balls of {} ({}) are {} than any solid medium: {}.",
                                        show_rounded(density, "kg/m3"), set_name(c, i),
                                        density < least ? "lighter" : "heavier",
                                        density < 50 ? "was g/cm3 meant? density = \"7.85 g/cm3\""
                                                     : "check the unit and the number")));
  }
  return found;
}

Notices ratios(const Case& c) {
  const auto* planetary = kinematics::as<kinematics::Planetary>(*c.mill.motion);
  if (planetary == nullptr || planetary->ratio <= 0) return {};
  return {warning(
      "unusual-ratio",
      fmt::format("The jar turns the same way as the disc, {} times as fast. Planetary "
                  "mills counter-rotate: was ratio = {} meant?",
                  show_rounded(planetary->ratio, ""), show_rounded(-planetary->ratio, "")))};
}

}  // namespace

Notices unusual_values(const Case& c) {
  Notices found = densities(c);
  append(found, ratios(c));
  return found;
}

}  // namespace mahlwerk::cases
