// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/contact_records.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::soft {

Bent bent_wall(const MovingWall& jar, int face, const Vec3& position, double t, double radius,
               const SpeciesPair& pair, const contact::AnyLaw& law) {
  const auto [most, least] = jar.curvatures(face, position, t);
  const double own = 1 / radius;
  const auto flatter = [&](double curvature) { return 1 / std::max(own - curvature, 0.01 * own); };
  contact::Touching touching = pair.touching;
  touching.radius = std::sqrt(flatter(most) * flatter(least));
  const double arm = touching.pair.rolling_friction * touching.radius;
  return {std::visit([&](const auto& l) { return l.numbers(touching, pair.damping); }, law), arm,
          2.25 * arm * arm * pair.secant};
}

bool outlasts(double duration, const Beginning& began, const SpeciesPair& pair,
              const contact::AnyLaw& law) {
  constexpr double lasting = 5;
  const double free = std::visit(
      [&](const auto& l) { return l.shortest_time(pair.touching, std::max(began.approach, 1e-3)); },
      law);
  return duration > lasting * free;
}

}  // namespace mahlwerk::soft
