// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/replicate_engine.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "mahlwerk/campaign/run/start.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/lammps/engine.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::campaign {
namespace {

event::Rules rules(const cases::Contact& c) {
  const auto sustained_mode =
      c.lasting == cases::SustainedContactModel::roll ? event::SustainedContactMode::roll
      : c.lasting == cases::SustainedContactModel::tc ? event::SustainedContactMode::tc
                                                      : event::SustainedContactMode::none;
  return {.bounce = c.rule,
          .faces = {},
          .sustained_friction =
              c.rule.tangential_restitution == 1 ? 0 : c.lasting_friction,  // (evt.15)
          .rolling_friction = c.rolling_friction,
          .sustained_mode = sustained_mode,
          .sustained_speed = c.lasting_speed,
          .contact_time = c.contact_time};
}

std::unique_ptr<scene::Engine> event_engine(const cases::Case& mill_case,
                                            const scene::Chamber& mill,
                                            const std::vector<scene::Ball>& balls) {
  const contact::BounceTable bounces = cases::bounce_table(mill_case);
  event::Rules treatment = rules(mill_case.contact);
  treatment.threshold = mill_case.observe.threshold;
  if (mill_case.liquid) treatment.liquid = mill_case.liquid->model;
  const auto hard_pairs = [&] {  // as the material is: its balls do not deform
    cases::Case hard = mill_case;
    hard.contact.softening = 1;
    return cases::pair_table(hard);
  };
  if (mill_case.contact.model.twisting != contact::Twisting::none)
    treatment.twisting = hard_pairs();
  if (balls.size() > 1) {
    if (mill_case.contact.lasting == cases::SustainedContactModel::tc)
      treatment.elastic = hard_pairs();
    return event::many_balls(mill, balls, treatment, bounces);
  }
  for (int face = 0; face < bounces.faces(); ++face)
    treatment.faces.push_back(bounces.wall(0, face));
  return event::one_ball(mill, balls.front(), treatment);
}

/// The engine of our own: in the jar at rest the soft one stands in for LAMMPS. `replicate`: whose
/// outlet is open; none: it is closed.
std::unique_ptr<scene::Engine> own_engine(const RunSetup& setup, const scene::Chamber& mill,
                                          const std::vector<scene::Ball>& balls, int threads,
                                          std::optional<int> replicate) {
  if (!setup.soft) return event_engine(*setup.mill_case, mill, balls);
  soft::Settings rules = setup.soft->rules;
  rules.threads = threads;
  if (rules.breakage && replicate)
    rules.breakage = powder::grain_breakage(cases::bed_breakage(*setup.mill_case, *replicate));
  if (!replicate)
    rules.flow.reset(), rules.breakage.reset();
  else if (rules.flow && std::ranges::any_of(balls, &scene::Ball::outside))
    rules.flow->seed += static_cast<std::uint64_t>(*replicate);  // an empty jar differs by its feed
  return soft::make_engine(mill, balls, rules, setup.soft->pairs);
}

}  // namespace

std::vector<scene::Ball> start_of(const RunSetup& setup, int index, int threads,
                                  const std::atomic<bool>* stop) {
  const auto make = [&](const scene::Chamber& mill, const std::vector<scene::Ball>& balls) {
    return own_engine(setup, mill, balls, threads, std::nullopt);
  };
  std::vector<scene::Ball> balls =
      balls_at_start(*setup.mill_case, setup.chamber, index, make, stop);
  if (setup.steps) make(setup.chamber, balls);  // the soft engine refuses deep overlaps
  return balls;
}

std::unique_ptr<scene::Engine> engine(const RunSetup& setup, int index, int threads,
                                      const std::atomic<bool>* stop, const lammps::Launch& launch) {
  std::vector<scene::Ball> balls = start_of(setup, index, threads, stop);
  if (setup.soft && setup.soft->rules.breakage) {
    const std::vector<scene::Ball> spare = cases::spare_grains(*setup.mill_case);
    balls.insert(balls.end(), spare.begin(), spare.end());
  }
  auto made = setup.steps ? lammps::make_engine(*setup.mill_case, setup.chamber, balls,
                                                *setup.steps, launch)
                          : own_engine(setup, setup.chamber, balls, threads, index);
  made->stop_on(stop);
  return made;
}

}  // namespace mahlwerk::campaign
