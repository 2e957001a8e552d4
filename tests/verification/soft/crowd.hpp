// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"

// Charges of many balls in moving jars, for tests of the soft engine's solvers.
namespace mahlwerk::tests {

inline contact::Pair some_pair() {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, 0.3);
  pair.rolling_friction = 0.02;
  pair.surface_energy = 0.05;
  pair.cohesion = 1e4;
  return pair;
}

/// Balls with the radii `sizes` [m] in turn, on a lattice of `pitch` [m] about the centre.
inline std::vector<scene::Ball> lattice_of(int count, double pitch,
                                           const std::vector<double>& sizes, double speed = 0.5) {
  Random random(5, 0);
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  std::vector<scene::Ball> balls;
  for (int i = 0; i < count; ++i) {
    const Vec3 cell{static_cast<double>(i % side), static_cast<double>(i / side % side),
                    static_cast<double>(i / side / side)};
    // One draw a statement: compilers evaluate the operands of a product in different orders.
    const Vec3 heading = random.direction();
    const Vec3 velocity = random.uniform(0, speed) * heading;
    const Vec3 axis = random.direction();
    const Vec3 spin = random.uniform(0, 30) * axis;
    balls.push_back({sizes[static_cast<std::size_t>(i) % sizes.size()], 7850,
                     pitch * (cell - 0.5 * (side - 1) * Vec3{1, 1, 1}), velocity, spin});
  }
  return balls;
}

struct World {
  std::string name;
  scene::Chamber mill;
  std::vector<scene::Ball> balls;
  contact::ContactModel law;
  double step = 2e-6;
};

inline std::unique_ptr<scene::Engine> crowd(const World& w, int threads = 1, std::size_t few = 0) {
  const int faces = geometry::faces(*w.mill.shape);
  soft::Settings rules{w.law, w.step, false};
  rules.few_ball_limit = few;
  rules.threads = threads;
  return soft::make_engine(w.mill, w.balls, rules, contact::PairTable(1, faces, some_pair()), 0.37);
}

inline std::vector<World> worlds() {
  const Vec3 down{0, 0, -gravity};
  const scene::Chamber shaker{geometry::Capsule{0.04, 0.02}, shaken(20, 0.015), {}, down};
  const scene::Chamber planet{
      geometry::Box{0.03, 0.03, 0.03}, kinematics::Planetary{0.07, 40, -2}, {}, down};
  const scene::Chamber drum{geometry::Cylinder{0.04, 0.04}, kinematics::Tumbling{12},
                            scene::mounted_along({1, 0, 0}), down};
  const scene::Chamber gas{geometry::PeriodicBox{0.03, 0.03, 0.03}, kinematics::Still{}, {}, {}};
  const scene::Chamber open_drum{geometry::PeriodicCylinder{0.04, 0.03}, kinematics::Tumbling{12},
                                 scene::mounted_along({1, 0, 0}), down};
  auto curved = of_law(contact::AdamsImpact{}, contact::Rolling::epsd);
  curved.curved_walls = true;
  auto slipping = of_law(contact::HertzMindlin{}, contact::Rolling::cdt);
  slipping.partial_slip = true;
  slipping.twisting = contact::Twisting::marshall;
  return {
      {"shaken", shaker, lattice_of(60, 0.0055, {0.0025}),
       of_law(contact::HertzMindlin{}, contact::Rolling::cdt)},
      {"planetary, own spins", planet, lattice_of(60, 0.0042, {0.002, 0.001}),
       of_law(contact::HertzMindlin{}, contact::Rolling::own_spin)},
      {"planetary, two sizes", planet, lattice_of(60, 0.0042, {0.002, 0.001}),
       of_law(contact::WaltonBraun{}, contact::Rolling::epsd)},
      {"drum, sticking", drum, lattice_of(100, 0.0045, {0.002, 0.0015}),
       of_law(contact::Jkr{}, contact::Rolling::viscous)},
      {"drum, curved walls", drum, lattice_of(100, 0.0045, {0.002, 0.0005}), curved},
      {"drum without ends", open_drum, lattice_of(100, 0.0045, {0.002, 0.0015}, 2),
       of_law(contact::HertzMindlin{}, contact::Rolling::cdt)},
      {"drum, partial slip and twisting", drum, lattice_of(100, 0.0045, {0.002, 0.0015}), slipping},
      {"periodic", gas, lattice_of(64, 0.0074, {0.003, 0.0008}, 3),
       of_law(contact::LinearSpring{})},
  };
}

/// Balls enough for several chunks of ManyBodySolver, both of which compute a halo contact.
inline World drum_of(int count) {
  const scene::Chamber drum{geometry::Cylinder{0.06, 0.06},
                            kinematics::Tumbling{10},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -gravity}};
  return {"drum", drum, lattice_of(count, 0.0022, {0.001}, 0.2),
          of_law(contact::HertzMindlin{}, contact::Rolling::cdt), 2e-6};
}

}  // namespace mahlwerk::tests
