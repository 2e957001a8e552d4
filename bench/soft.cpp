// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine alone: five balls in a planetary mill for each contact law, and the gain of
// free-flight skips (hops) in a vibrating vial, where a ball flies most of the time.
#include <fmt/format.h>

#include <span>

#include "benchmarks.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "peers.hpp"

namespace mahlwerk::bench {
namespace {

struct Count final : scene::Observer {
  std::int64_t above = 0;  // touches faster than 0.1 m/s
  void collisions(std::span<const scene::Collision> finished) override {
    for (const scene::Collision& c : finished) above += c.approach > 0.1;
  }
};

contact::Pair steel(double restitution, double friction, double rolling) {
  const contact::ElasticConstants e{208e9, 0.3};
  return {.modulus = contact::effective_modulus(e, e),
          .shear_modulus = contact::effective_shear_modulus(e, e),
          .restitution = restitution,
          .friction = friction,
          .rolling_friction = rolling};
}

double planetary_ns(const contact::AnyLaw& law) {
  const PlanetaryCase& c = planetary_case;
  const scene::Chamber mill{c.vial, c.mill, {}, {0, 0, -c.gravity}};
  const Start balls = start(0);
  soft::Settings rules{.model = {.law = law, .rolling = contact::Rolling::epsd}, .time_step = 1e-6};
  contact::Pair pair = steel(c.restitution, c.friction, c.rolling_friction);
  pair.surface_energy = 0.1;
  pair.cohesion = 1e5;
  pair.surface_tension = 0.07;
  pair.hardness = 6e9;
  std::vector<double> found;
  for (int i = 0; i < 5; ++i) {
    const auto engine = soft::make_engine(mill, {balls.begin(), balls.end()}, rules, {1, 3, pair});
    Count count;
    const double began = cpu_seconds();
    engine->advance(0.2, count);
    found.push_back((cpu_seconds() - began) / 0.2e6 * 1e9);
  }
  return median(found);
}

struct VibrationResult {
  double steps, seconds, rate;
};
/// The vial of Chen et al. 2016 at 10 Hz and 25 mm, e = 0.9, five simulated seconds.
VibrationResult run_vibration(bool free_flight_skip) {
  kinematics::Vibration motion;
  motion.frequency = 10;
  motion.amplitude = 0.025;
  const scene::Chamber mill{geometry::Capsule{0.012, 0.03621}, motion, {}, {0, 0, -9.81}};
  soft::Settings rules{.model = {.law = contact::HertzMindlin{}, .rolling = contact::Rolling::none},
                       .time_step = 5e-7,
                       .free_flight_skip = free_flight_skip};
  const auto engine = soft::make_engine(mill, {{0.004, 7850, {0.0005, 0, 0}, {}, {}}}, rules,
                                        {1, geometry::Capsule::faces, steel(0.9, 0.05, 0)});
  Count count;
  constexpr double time = 5;
  const double began = cpu_seconds();
  engine->advance(time, count);
  return {static_cast<double>(engine->energy_balance().time_steps), cpu_seconds() - began,
          static_cast<double>(count.above) / time};
}

}  // namespace

std::vector<Row> soft() {
  std::vector<Row> rows;
  for (const contact::AnyLaw& law : contact::all_laws())
    rows.push_back({"soft", "planetary mill, 5 balls of 15 mm, dt 1 us",
                    std::string(contact::name_of(law)), "ns_per_step", planetary_ns(law)});
  const VibrationResult with = run_vibration(true), without = run_vibration(false);
  const std::string vial = "vibrating vial, 1 ball, dt 0.5 us";
  rows.push_back({"soft", vial, "hops", "touches_above_0.1_m_s_per_second", with.rate});
  rows.push_back({"soft", vial, "every step", "touches_above_0.1_m_s_per_second", without.rate});
  rows.push_back({"soft", vial, "hops", "times_fewer_steps", without.steps / with.steps});
  rows.push_back({"soft", vial, "hops", "times_as_fast", without.seconds / with.seconds});
  return rows;
}

}  // namespace mahlwerk::bench
