// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <memory>
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

double mahlwerk_speed(std::span<const Start> starts, int steps) {
  std::vector<std::unique_ptr<scene::Engine>> engines;
  for (const Start& start : starts) engines.push_back(engine(start));
  NullObserver none;
  std::vector<scene::Engine*> all;
  for (const auto& one : engines) all.push_back(one.get());
  const std::vector<scene::Observer*> observers(engines.size(), &none);
  const double began = cpu_seconds();
  for (const std::exception_ptr& failure :
       soft::advance_together(all, steps * planetary_case.step, observers))
    if (failure) std::rethrow_exception(failure);
  const double balls = static_cast<double>(starts.size() * starts.front().size());
  return balls * steps / (cpu_seconds() - began);
}

Physics mahlwerk_physics(const Start& start) {
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
