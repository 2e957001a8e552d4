// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "same_bits.hpp"
#include "soft.hpp"

// Runs of the soft engine with few balls, and the comparison of their results bit by bit.
namespace mahlwerk::tests {

using contact::AdamsImpact;
using contact::HertzMindlin;
using contact::Jkr;
using contact::Rolling;
using contact::Sjkr;
using contact::WaltonBraun;
/// Makes a replicate.
using Make = std::function<std::unique_ptr<scene::Engine>(std::uint32_t replicate)>;

inline contact::Pair soft_pair(double e = 0.7) {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, e, 0.3);
  pair.rolling_friction = 0.02;
  pair.surface_energy = 0.05;
  pair.cohesion = 1e4;
  return pair;
}

/// `replicate` varies the velocities.
inline std::vector<scene::Ball> charge(int count, std::uint32_t replicate = 0) {
  Random random(9, replicate);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < count; ++i) {
    const Vec3 cell{i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0};
    balls.push_back({0.003 * (1 - 0.05 * (i % 3)), 7850, 0.0063 * cell,
                     random.uniform(0, 0.5) * random.direction(),
                     random.uniform(0, 30) * random.direction()});
  }
  return balls;
}

inline Make made(const scene::Chamber& mill, int count, const contact::AnyLaw& law, Rolling rolling,
                 bool hop) {
  return [=](std::uint32_t replicate) {
    return soft_engine(mill, charge(count, replicate), of_law(law, rolling), soft_pair(), 2e-6, hop,
                       0.37);
  };
}

inline Make made_slipping(const scene::Chamber& mill, int count) {
  return [=](std::uint32_t replicate) {
    contact::ContactModel model = of_law(HertzMindlin{}, Rolling::cdt);
    model.partial_slip = true;
    model.twisting = contact::Twisting::marshall;
    return soft_engine(mill, charge(count, replicate), model, soft_pair(), 2e-6, false, 0.37);
  };
}

/// Runs of different kinds, with free-flight skips (hops) and without.
inline std::vector<std::pair<std::string, Make>> runs() {
  const Vec3 down{0, 0, -gravity};
  const scene::Chamber capsule{geometry::Capsule{0.04, 0.02}, shaken(20, 0.015), {}, down};
  const scene::Chamber planet{
      geometry::Box{0.03, 0.03, 0.03}, kinematics::Planetary{0.07, 40, -2}, {}, down};
  const scene::Chamber drum{geometry::Cylinder{0.04, 0.03}, kinematics::Tumbling{12},
                            scene::mounted_along({1, 0, 0}), down};
  const scene::Chamber open_drum{geometry::PeriodicCylinder{0.04, 0.03}, kinematics::Tumbling{12},
                                 scene::mounted_along({1, 0, 0}), down};
  return {
      {"two balls that hop", made(capsule, 2, HertzMindlin{}, Rolling::cdt, true)},
      {"five balls", made(planet, 5, WaltonBraun{}, Rolling::epsd, false)},
      {"five that stick", made(drum, 5, Jkr{}, Rolling::viscous, true)},
      {"twenty balls", made(capsule, 20, AdamsImpact{}, Rolling::epsd, true)},
      {"twenty in a drum", made(drum, 20, Sjkr{}, Rolling::cdt, true)},
      {"twenty in a drum without ends", made(open_drum, 20, HertzMindlin{}, Rolling::cdt, true)},
      {"five with partial slip and twisting", made_slipping(planet, 5)},
      {"five of own spins", made(planet, 5, HertzMindlin{}, Rolling::own_spin, false)},
  };
}

}  // namespace mahlwerk::tests
