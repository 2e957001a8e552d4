// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A hopper with grains whose floor has a hole, and what passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "crowd.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::flowing {

using Feed = scene::Flow::Feed;

/// Records collisions and passages.
class FlowObserver final : public scene::Observer {
 public:
  void collisions(std::span<const scene::Collision> finished) override {
    hits.insert(hits.end(), finished.begin(), finished.end());
  }
  void passages(std::span<const scene::Passage> passed) override {
    all.insert(all.end(), passed.begin(), passed.end());
  }
  double count(bool entered) const {
    return static_cast<double>(std::ranges::count(all, entered ? 1 : 0, &scene::Passage::entered));
  }
  double mass(bool entered) const {
    double sum = 0;
    for (const scene::Passage& p : all)
      if (p.entered == (entered ? 1 : 0)) sum += p.mass;
    return sum;
  }
  std::vector<scene::Collision> hits;
  std::vector<scene::Passage> all;
};

/// A cylinder of 40 mm by 60 mm with a ring as its floor, 10 mm above the lower end.
inline scene::Chamber hopper(double hole,
                             const kinematics::AnyMotion& motion = kinematics::Still{}) {
  scene::Chamber jar{geometry::Cylinder{0.04, 0.06}, motion, {}, {0, 0, -gravity}};
  scene::MachinePart floor;
  floor.solid = geometry::AnySolid(geometry::RingSolid{0.044, hole, 0.004});
  floor.position = {0, 0, -0.018};
  jar.parts.push_back(floor);
  return jar;
}

/// What leaves through the hole enters below the lid.
inline scene::Flow flow(Feed feed) {
  return {.outlet = {0, 0, -0.022},
          .outlet_normal = {0, 0, -1},
          .feed = feed,
          .axes = {},
          .inlet = {0, 0, 0.022},
          .inlet_size = {0.02, 0.02, 0.01},
          .rate = 300,
          .seed = 1};
}

inline std::vector<scene::Ball> grains(int count, double radius) {
  std::vector<scene::Ball> balls;
  for (const scene::Ball& b : lattice_of(40000, 2.1 * radius, {radius, 0.8 * radius}, 0.1))
    if (static_cast<int>(balls.size()) < count && std::hypot(b.position.x, b.position.y) < 0.018 &&
        b.position.z > -0.014 && b.position.z < 0.028)
      balls.push_back(b);
  for (std::size_t i = 0; i < balls.size(); ++i) balls[i].kind = 0;
  EXPECT_EQ(static_cast<int>(balls.size()), count);
  return balls;
}

inline std::unique_ptr<scene::Engine> engine(const scene::Chamber& jar,
                                             const std::vector<scene::Ball>& balls,
                                             const std::optional<scene::Flow>& flow,
                                             int threads = 1) {
  soft::Settings rules{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), 1e-5, true};
  rules.few_ball_limit = 0;
  rules.threads = threads;
  rules.max_initial_overlap = 0.5;
  rules.flow = flow;
  contact::Pair pair = pair_of({2e6, 0.3}, {2e6, 0.3}, 0.6, 0.4);
  pair.rolling_friction = 0.02;
  return soft::make_engine(jar, balls, rules,
                           contact::PairTable(1, soft::moving_wall(jar)->faces(), pair), 0);
}

inline double mass_of(const std::vector<scene::Ball>& balls, bool outside) {
  double sum = 0;
  for (const scene::Ball& b : balls) sum += b.outside == outside ? b.mass() : 0;
  return sum;
}

/// The worst residual of the energy over the dissipated, without flow: the error of the time step.
inline double error_without_flow(const scene::Chamber& jar) {
  const auto run = engine(jar, grains(400, 0.001), std::nullopt);
  const double first = run->energy_balance().residual();
  FlowObserver seen;
  double worst = 0;
  for (int k = 1; k <= 20; ++k) {
    run->advance(0.01 * k, seen);
    worst = max_or_nan(worst, std::abs(run->energy_balance().residual() - first));
  }
  return worst / run->energy_balance().lost();
}

}  // namespace mahlwerk::tests::flowing
