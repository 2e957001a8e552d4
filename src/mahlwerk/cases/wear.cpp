// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/wear.hpp"

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/wear.hpp"

namespace mahlwerk::cases {

double worn_volume(const Wear& wear, const ContactSums& sums, double vickers) {
  const double hardness = powder::hardness(vickers);
  switch (wear.model) {
    case Wear::Model::archard:
      return powder::archard(wear.coefficient, sums.slid, hardness);
    case Wear::Model::finnie:
      return wear.coefficient * sums.erosion / hardness;  // (wea.4)
    case Wear::Model::energy:
      break;
  }
  return wear.coefficient * sums.lost / hardness;  // (wea.8)
}

bool evolves(const Case& c) {
  const Wear* wear = c.parts.find<Wear>();
  return wear != nullptr && wear->evolve.has_value();
}

Case of_one_run(Case c) {
  if (!evolves(c)) return c;
  Wear wear = *c.parts.find<Wear>();
  wear = {.model = wear.model, .coefficient = wear.coefficient};
  c.parts.set(wear);
  return c;
}

}  // namespace mahlwerk::cases
