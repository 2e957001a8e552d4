// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <span>
#include <vector>

#include "benchmarks.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "peers.hpp"

namespace mahlwerk::bench {
namespace {

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

std::unique_ptr<scene::Engine> engine(const Start& start) {
  const PlanetaryCase& c = planetary_case;
  const scene::Chamber mill{c.vial, c.mill, {}, {0, 0, -c.gravity}};
  const contact::ElasticConstants steel{c.youngs_modulus, c.poissons_ratio};
  const contact::Pair pair{.modulus = contact::effective_modulus(steel, steel),
                           .shear_modulus = contact::effective_shear_modulus(steel, steel),
                           .restitution = c.restitution,
                           .friction = c.friction,
                           .rolling_friction = c.rolling_friction};
  soft::Settings rules;
  rules.time_step = c.step;
  rules.model.rolling = contact::Rolling::epsd;  // nearest to the models of the peers
  return soft::make_engine(mill, {start.begin(), start.end()}, rules,
                           {1, geometry::Cylinder::faces, pair});
}

}  // namespace

std::optional<MahlwerkSpeed> mahlwerk_speed(const Start& start, int steps) {
  const auto run = engine(start);
  NullObserver observer;
  const double began = cpu_seconds();
  run->advance(steps * planetary_case.step, observer);
  return MahlwerkSpeed{static_cast<double>(start.size()) * steps / (cpu_seconds() - began)};
}

std::optional<Physics> mahlwerk_physics(const Start& start) {
  const auto run = engine(start);
  NullObserver observer;
  const PlanetaryCase& c = planetary_case;
  Analysis analysis(c.from, c.to);
  scene::EnergyBalance first, last;
  const auto samples = static_cast<int>(c.to / c.between_samples + 0.5);
  for (int n = 0; n <= samples; ++n) {
    const double time = n * c.between_samples;
    run->advance(time, observer);
    last = run->energy_balance();
    if (time <= c.from) first = last;
    Sample sample;
    sample.time = time;
    sample.balls.resize(start.size());
    const std::vector<scene::Ball> balls = run->balls();
    for (std::size_t b = 0; b < balls.size(); ++b) {
      sample.balls[b].position = balls[b].position;
      sample.balls[b].velocity = balls[b].velocity;
      sample.balls[b].spin = balls[b].spin;
    }
    analysis.add_sample(sample);
  }
  Physics found = analysis.physics();
  found.power = (last.wall_work - first.wall_work) / (last.time - first.time);
  return found;
}

}  // namespace mahlwerk::bench
