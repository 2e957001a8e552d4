// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/replicate_engine.hpp"

#include "mahlwerk/campaign/run/lammps_runs.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/run/start.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
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

std::unique_ptr<scene::Engine> make_engine(const cases::Case& mill_case, const scene::Chamber& mill,
                                           const std::vector<scene::Ball>& balls, int threads,
                                           const lammps::Launch& launch) {
  if (mill_case.run.engine == cases::EngineName::lammps)
    return lammps::make_engine(mill_case, mill, balls, lammps_steps(mill_case), launch);
  if (mill_case.run.engine == cases::EngineName::soft) {
    soft::Settings rules = soft_settings(mill_case).rules;
    rules.threads = threads;
    return soft::make_engine(mill, balls, rules, cases::pair_table(mill_case));
  }
  const contact::BounceTable bounces = cases::bounce_table(mill_case);
  event::Rules treatment = rules(mill_case.contact);
  treatment.threshold = mill_case.observe.threshold;
  if (mill_case.liquid) treatment.liquid = mill_case.liquid->model;
  cases::Case hard = mill_case;  // as the material is: its balls do not deform
  hard.contact.softening = 1;
  if (mill_case.contact.model.twisting != contact::Twisting::none)
    treatment.twisting = cases::pair_table(hard);
  if (balls.size() > 1) {
    if (mill_case.contact.lasting == cases::SustainedContactModel::tc)
      treatment.elastic = cases::pair_table(hard);
    return event::many_balls(mill, balls, treatment, bounces);
  }
  for (int face = 0; face < bounces.faces(); ++face)
    treatment.faces.push_back(bounces.wall(0, face));
  return event::one_ball(mill, balls.front(), treatment);
}

}  // namespace

std::vector<scene::Ball> start_of(const cases::Case& mill_case, int index, int threads,
                                  const std::atomic<bool>* stop) {
  // In the jar at rest the soft engine stands in for LAMMPS: the start is then the same each time.
  cases::Case at_rest = mill_case;
  if (at_rest.run.engine == cases::EngineName::lammps) at_rest.run.engine = cases::EngineName::soft;
  const auto make = [&](const scene::Chamber& mill, const std::vector<scene::Ball>& balls) {
    return make_engine(at_rest, mill, balls, threads, {});
  };
  std::vector<scene::Ball> balls = balls_at_start(mill_case, index, make, stop);
  if (mill_case.run.engine == cases::EngineName::lammps)
    make(cases::chamber(mill_case), balls);  // the soft engine refuses deep overlaps
  return balls;
}

std::unique_ptr<scene::Engine> engine(const cases::Case& mill_case, int index, int threads,
                                      const std::atomic<bool>* stop, const lammps::Launch& launch) {
  auto made = make_engine(mill_case, cases::chamber(mill_case),
                          start_of(mill_case, index, threads, stop), threads, launch);
  made->stop_on(stop);
  return made;
}

}  // namespace mahlwerk::campaign
