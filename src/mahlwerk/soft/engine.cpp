// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/engine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/body_species.hpp"
#include "mahlwerk/soft/few/replicate_batch.hpp"
#include "mahlwerk/soft/many/solver.hpp"
#include "mahlwerk/soft/on_device.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"

namespace mahlwerk::soft {

std::unique_ptr<scene::Engine> make_engine(const scene::Chamber& chamber,
                                           const std::vector<scene::Ball>& balls,
                                           const Settings& settings,
                                           const contact::PairTable& pairs, double start) {
  if (settings.device) return make_device_engine(chamber, balls, settings, pairs, start);
  auto jar = moving_wall(chamber);
  const bool bodies = !std::ranges::all_of(settings.shapes, &scene::BodyShape::is_sphere);
  if (balls.size() > settings.few_ball_limit || settings.flow || settings.breakage || bodies)
    return std::make_unique<ManyBodySolver>(std::move(jar), balls, settings, pairs, start);
  return std::make_unique<FewBodySolver>(std::move(jar), balls, settings, pairs, start);
}

std::vector<std::exception_ptr> advance_together(std::span<scene::Engine* const> engines,
                                                 double time,
                                                 std::span<scene::Observer* const> observers) {
  std::vector<FewBodySolver*> few;
  for (scene::Engine* engine : engines)
    if (auto* solver = dynamic_cast<FewBodySolver*>(engine)) few.push_back(solver);
  if (few.size() > 1 && few.size() == engines.size() && ReplicateBatch::fits(few))
    return ReplicateBatch(few).advance(time, observers);
  std::vector<std::exception_ptr> failures;
  for (std::size_t k = 0; k < engines.size(); ++k) try {
      engines[k]->advance(time, *observers[k]);
      failures.push_back(nullptr);
    } catch (...) {
      failures.push_back(std::current_exception());
    }
  return failures;
}

namespace {

/// Calls `f` with the effective values and the smaller radius of each pair of species, and of each
/// species and face of the jar.
template <class F>
void for_each_pair(const SpeciesPairs& pairs, int faces, const F& f) {
  const auto species = static_cast<std::int32_t>(pairs.all_species().size());
  for (std::int32_t a = 0; a < species; ++a) {
    for (std::int32_t b = 0; b < species; ++b)
      f(pairs.ball_pair_index(a, b), std::min(pairs.species(a).radius, pairs.species(b).radius));
    for (int face = 0; face < faces; ++face)
      f(pairs.wall_pair_index(a, face), pairs.species(a).radius);
  }
}

/// Largest overlap over radius of bodies that collide at `speed` [m/s].
double largest_overlap(const SpeciesPairs& pairs, int faces, const contact::AnyLaw& law,
                       double speed) {
  double most = 0;
  for_each_pair(pairs, faces, [&](std::int32_t pair, double radius) {
    const contact::EffectivePair& t = pairs[pair].effective;
    most = std::max(
        most, std::visit([&](const auto& l) { return l.largest_overlap(t, speed); }, law) / radius);
  });
  return most;
}

}  // namespace

double TimeSteps::recommended(double fraction, double steps_per_collision) const {
  return std::min({fraction * rayleigh, contact / steps_per_collision, dashpot / 5});
}

TimeSteps time_steps(const std::vector<scene::Ball>& balls, const contact::AnyLaw& law,
                     const contact::PairTable& pairs, double speed,
                     const std::optional<contact::Liquid>& liquid,
                     const std::vector<scene::BodyShape>& shapes) {
  const BodySpeciesTable bodies(balls, shapes);
  const std::vector<scene::Ball> contacts = bodies.lightest_contacts(balls);
  const SpeciesPairs species_pairs(contacts, pairs, law);
  const double overlap =
      bodies.empty() ? largest_overlap(species_pairs, pairs.faces(), law, speed)
                     : largest_overlap(SpeciesPairs(bodies.heaviest_contacts(balls), pairs, law),
                                       pairs.faces(), law, speed);
  TimeSteps found{geometry::never, geometry::never, geometry::never, geometry::never, overlap};
  for_each_pair(species_pairs, pairs.faces(), [&](std::int32_t pair, double) {
    const contact::EffectivePair& t = species_pairs[pair].effective;
    std::visit(
        [&](const auto& l) {
          found.contact = std::min(found.contact, l.shortest_time(t, speed));
          found.dashpot =
              std::min(found.dashpot, l.damper_time(t, species_pairs[pair].damping, speed));
        },
        law);
    if (liquid)  // in which it stops bodies that are about to touch
      found.dashpot =
          std::min(found.dashpot, t.mass * liquid->roughness / liquid->resistance(t.radius));
  });
  for (std::size_t b = 0; b < balls.size(); ++b) {
    const scene::Ball& ball = balls[b];
    const double radius =
        bodies.of_ball(b) < 0 ? ball.radius : std::ranges::min(bodies[bodies.of_ball(b)].radii);
    // The stiffest partner decides: its G* and E* give the highest wave speed (dem.28).
    for (int k = 0; k < pairs.kinds(); ++k) {
      const contact::Pair& pair = pairs.balls(ball.kind, k);
      const double q = pair.modulus / (2 * pair.shear_modulus);  // (2 - nu)/(1 - nu)
      const double nu = std::clamp((q - 2) / (q - 1), -0.99, 0.5);
      const double shear = 2 * (2 - nu) * pair.shear_modulus;
      found.rayleigh =
          std::min(found.rayleigh, std::numbers::pi * radius * std::sqrt(ball.density / shear) /
                                       (0.1631 * nu + 0.8766));
    }
  }
  if (liquid && liquid->flooded && liquid->drag)
    for (const Species& ball : species_pairs.all_species()) {
      const double reynolds = liquid->density * speed * 2 * ball.radius / liquid->viscosity;
      const double drag = 6 * std::numbers::pi * liquid->viscosity * ball.radius *
                          contact::drag_correction(reynolds);
      found.dashpot = std::min(found.dashpot, ball.mass / drag);
    }
  found.limit = std::min({found.rayleigh, 0.2 * found.contact, found.dashpot});
  return found;
}

}  // namespace mahlwerk::soft
