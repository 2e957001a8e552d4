// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Mills that come to their speed from rest (kin.21), and states of motion in runs (obs.20).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::ramp_test {
namespace {

using cases::sample::catalogue;
using tests::states;

const std::string mixer = R"(title = "one ball in a mixer mill"
seed = 1
[mill]
kind = "arc-shaker"
frequency = "25 Hz"
arm = "136 mm"
swing = "3.8 deg"
[jar]
kind = "capsule"
diameter = "26.7 mm"
height = "26.9 mm"
[[balls]]
count = 1
diameter = "10 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.8
friction = 0.3
rolling_friction = 0.01
[run]
engine = "event"
time = "6 s"
replicates = 4
sensitivity = "off"
)";

const std::string planetary = R"(title = "three balls"
seed = 3
[mill]
kind = "planetary"
orbit_radius = "60 mm"
speed = "400 rpm"
ratio = -2
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
[[balls]]
count = 3
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.6
friction = 0.5
[run]
engine = "event"
time = "4 s"
replicates = 6
sensitivity = "off"
)";

using Set = std::vector<cases::Override>;

results::Outcome run_of(const std::string& text, const Set& set = {}, int threads = 1) {
  return run(cases::read_text(text, "case.toml", catalogue(), set), on(threads));
}
std::string fault_of(const std::string& text, const Set& set) {
  try {
    (void)cases::read_text(text, "case.toml", catalogue(), set);
  } catch (const InputError& error) {
    return error.faults().front().code;
  }
  return "";
}
const results::Quantity& of(const results::Outcome& outcome, const char* name) {
  return results::named(outcome.summary.quantities, name);
}

TEST(Ramp, counting_begins_after_it) {
  const Set set{{"run.start", "ramp"}, {"run.ramp_time", "0.5 s"}, {"run.time", "0.4 s"}};
  const results::Outcome outcome = run_of(mixer, set);
  for (const results::Replicate& r : outcome.replicates) EXPECT_GE(r.at_settled.time, 0.5);
  EXPECT_EQ(fault_of(mixer, {{"run.start", "ramp"}, {"run.settle", "0.1 s"}}), "bad-ramp");
}

TEST(Ramp, is_refused_where_nothing_speeds_up) {
  EXPECT_EQ(fault_of("[mill]\nkind = \"still\"\n" + mixer.substr(mixer.find("[jar]")),
                     {{"run.start", "ramp"}}),
            "bad-ramp");
  EXPECT_EQ(fault_of(mixer, {{"run.ramp_time", "1 s"}}), "too-much");
}

TEST(Ramp, of_a_planetary_mill_leads_to_the_power_of_the_running_mill) {
  for (const char* engine : {"event", "soft"}) {
    const bool soft = std::string(engine) == "soft";
    const Set common{
        {"run.engine", engine}, {"contact.softening", "1e-3"}, {"run.time", soft ? "1 s" : "4 s"}};
    Set with = common;
    with.insert(with.end(), {{"run.start", "ramp"}, {"run.ramp_time", "0.3 s"}});
    const results::Outcome plain = run_of(planetary, common, 2),
                           ramped = run_of(planetary, with, 2);
    const results::Quantity &a = of(plain, "drawn_power"), &b = of(ramped, "drawn_power");
    states(std::string("drawn power after a ramp, ") + engine + " [W]", b.value, a.value,
           1.5 * (a.ci95 + b.ci95), "both 95 % half-widths, half as wide again for two engines");
  }
}

TEST(Ramp, has_the_same_bits_on_two_threads) {
  const Set set{{"run.start", "ramp"}, {"run.ramp_time", "0.2 s"}, {"run.time", "1 s"}};
  const results::Outcome one = run_of(mixer, set, 1), two = run_of(mixer, set, 2);
  EXPECT_EQ(one.summary.by_replicate.size(), 4u);
  for (std::size_t k = 0; k < one.replicates.size(); ++k) {
    EXPECT_EQ(one.replicates[k].energy_balance.wall_work,
              two.replicates[k].energy_balance.wall_work);
    EXPECT_EQ(one.replicates[k].energy_balance.collisions,
              two.replicates[k].energy_balance.collisions);
  }
}

TEST(MotionStatesOfRuns, add_up_to_the_run) {
  const results::Outcome outcome = run_of(mixer);
  ASSERT_FALSE(outcome.summary.motion_states.empty());
  for (const results::Replicate& r : outcome.replicates) {
    double time = 0, lost = 0, hits = 0;
    for (const observe::MotionState state : observe::all_motion_states) {
      time += r.motion.in(state).time;
      lost += r.motion.in(state).lost;
      hits += r.motion.in(state).hits;
    }
    constexpr double unassigned = 4.0 / 25;  // [s] at most three periods and a part of one
    EXPECT_LE(time, r.time());
    states("time in all states [s]", time, r.time() - 0.5 * unassigned, 0.5 * unassigned, "obs.20");
    const double all = r.energy_balance.lost() - r.at_settled.lost();
    states("energy lost in all states over that of the run", lost / all, 1, 0.1,
           "four of 150 periods may be missing");
    states("hits in all states over those of the run",
           hits / static_cast<double>(r.tally.above.count), 1, 0.1,
           "four of 150 periods may be missing");
  }
}

TEST(MotionStatesOfRuns, of_a_ball_at_rest_in_a_level_mill_is_stationary_and_a_lean_starts_it) {
  const Set level{{"run.start", "ramp"}, {"run.time", "4 s"}};
  Set leaning = level;
  leaning.push_back({"mill.tilt", "3 deg"});
  const double stays = of(run_of(mixer, level), "stationary_share").value,
               started = of(run_of(mixer, leaning), "stationary_share").value;
  std::printf("    stationary for %.2f of the time in a level mill, %.2f in one that leans\n",
              stays, started);
  EXPECT_GT(stays, 0.5);
  EXPECT_LT(started, 0.2);
}

TEST(MotionStatesOfRuns, without_losses_differ_by_no_power) {
  const results::Outcome outcome =
      run_of(mixer, {{"contact.restitution", "1"}, {"contact.friction", "0"}, {"run.time", "2 s"}});
  ASSERT_GT(outcome.summary.motion_states.size(), 1u);
  for (const results::MotionStateSummary& s : outcome.summary.motion_states)
    EXPECT_EQ(s.power.mean, 0) << s.name;
}

TEST(MotionStatesOfRuns, that_differ_are_named_instead_of_their_mean_alone) {
  const results::Outcome outcome = run_of(mixer, {{"run.start", "ramp"}, {"run.replicates", "8"}});
  const auto found = std::ranges::find(outcome.notices, "motion-states", &Notice::code);
  ASSERT_NE(found, outcome.notices.end());
  EXPECT_NE(found->text.find("stationary for"), std::string::npos) << found->text;
  EXPECT_EQ(outcome.summary.regime.find("stationary"), 0u) << outcome.summary.regime;
}

}  // namespace
}  // namespace mahlwerk::campaign::ramp_test
