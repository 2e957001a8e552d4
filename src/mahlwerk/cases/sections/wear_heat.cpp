// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [wear] and [heat]: what the mill takes off and how warm it gets.
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// The numbers of [heat] besides its times.
constexpr auto heat_fields() {
  return std::array{
      Field<Heat>{"ambient", "K", &Heat::ambient, positive,
                  "temperature of the air, and of everything at the start", Heat().ambient,
                  "a room"},
      Field<Heat>{"cooling", "W/m2/K", &Heat::cooling, positive,
                  "heat from the jar's wall to the air, by area and kelvin", Heat().cooling,
                  "natural to mild forced convection of air, textbooks: 5-50; uncalibrated"},
      Field<Heat>{"ball_exchange", "W/m2/K", &Heat::ball_exchange, positive,
                  "heat from the balls to the jar, by area of the balls and kelvin",
                  Heat().ball_exchange,
                  "gas between balls in motion and the wall, 10-200 (hea.6); uncalibrated"},
      Field<Heat>{"share_in_balls", "", &Heat::share_in_balls, restitution_range,
                  "share of the lost power that heats the balls, the rest the jar",
                  Heat().share_in_balls, "contacts of bodies alike; uncalibrated"}};
}
/// Times of [heat]; without any of them and without cycles the mill mills for an hour.
constexpr Field<Heat> cycle_milling{"milling",
                                    "s",
                                    &Heat::milling,
                                    positive,
                                    "how long the mill mills in each cycle",
                                    Heat().milling,
                                    "an hour without a pause"};
constexpr Field<Heat> pause_time{
    "pause", "s", &Heat::pause, not_negative, "rest after each milling", Heat().pause, "none"};
constexpr std::int64_t most_cycles = 10'000;

}  // namespace

void describe(Walk& w, Wear& wear) {
  w.word({"model", {"archard", "finnie"}, "archard", "by force and way slid"}, wear.model);
  const bool finnie = wear.model == Wear::Model::finnie;
  w.number(
      Wanted("coefficient", "", positive, "volume worn over force times way over hardness")
          .with_default(Wear().coefficient,
                        finnie ? "as much as Archard's at grazing impacts (wea.5); uncalibrated"
                               : "uncalibrated, 1e-6 to 1e-2"),
      wear.coefficient);
}

/// Who says one of the times of a cycle must say all.
void describe(Walk& w, Heat& heat) {
  const bool pauses = w.gives("pause"), repeats = w.gives("cycles");
  Wanted milling(cycle_milling);
  if (pauses || repeats) milling.standard.reset();
  w.number(milling, heat.milling);
  w.number(Wanted(pause_time), heat.pause);
  Whole cycles{"cycles",    1,
               most_cycles, "how often the mill mills and rests",
               1,           "without a pause there is one"};
  if (pauses) cycles.standard.reset();
  w.whole(cycles, heat.cycles);
  w.fields(heat, heat_fields());
}

}  // namespace mahlwerk::cases
