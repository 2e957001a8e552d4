// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/soft_settings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/engine_notices.hpp"
#include "mahlwerk/campaign/run/step_check.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/step_error.hpp"
#include "unit/cases/sample.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::campaign::soft_settings_test {
namespace {

using namespace cases::sample;
using Overrides = std::vector<cases::Override>;

/// The planetary mill with the soft engine; these lines replace its restitution.
cases::Case soft_case(const std::string& lines, Overrides overrides = {}) {
  overrides.push_back({"run.engine", "soft"});
  return read_sample(with(planetary, "restitution", lines), overrides);
}
/// The codes of the faults that keep the case from running.
std::string codes(const cases::Case& mill_case) {
  std::string all;
  for (const Fault& f : run_faults(mill_case)) all += (all.empty() ? "" : " ") + f.code;
  return all;
}
std::string faults_with_step(const char* step) {
  return codes(soft_case("restitution = 0.5", {{"run.time_step", step}}));
}
bool says(const cases::Case& mill_case, const std::string& words) {
  for (const Notice& one : soft_notices(mill_case))
    if (one.text.find(words) != std::string::npos) return true;
  return false;
}

bool warned(const cases::Case& mill_case) {
  const Notices notices = overlap_warnings(mill_case);
  return notices.size() == 1 && notices[0].code == "soft-contacts";
}

TEST(SoftSettings, mhadhbi_s_time_step_is_an_eighth_of_the_rayleigh_time) {
  // 15 mm steel balls, E = 200 GPa, nu = 0.265: 1 us.
  const SoftSettings s = soft_settings(soft_case("restitution = 0.5"));
  EXPECT_NEAR(s.steps.rayleigh, 8.1e-6, 0.2e-6);
  EXPECT_NEAR(s.steps.recommended(1, 50) * 50, s.steps.contact, 1e-12);
  EXPECT_EQ(faults_with_step("1 us"), "");
}

TEST(SoftSettings, what_decides_on_the_step_is_said) {
  EXPECT_TRUE(says(soft_case("restitution = 0.5", {{"run.time_step_fraction", "0.05"}}),
                   "5 % of the Rayleigh time (run.time_step_fraction)"));
  EXPECT_TRUE(says(soft_case("restitution = 0.5"), "18 steps in the shortest collision"));
  EXPECT_TRUE(says(soft_case("restitution = 0.5", {{"run.step_error", "0.2 %"}}),
                   "68 steps in the shortest collision"));
  EXPECT_TRUE(says(soft_case("law = \"walton-braun\"\nrestitution = 0.1"),
                   "16 steps in a collision along the stiff line of unloading"));
  EXPECT_TRUE(says(soft_case("law = \"hertz-tsuji\"\nrestitution = 0.05"),
                   "a fifth of the time in which the damper"));
  EXPECT_TRUE(says(soft_case("restitution = 0.5", {{"run.time_step", "0.3 us"}}), "as given"));
}

TEST(SoftSettings, what_the_step_leaves_a_collision_off_by_is_said_and_is_less_in_shorter_steps) {
  const auto rebound = [](const char* step) {
    const cases::Case mill_case = soft_case("restitution = 0.2", {{"run.time_step", step}});
    const SoftSettings s = soft_settings(mill_case);
    const auto error =
        soft::step_error(contact::HertzMindlin{}, 0.2, s.steps.contact / s.rules.time_step);
    const std::string words = fmt::format("{:.2g} % of their rebound speed", 100 * error.rebound);
    EXPECT_TRUE(says(mill_case, "off by at most about " + words)) << words;
    return error.rebound;
  };
  EXPECT_LE(rebound("0.5 us"), rebound("1 us") / 2);
}

TEST(SoftSettings,
     collisions_faster_than_expected_are_warned_of_where_the_stated_error_is_exceeded) {
  const cases::Case mill_case = soft_case("restitution = 0.5");
  const double expected = soft_settings(mill_case).speed;
  EXPECT_TRUE(speed_notices(mill_case, 0).empty());
  EXPECT_TRUE(speed_notices(mill_case, expected).empty());
  // The duration of a collision falls with u^(1/5), the error grows with the square of the step:
  // 1.1 is reached at 1.1^(5/2) = 1.27 times the speed.
  EXPECT_TRUE(speed_notices(mill_case, 1.25 * expected).empty());
  const Notices found = speed_notices(mill_case, 3 * expected);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].code, "faster-than-expected");
  EXPECT_EQ(found[0].severity, Severity::note) << "errors stay below 2 %";
  const soft::StepError e = step_error(mill_case, 3 * expected);
  const double stated = step_error(mill_case, expected).tangential;
  EXPECT_NEAR(e.tangential / stated, std::pow(3, 0.4), 1e-9);
  EXPECT_NE(found[0].text.find(
                fmt::format("off by up to {:.2g} % of their rebound speed", 100 * e.rebound)),
            std::string::npos)
      << found[0].text;
  // Its remedy is a step with which it is silent, and the error at most the requested one.
  const double step = recommended_step(mill_case, 3 * expected);
  EXPECT_LT(step, soft_settings(mill_case).rules.time_step);
  const cases::Case finer =
      soft_case("restitution = 0.5", {{"run.time_step", fmt::format("{} s", step)}});
  EXPECT_LE(step_error(finer, 3 * expected).largest_mean(), mill_case.run.step_error);
}

TEST(SoftSettings, the_speeds_of_a_run_are_compared_with_the_expected_one) {
  results::Outcome outcome = results::fake_outcome();
  EXPECT_DOUBLE_EQ(largest_collision_speed(outcome), 2);  // m/s, of every second collision
  EXPECT_EQ(largest_collision_speed(results::Outcome{}), 0);
  const auto warned_at = [&](const char* speed, const char* share) {
    outcome.mill_case = soft_case(
        "restitution = 0.5",
        {{"gravity", "0 m/s2"}, {"mill.speed", speed}, {"run.time_step_fraction", share}});
    const Notices notes = engine_notices(outcome, {.engine = cases::EngineName::soft}, nullptr);
    return std::ranges::any_of(notes,
                               [](const Notice& n) { return n.code == "faster-than-expected"; });
  };
  EXPECT_TRUE(warned_at("100 rpm", "1"));      // wall at 1 m/s
  EXPECT_FALSE(warned_at("400 rpm", "1"));     // 4 m/s
  EXPECT_FALSE(warned_at("100 rpm", "0.25"));  // the same step is short enough for 2 m/s
}

TEST(SoftSettings, a_linear_spring_is_as_long_at_any_speed) {
  const cases::Case mill_case = soft_case("restitution = 0.5\nlaw = \"linear-spring\"");
  EXPECT_TRUE(speed_notices(mill_case, 10 * soft_settings(mill_case).speed).empty());
}

TEST(SoftSettings, steps_too_long_or_without_end_are_refused) {
  EXPECT_EQ(faults_with_step("1 us"), "");
  EXPECT_EQ(faults_with_step("1 ms"), "time-step-too-large");
  EXPECT_EQ(faults_with_step("1e-25 s"), "time-step-too-small");
  EXPECT_EQ(codes(soft_case("restitution = 0.5", {{"run.time_step_fraction", "1e-12"}})),
            "time-step-too-small");
  // "auto" does not take the event engine because of such a value.
  EXPECT_EQ(
      codes(soft_case("restitution = 0.5", {{"run.engine", "auto"}, {"run.time_step", "1 ms"}})),
      "time-step-too-large");
}

TEST(SoftSettings, work_is_balls_times_steps) {
  const cases::Case mill_case = soft_case("restitution = 0.5", {{"run.settle", "2 s"}});
  double balls = 0;
  for (const cases::BallSet& set : mill_case.balls) balls += static_cast<double>(set.count);
  EXPECT_DOUBLE_EQ(soft_work(mill_case),
                   balls * (2 + mill_case.run.time) / soft_settings(mill_case).rules.time_step);
}

TEST(SoftSettings, contacts_in_which_balls_would_sink_are_refused) {
  EXPECT_EQ(codes(soft_case("restitution = 0.5\nsoftening = 0.001")), "");
  EXPECT_TRUE(warned(soft_case("restitution = 0.5\nsoftening = 0.001")));
  EXPECT_EQ(codes(soft_case("restitution = 0.5\nsoftening = 1e-9")), "contacts-too-soft");
  EXPECT_EQ(codes(soft_case("law = \"sjkr\"\ncohesion = \"1e5 J/m3\"\nrestitution = 0.5")), "");
  EXPECT_EQ(codes(soft_case("law = \"sjkr\"\ncohesion = \"1e12 J/m3\"\nrestitution = 0.5")),
            "contacts-too-soft");
}

TEST(SoftSettings, overlap_of_bodies_is_that_of_hits_in_line_with_their_centres) {
  const std::string drum = R"(title = "cylpebs"
[mill]
kind = "tumbling"
speed = "75 %"
[jar]
kind = "cylinder"
diameter = "120 mm"
height = "40 mm"
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
[[balls]]
shape = "cylpebs"
surface = "convex"
rounding = "1 mm"
diameter = "15 mm"
length = "15 mm"
density = "7800 kg/m3"
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
count = 5
[contact]
restitution = 0.5
friction = 0.4
softening = 0.0001
[run]
engine = "soft"
time = "1 s"
)";
  const cases::Case mill_case = read_sample(drum);
  const SoftSettings s = soft_settings(mill_case);
  // Hertz: E* sqrt(R*) d^(5/2) 8/15 = m v^2/2, of a corner on the wall.
  const double modulus = 1e-4 * 200e9 / (2 * (1 - 0.3 * 0.3)), radius = 1e-3;
  const double energy = 0.5 * mill_case.balls[0].mass() * s.speed * s.speed;
  const double depth = std::pow(energy * 15 / (8 * modulus * std::sqrt(radius)), 0.4);
  EXPECT_NEAR(s.steps.overlap * radius / depth, 1, 1e-9);
  EXPECT_GT(s.steps.overlap, 1);
  EXPECT_EQ(codes(mill_case), "") << "most hits are less deep";
  ASSERT_EQ(overlap_warnings(mill_case).size(), 1U);
  EXPECT_EQ(overlap_warnings(mill_case)[0].code, "deep-overlap");
}

}  // namespace
}  // namespace mahlwerk::campaign::soft_settings_test
