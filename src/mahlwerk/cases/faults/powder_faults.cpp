// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Powder that does not fit its jar.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"

namespace mahlwerk::cases {

void bad_powder(const Case& c, std::vector<Fault>& found) {
  if (!c.powder || !c.powder->density || c.powder->grain_size) return;  // grains are ball sets
  const double powder = c.powder->mass / *c.powder->density, balls = balls_volume(sets_at_start(c));
  const double jar = jar_volume(c.jar);
  if (!(powder + balls > jar)) return;
  found.push_back(
      {location_of(c, "powder.mass"),
       fmt::format("the powder's solid ({}) and the balls ({}) are more than the jar "
                   "holds ({})",
                   show_rounded(powder, "m3"), show_rounded(balls, "m3"), show_rounded(jar, "m3")),
       "give less powder, fewer balls or a larger jar", "powder-too-much"});
}

}  // namespace mahlwerk::cases
