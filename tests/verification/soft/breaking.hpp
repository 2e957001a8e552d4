// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Grains that break in a jar, and what they become.
#include <cmath>
#include <memory>
#include <vector>

#include "mahlwerk/powder/grain_breakage.hpp"
#include "mahlwerk/powder/models.hpp"
#include "soft.hpp"

namespace mahlwerk::tests::breaking {

/// Records collisions, and the mass of the powder by size class.
class SizeObserver final : public scene::Observer {
 public:
  void collisions(std::span<const scene::Collision> finished) override {
    hits.insert(hits.end(), finished.begin(), finished.end());
  }
  void size_changes(std::span<const scene::SizeChange> changes) override {
    for (const scene::SizeChange& change : changes) {
      const auto k = static_cast<std::size_t>(change.size_class);
      gained.resize(std::max(gained.size(), k + 1));
      gained[k] += change.mass;
      broken += change.broken;
      broken_by_class.resize(gained.size());
      broken_by_class[k] += change.broken;
    }
    all.insert(all.end(), changes.begin(), changes.end());
  }
  std::vector<scene::Collision> hits;
  std::vector<scene::SizeChange> all;
  std::vector<double> gained;  ///< [kg] by size class
  std::vector<std::int64_t> broken_by_class;
  std::int64_t broken = 0;

  std::int64_t broken_of(std::size_t size_class) const {
    return size_class < broken_by_class.size() ? broken_by_class[size_class] : 0;
  }
};

constexpr double radius = 1e-3, density = 2500;
inline const contact::ElasticConstants material{1e9, 0.3};

inline scene::Ball sphere(double size, const Vec3& position = {}, const Vec3& velocity = {},
                          const Vec3& spin = {}, std::int32_t kind = 0) {
  scene::Ball ball;
  ball.radius = size, ball.density = density, ball.kind = kind;
  ball.position = position, ball.velocity = velocity, ball.spin = spin;
  return ball;
}

/// Grains of 2 mm that break into spheres down to 0.5 mm.
inline powder::BedBreakage bed(const powder::AnyBreakage& breakage,
                               const powder::AnyFragments& fragments = powder::Halves{}) {
  powder::BedBreakage bed;
  bed.grain_size = 2 * radius;
  bed.smallest_fragment = 0.5e-3;
  bed.finest = 0.05e-3;
  bed.breakage = breakage;
  bed.fragments = fragments;
  return bed;
}

/// Adds balls that wait to become fragments: at least one of each size.
inline std::vector<scene::Ball> with_spare(std::vector<scene::Ball> balls,
                                           const powder::BedBreakage& bed, std::size_t spare) {
  const std::vector<double> diameters = bed.diameters();
  for (std::size_t k = 0; k < std::max(spare, diameters.size()); ++k) {
    scene::Ball ball = sphere(0.5 * diameters[std::min(k, diameters.size() - 1)]);
    ball.kind = bed.kind;
    ball.outside = true;
    balls.push_back(ball);
  }
  return balls;
}

inline std::unique_ptr<scene::Engine> engine(const scene::Chamber& jar,
                                             const std::vector<scene::Ball>& balls,
                                             const powder::BedBreakage& bed, double step,
                                             double restitution = 0.6, int threads = 1) {
  soft::Settings rules{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), step, true};
  rules.few_ball_limit = 0;
  rules.threads = threads;
  rules.breakage = powder::grain_breakage(bed);
  contact::Pair pair = pair_of(material, material, restitution, 0.4);
  pair.rolling_friction = 0.02;
  return soft::make_engine(jar, balls, rules,
                           contact::PairTable(1, geometry::faces(*jar.shape), pair), 0);
}

/// Distance of the grains of a lattice over their radius: fragments hardly reach the next one.
constexpr double apart = 8;

/// Grains above the floor of a box, apart from each other, that fall on it without gravity.
inline std::vector<scene::Ball> falling(int side, double speed) {
  std::vector<scene::Ball> balls;
  for (int i = 0; i < side * side; ++i) {
    const Vec3 cell{i % side - 0.5 * (side - 1), static_cast<double>(i / side) - 0.5 * (side - 1),
                    0};
    scene::Ball ball = sphere(radius, apart * radius * cell, {0, 0, -speed});
    ball.position.z = -0.1 + 1.05 * radius;
    balls.push_back(ball);
  }
  return balls;
}
inline scene::Chamber box_for(int side) {
  return {geometry::Box{apart * radius * (side + 1), apart * radius * (side + 1), 0.2},
          kinematics::Still{},
          {},
          {}};
}

}  // namespace mahlwerk::tests::breaking
