// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/soft_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/device_faults.hpp"
#include "mahlwerk/campaign/run/memory.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::campaign {
namespace {

/// Overlap, relative to the radius, above which balls pass through each other and through the wall.
constexpr double sinking = 1;

/// One ball of each size and set, for quantities that depend on sizes alone.
std::vector<scene::Ball> one_of_each(const cases::Case& mill_case) {
  std::vector<scene::Ball> balls;
  for (std::size_t i = 0; i < mill_case.balls.size(); ++i)
    for (const cases::SizeClass& size : mill_case.balls[i].sizes())
      balls.push_back({.radius = 0.5 * size.diameter,
                       .density = mill_case.balls[i].layers().mean_density(0.5 * size.diameter),
                       .position = {},
                       .velocity = {},
                       .spin = {},
                       .kind = static_cast<std::int32_t>(i),
                       .inertia_ratio = mill_case.balls[i].inertia_ratio(size.diameter)});
  if (mill_case.bed_breakage && !cases::coarse_grains(mill_case)) {
    balls.push_back(balls.back());
    balls.back().radius = 0.5 * cases::bed_breakage(mill_case).diameters().back();
  }
  return balls;
}

/// The largest speed with which a ball starts [m/s].
double largest_start_speed(const cases::Case& mill_case) {
  double most = mill_case.run.start_speed;
  for (const cases::BallSet& set : mill_case.balls)
    for (const Vec3& velocity : set.velocities) most = std::max(most, norm(velocity));
  return most;
}

double meeting_speed(const cases::Case& mill_case) {
  const double reach = geometry::reach(*mill_case.jar.shape);
  const auto most = kinematics::bounds(*mill_case.mill.motion);
  const double parts =
      geometry::rotor_tip_speed(*mill_case.jar.shape) + cases::part_speed(mill_case);
  const double wall = most.speed + most.spin * reach + parts + largest_start_speed(mill_case);
  constexpr double least = 0.01;  // m/s: a charge at rest needs a finite step, too
  return std::max(least, std::sqrt(wall * wall + 4 * mill_case.gravity * reach));
}

/// Calls `f` with each pair of balls, and of a ball and a face of the jar.
template <class F>
void for_each_pair(const contact::PairTable& pairs, const F& f) {
  for (int a = 0; a < pairs.kinds(); ++a) {
    for (int b = 0; b < pairs.kinds(); ++b) f(pairs.balls(a, b));
    for (int face = 0; face < pairs.faces(); ++face) f(pairs.wall(a, face));
  }
}

/// Steps in the shortest collision that the requested error needs, the most over all pairs. LAMMPS
/// does not correct springs and dampers for the step (dem.37, dem.45) and gets a fixed number.
double steps_per_collision(const cases::Case& mill_case, const contact::PairTable& pairs) {
  constexpr double of_lammps = 50;
  if (mill_case.run.engine == cases::EngineName::lammps) return of_lammps;
  double most = 0;
  for_each_pair(pairs, [&](const contact::Pair& pair) {
    most = std::max(most, soft::steps_per_collision(*mill_case.contact.model.law, pair.restitution,
                                                    mill_case.run.step_error));
  });
  return most;
}

/// What determines the length of the time step.
std::string reason(const cases::Case& mill_case, const SoftSettings& s) {
  if (mill_case.run.time_step) return "as given";
  const double fraction = mill_case.run.time_step_fraction;
  const double steps = steps_per_collision(mill_case, s.pairs);
  const double usual = s.steps.recommended(fraction, steps);
  if (usual == fraction * s.steps.rayleigh)
    return fmt::format("{:.4g} % of the Rayleigh time (run.time_step_fraction)", 100 * fraction);
  if (usual == s.steps.dashpot / 5)
    return "a fifth of the time in which the damper of a contact stops a ball";
  return fmt::format("{:.0f} steps in {}", steps,
                     contact::shortest_time_name(*mill_case.contact.model.law));
}

/// Error of the shortest collision due to the time step, in words.
std::string error_note(const cases::Case& mill_case, const SoftSettings& s) {
  const soft::StepError e = step_error(mill_case, s, s.speed);
  return fmt::format(
      "With this step, the shortest collisions are off by at most about {} % of their rebound "
      "speed, {} % of their tangential speed and {} % of their spin on average, a single one by at "
      "most {} %.",
      two_digits(100 * e.rebound), two_digits(100 * e.tangential), two_digits(100 * e.spin),
      two_digits(100 * e.single));
}

soft::TimeSteps time_steps(const cases::Case& mill_case, const contact::PairTable& pairs,
                           double speed) {
  return soft::time_steps(one_of_each(mill_case), *mill_case.contact.model.law, pairs, speed,
                          mill_case.liquid ? std::optional(mill_case.liquid->model) : std::nullopt,
                          cases::body_shapes(mill_case));
}

/// [s] The recommended step, rounded down to two digits.
double usual_step(const cases::Case& mill_case, const contact::PairTable& pairs,
                  const soft::TimeSteps& steps) {
  const double step =
      steps.recommended(mill_case.run.time_step_fraction, steps_per_collision(mill_case, pairs));
  const double unit = math::pow(10, std::floor(math::log10(step)) - 1);
  return std::floor(step / unit * (1 + 1e-12)) * unit;
}

}  // namespace

SoftSettings soft_settings(const cases::Case& mill_case) {
  SoftSettings s{.rules = {}, .steps = {}, .pairs = cases::pair_table(mill_case)};
  s.rules.model = mill_case.contact.model;
  if (mill_case.liquid) s.rules.liquid = mill_case.liquid->model;
  if (mill_case.flow) s.rules.flow = cases::flow_in_jar_frame(mill_case);
  if (mill_case.bed_breakage) {
    s.rules.breakage = powder::grain_breakage(cases::bed_breakage(mill_case));
    s.rules.breakage_from_start = mill_case.run.settle == 0.0;
  }
  s.rules.shapes = cases::body_shapes(mill_case);
  s.rules.free_flight_skip = mill_case.run.free_flight_skip;
  if (mill_case.run.device == cases::DeviceName::gpu) s.rules.device = soft::graphics_card;
  // Balls that another run or the jar at rest has pressed together keep their overlaps.
  constexpr double pressed = 0.5;
  if (mill_case.run.start_from.states || mill_case.run.settle_at_rest > 0)
    s.rules.max_initial_overlap = pressed;
  s.speed = meeting_speed(mill_case);
  s.steps = time_steps(mill_case, s.pairs, s.speed);
  s.rules.time_step = mill_case.run.time_step.value_or(usual_step(mill_case, s.pairs, s.steps));
  return s;
}

double recommended_step(const cases::Case& mill_case, double speed) {
  const contact::PairTable pairs = cases::pair_table(mill_case);
  return usual_step(mill_case, pairs, time_steps(mill_case, pairs, speed));
}

soft::StepError step_error(const cases::Case& mill_case, double speed) {
  return step_error(mill_case, soft_settings(mill_case), speed);
}

soft::StepError step_error(const cases::Case& mill_case, const SoftSettings& s, double speed) {
  const contact::PairTable& pairs = s.pairs;
  const double steps = time_steps(mill_case, pairs, speed).contact / s.rules.time_step;
  soft::StepError worst;
  for_each_pair(pairs, [&](const contact::Pair& pair) {
    const soft::StepError e =
        soft::step_error(*mill_case.contact.model.law, pair.restitution, steps);
    worst = {std::max(worst.rebound, e.rebound), std::max(worst.tangential, e.tangential),
             std::max(worst.spin, e.spin), std::max(worst.single, e.single)};
  });
  return worst;
}

double soft_work(const cases::Case& mill_case) {
  std::int64_t spheres = 0;
  for (const cases::BallSet& set : mill_case.balls) spheres += set.count * set.body.count();
  return static_cast<double>(spheres) *
         (mill_case.run.settle_at_rest + cases::simulated_time(mill_case)) /
         soft_settings(mill_case).rules.time_step;
}

namespace {

/// Which card computes, and the memory it needs.
Notices card_notices(const cases::Case& mill_case) {
  if (mill_case.run.device != cases::DeviceName::gpu) return {};
  return {note("graphics-card",
               fmt::format("Computed by the graphics card {}, with about {} of its memory for each "
                           "replicate.",
                           soft::graphics_card_name(), bytes_in_words(card_memory(mill_case))))};
}

}  // namespace

Notices soft_notices(const cases::Case& mill_case) {
  const SoftSettings s = soft_settings(mill_case);
  const double step = s.rules.time_step;
  Notices notes{
      note("time-step",
           fmt::format("Time step {}, {}: {} % of the Rayleigh time and {} % of the shortest "
                       "collision ({}) "
                       "of balls that collide at {}, with an overlap of {} % of their radius.",
                       show_rounded(step, "s"), reason(mill_case, s),
                       two_digits(100 * step / s.steps.rayleigh),
                       two_digits(100 * step / s.steps.contact), show_rounded(s.steps.contact, "s"),
                       show_rounded(s.speed, "m/s", 2), two_digits(100 * s.steps.overlap))),
  };
  // LAMMPS has other errors: it corrects neither springs nor the first and last step of a contact.
  if (mill_case.run.engine != cases::EngineName::lammps)
    notes.push_back(note("step-error", error_note(mill_case, s)));
  append(notes, card_notices(mill_case));
  return notes;
}

Notices overlap_warnings(const cases::Case& mill_case) {
  constexpr double deep = results::soft_overlap;
  const SoftSettings s = soft_settings(mill_case);
  Notices notes;
  if (cases::has_bodies(mill_case) && s.steps.overlap > sinking)
    return {warning(
        "deep-overlap",
        fmt::format("Balls which collide at {} in line with their centres of mass would overlap by "
                    "{} of the radius of their smallest spheres, or of their rounding. A convex "
                    "body that is pressed in by its rounding stops the run. {}",
                    show_rounded(s.speed, "m/s", 2), two_digits(s.steps.overlap),
                    results::overlap_advice(mill_case)))};
  if (s.steps.overlap > deep)
    notes.push_back(
        warning("soft-contacts",
                fmt::format("Balls which collide at {} overlap by {} % of their "
                            "radius, more than {:.0f} %. {}",
                            show_rounded(s.speed, "m/s", 2), two_digits(100 * s.steps.overlap),
                            100 * deep, results::overlap_advice(mill_case))));
  return notes;
}

namespace {

/// run_faults() of a case without [uncertainty].
std::vector<Fault> replicate_faults(const cases::Case& mill_case) {
  std::vector<Fault> found = cases::engine_faults(mill_case);
  if (mill_case.run.engine == cases::EngineName::lammps)
    std::ranges::move(lammps::faults(mill_case), std::back_inserter(found));
  if (found.empty()) found = device_faults(mill_case);
  if (!cases::in_time_steps(mill_case.run.engine) || !found.empty()) return found;
  const SoftSettings s = soft_settings(mill_case);
  if (s.steps.overlap > sinking && !cases::has_bodies(mill_case))  // overlap_warnings()
    found.push_back({cases::location_of(mill_case, "contact.softening"),
                     fmt::format("contacts are so soft that balls, which may collide at {}, "
                                 "would overlap by {} of their radius",
                                 show_rounded(s.speed, "m/s", 2), two_digits(s.steps.overlap)),
                     "give a larger softening, modulus or stiffness, or a smaller cohesion",
                     "contacts-too-soft"});
  constexpr double max_steps = 1e13;  // a month or more; near the resolution of the simulated time
  const double time = mill_case.run.settle_at_rest + cases::simulated_time(mill_case);
  if (time > max_steps * s.rules.time_step)
    found.push_back(
        {cases::location_of(mill_case, mill_case.run.time_step ? "run.time_step" : "run.time"),
         fmt::format("{} in steps of {} is {:.2g} steps, more than {:.0g}", show_rounded(time, "s"),
                     show_rounded(s.rules.time_step, "s"), time / s.rules.time_step, max_steps),
         mill_case.run.time_step
             ? fmt::format(
                   "the usual step is {}: leave time_step, step_error and time_step_fraction out",
                   show_rounded(usual_step(mill_case, s.pairs, s.steps), "s"))
             : "a faster mill, a shorter run.time, or a shorter run.settle (\"auto\" waits for "
               "several periods of the mill)",
         "time-step-too-small"});
  if (s.rules.time_step > s.steps.limit)
    found.push_back(
        {cases::location_of(mill_case, "run.time_step"),
         fmt::format(
             "a time step of {} is unstable: at most {} for balls that may collide at {:.2g} "
             "m/s",
             show_rounded(s.rules.time_step, "s"), show_rounded(s.steps.limit, "s"), s.speed),
         fmt::format("write time_step = \"{}\" or less, or leave it out",
                     show(usual_step(mill_case, s.pairs, s.steps), "s")),
         "time-step-too-large"});
  return found;
}

/// Faults of several balls with engine = "auto": those of the soft engine that come from a value of
/// the case. Other reasons against the soft engine leave the event engine (choose_engine()).
std::vector<Fault> automatic_faults(cases::Case mill_case) {
  if (cases::balls_count(mill_case.balls) == 1) return {};
  mill_case.run.engine = cases::EngineName::soft;
  std::vector<Fault> found = replicate_faults(mill_case);
  return is_of_values(found) ? found : std::vector<Fault>();
}

}  // namespace

bool is_of_values(const std::vector<Fault>& soft) {
  return std::ranges::all_of(soft, [](const Fault& fault) {
    return fault.code == "time-step-too-large" || fault.code == "time-step-too-small" ||
           fault.code == "contacts-too-soft";
  });
}

std::vector<Fault> run_faults(const cases::Case& mill_case) {
  if (cases::evolves(mill_case))
    return {{cases::location_of(mill_case, "wear.evolve"),
             "a case whose shapes follow their wear is no single run",
             "follow it by `mahlwerk run` or Case.evolve_wear() of Python, or remove `evolve`",
             "no-wear-evolution"}};
  std::vector<Fault> found = replicate_faults(mill_case);
  if (found.empty() && mill_case.run.engine == cases::EngineName::automatic)
    found = automatic_faults(mill_case);
  for (std::size_t draw = 0; mill_case.uncertainty && draw < mill_case.uncertainty->count(); ++draw)
    for (Fault& fault : replicate_faults(cases::case_of_replicate(mill_case, draw)))
      if (std::ranges::none_of(found, [&](const Fault& f) { return f.code == fault.code; }))
        found.push_back(std::move(fault));
  return found;
}

}  // namespace mahlwerk::campaign
