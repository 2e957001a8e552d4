// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Grains that break beside grains that do not: a box of 97 336, shaken up by their own speeds.
#include <memory>
#include <span>

#include "benchmarks.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/powder/grain_breakage.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "peers.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int side = 46, all = side * side * side;
constexpr double radius = 1e-3, density = 2500, time_step = 2e-7;
constexpr int steps_before = 100, steps = 1000;

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

scene::Ball grain(double size) {
  scene::Ball made;
  made.radius = size, made.density = density;
  return made;
}

/// Grains of 2 mm whose median strength is half as much again as `strength` [J/kg].
powder::BedBreakage bed(double strength, bool coarse) {
  powder::BedBreakage made;
  made.grain_size = 2 * radius, made.smallest_fragment = 0.5e-3, made.finest = 2e-6;
  made.coarse = coarse;
  made.feed = {.law = powder::Feed::Law::equal, .size = coarse ? 0.2e-3 : 2 * radius};
  made.breakage = powder::Tavares{strength, 1e-3, 1, 0.5, 4, 5, 0.6, 0.03};
  made.fragments = powder::AustinFragments{0.4, 0.8, 3};
  return made;
}

struct Cost {
  double ns = 0, broken = 0;  // of a grain and step; grains
};
/// Of processor time.
Cost cost(const powder::BedBreakage* rule) {
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < all; ++i) {
    const Vec3 cell{i % side - 0.5 * (side - 1), i / side % side - 0.5 * (side - 1),
                    i / side / side - 0.5 * (side - 1)};
    balls.push_back(grain(radius));
    balls.back().position = 2.1 * radius * cell;
    balls.back().velocity = random.uniform(0, 4) * random.direction();
  }
  soft::Settings rules{.model = {.law = contact::HertzMindlin{}, .rolling = contact::Rolling::cdt},
                       .time_step = time_step};
  if (rule != nullptr) {
    rules.breakage = powder::grain_breakage(*rule);
    const std::vector<double>& sizes = rules.breakage->diameters();
    for (std::size_t k = 0; !sizes.empty() && k < 3 * all; ++k) {
      balls.push_back(grain(0.5 * sizes[std::min(k, sizes.size() - 1)]));
      balls.back().outside = true;
    }
  }
  const contact::ElasticConstants material{1e9, 0.3};
  const contact::Pair pair{.modulus = contact::effective_modulus(material, material),
                           .shear_modulus = contact::effective_shear_modulus(material, material),
                           .restitution = 0.6,
                           .friction = 0.4,
                           .rolling_friction = 0};
  constexpr double size = 2.15 * radius * side;
  const scene::Chamber box{geometry::Box{size, size, size}, kinematics::Still{}, {}, {}};
  const auto run = soft::make_engine(box, balls, rules, contact::PairTable(1, 6, pair));
  NullObserver nobody;
  run->advance(steps_before * time_step, nobody);
  const double before = cpu_seconds();
  run->advance((steps_before + steps) * time_step, nobody);
  return {1e9 * (cpu_seconds() - before) / steps / all,
          static_cast<double>(run->energy_balance().broken_grains)};
}

}  // namespace

std::vector<Row> breakage() {
  const std::string what = "box of 97 336 grains of 2 mm, 1000 steps";
  std::vector<Row> rows;
  const double whole = cost(nullptr).ns;
  rows.push_back({"breakage", what, "no breakage", "ns_per_grain_and_step", whole});
  const auto add = [&](const char* name, const powder::BedBreakage& rule) {
    const Cost found = cost(&rule);
    rows.push_back({"breakage", what, name, "ns_per_grain_and_step", found.ns});
    rows.push_back({"breakage", what, name, "share_of_the_speed", whole / found.ns});
    rows.push_back({"breakage", what, name, "grains_that_broke", found.broken});
  };
  add("nothing breaks", bed(1000, false));
  add("spheres", bed(10, false));
  add("coarse grains", bed(1, true));
  return rows;
}

}  // namespace mahlwerk::bench
