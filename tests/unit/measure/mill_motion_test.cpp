// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/mill_motion.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/error.hpp"
#include "synthetic_film.hpp"

namespace mahlwerk::measure::mill_motion_test {
namespace {

using observe::Estimate;
using tests::mixer_film;
using tests::planetary_film;
using tests::SyntheticFilm;

constexpr double degree = std::numbers::pi / 180;
const FilmSetup lengths{.scale = Estimate{1, 0}, .distance = {}, .arm = {}};

Estimate value_of(const Findings& found, std::string_view key) {
  for (const Finding& one : found.list)
    if (one.key == key) return one.value;
  ADD_FAILURE() << "no " << key;
  return {};
}
bool holds(const Estimate& e, double truth) {
  return std::abs(e.mean - truth) <= e.ci95;
}

std::string refusal_of(std::string_view kind, const MarkTracks& tracks, const FilmSetup& setup) {
  try {
    mill_motion(kind, tracks, setup);
  } catch (const InputError& e) {
    return e.faults().front().what;
  }
  return "";
}

TEST(MixerMill, has_arm_and_swing_of_marks_anywhere_on_the_arm) {
  for (const double swing : {0.5, 3.8, 12.0}) {
    const MarkTracks tracks =
        mixer_film({.frames = 1000}, 25, swing * degree, {{0.136, 0}, {0.06, 0.03}});
    const Findings found = mill_motion("arc-shaker", tracks, lengths);
    EXPECT_NEAR(value_of(found, "mill.frequency").mean, 25, 1e-3);
    EXPECT_NEAR(value_of(found, "mill.swing").mean, swing * degree, 2e-4 * swing * degree);
    EXPECT_NEAR(value_of(found, "mill.arm").mean, 0.136, 2e-4 * 0.136);
  }
}

TEST(MixerMill, has_a_swing_that_no_scale_changes) {
  const MarkTracks tracks = mixer_film({}, 25, 4 * degree, {{544, 0}, {304, 0}});
  const FilmSetup by_distance{.scale = {}, .distance = Estimate{0.06, 0.0003}, .arm = {}};
  const Findings found = mill_motion("arc-shaker", tracks, by_distance);
  EXPECT_NEAR(value_of(found, "mill.swing").mean, 4 * degree, 1e-4);
  EXPECT_LT(value_of(found, "mill.swing").ci95, 2e-4);
  EXPECT_NEAR(value_of(found, "mill.arm").mean, 0.136, 2e-4);
  EXPECT_NEAR(value_of(found, "mill.arm").ci95, 0.136 * 0.005, 5e-5);
}

TEST(MixerMill, has_the_swing_of_one_mark_and_a_known_arm) {
  const MarkTracks tracks = mixer_film({}, 25, 10 * degree, {{0.136, 0}});
  const FilmSetup with_arm{
      .scale = Estimate{1, 0}, .distance = {}, .arm = Estimate{0.136, 0.00136}};
  const Estimate swing = value_of(mill_motion("arc-shaker", tracks, with_arm), "mill.swing");
  EXPECT_NEAR(swing.mean, 10 * degree, 1e-4);
  EXPECT_NEAR(swing.ci95, 0.1 * degree, 0.01 * degree);
  const Findings stroke = mill_motion("arc-shaker", tracks, lengths);
  EXPECT_TRUE(stroke.list.back().key.empty()) << "no key follows from the stroke alone";
  EXPECT_FALSE(stroke.remarks.empty());
}

/// Shares of films whose intervals hold the true frequency, arm and swing.
std::array<double, 3> coverage(SyntheticFilm film, int films) {
  std::array<double, 3> held{};
  for (int i = 0; i < films; ++i) {
    film.seed = static_cast<std::uint64_t>(i + 1);
    const Findings found = mill_motion(
        "arc-shaker", mixer_film(film, 25, 3.8 * degree, {{544, 0}, {304, 40}}), lengths);
    held[0] += holds(value_of(found, "mill.frequency"), 25);
    held[1] += holds(value_of(found, "mill.arm"), 544);
    held[2] += holds(value_of(found, "mill.swing"), 3.8 * degree);
  }
  for (double& one : held) one /= films;
  return held;
}

TEST(MixerMill, has_intervals_that_hold_the_truth_in_95_of_100_films) {
  for (const double memory : {0.0, 0.9}) {  // errors of neighbouring frames alike
    const auto held = coverage({.noise = 0.5, .memory = memory}, 300);
    for (const double share : held) {
      EXPECT_GT(share, 0.91) << "memory " << memory;
      EXPECT_LT(share, 0.99) << "memory " << memory;
    }
  }
}

TEST(MixerMill, has_the_accuracy_of_the_film_that_the_catalogue_cites) {
  // A published film of a mixer mill: period 31.85 +- 0.1 frames, half stroke 7.40 +- 0.05 units,
  // from nine windows of 62 frames.
  const double half_stroke = 7.4, arm = 112;
  const MarkTracks tracks = mixer_film({.frames = 558, .rate = 1, .noise = 0.3, .memory = 0.8},
                                       1 / 31.85, half_stroke / arm, {{arm, 0}});
  const Findings found = mill_motion("vibration", tracks, lengths);
  const Estimate frequency = value_of(found, "mill.frequency"),
                 amplitude = value_of(found, "mill.amplitude");
  EXPECT_TRUE(holds(frequency, 1 / 31.85));
  EXPECT_LT(frequency.ci95 * 31.85 * 31.85, 0.1) << "in frames";
  EXPECT_NEAR(amplitude.mean, half_stroke, 0.1);
  EXPECT_LT(amplitude.ci95, 0.12);
  EXPECT_GT(amplitude.ci95, 0.02) << "two standard deviations of this noise";
}

TEST(MixerMill, whose_marks_are_not_on_one_part_is_remarked) {
  MarkTracks tracks = mixer_film({}, 25, 4 * degree, {{544, 0}, {304, 0}});
  for (std::size_t i = 0; i < tracks.time.size(); ++i)
    tracks.marks[1].x[i] += 20 * std::cos(2 * std::numbers::pi * 25 * tracks.time[i]);
  const Findings found = mill_motion("arc-shaker", tracks, lengths);
  ASSERT_FALSE(found.remarks.empty());
  EXPECT_NE(found.remarks.back().find("not on one rigid part"), std::string::npos);
}

TEST(PlanetaryMill, has_orbit_and_ratio_of_a_mark_on_the_jar) {
  for (const double ratio : {-2.0, -1.5, -3.0, 1.0}) {
    MarkTracks tracks = planetary_film({.frames = 1600, .noise = 1e-4}, 2 * std::numbers::pi * 7.2,
                                       0.07, ratio, 0.02);
    for (const bool with_disc : {true, false}) {
      if (!with_disc) tracks.marks.pop_back();
      const Findings found = mill_motion("planetary", tracks, lengths);
      EXPECT_NEAR(value_of(found, "mill.speed").mean, 2 * std::numbers::pi * 7.2, 0.01);
      EXPECT_NEAR(value_of(found, "mill.orbit_radius").mean, 0.07, 3e-5) << ratio;
      EXPECT_NEAR(value_of(found, "mill.ratio").mean, ratio, 2e-3);
      EXPECT_LT(value_of(found, "mill.ratio").ci95, 5e-3);
    }
  }
}

TEST(PlanetaryMill, whose_jar_carries_the_mark_far_out_needs_a_mark_on_the_disc) {
  MarkTracks tracks = planetary_film({.frames = 1600}, 40, 0.07, -2.5, 0.1);
  EXPECT_NEAR(value_of(mill_motion("planetary", tracks, lengths), "mill.ratio").mean, -2.5, 1e-3);
  tracks.marks.pop_back();
  const Findings found = mill_motion("planetary", tracks, lengths);
  EXPECT_GT(std::abs(value_of(found, "mill.ratio").mean + 2.5), 0.1);
  EXPECT_NE(found.remarks.front().find("second mark on the disc"), std::string::npos);
}

TEST(PlanetaryMill, has_intervals_that_hold_the_truth_in_95_of_100_films) {
  int radius = 0, ratio = 0;
  constexpr int films = 100;
  for (int i = 0; i < films; ++i) {
    const Findings found = mill_motion("planetary",
                                       planetary_film({.frames = 800,
                                                       .noise = 5e-4,
                                                       .memory = 0.5,
                                                       .seed = static_cast<std::uint64_t>(i + 1)},
                                                      45, 0.07, -2, 0.02),
                                       lengths);
    radius += holds(value_of(found, "mill.orbit_radius"), 0.07);
    ratio += holds(value_of(found, "mill.ratio"), -2);
  }
  EXPECT_GT(radius, 0.9 * films);
  EXPECT_GT(ratio, 0.9 * films);
}

TEST(TurningMill, has_speed_and_radius) {
  const MarkTracks tracks = planetary_film({.frames = 1600, .noise = 1e-4}, 40, 0.05, 0, 0);
  const Findings found = mill_motion("circular", tracks, lengths);
  EXPECT_NEAR(value_of(found, "mill.radius").mean, 0.05, 3e-5);
  EXPECT_NEAR(value_of(found, "mill.speed").mean, 40, 0.02);
  EXPECT_EQ(mill_motion("tumbling", tracks, lengths).list.size(), 1U);
}

TEST(Film, of_too_little_is_refused) {
  const auto mixer = [](int frames, double swing) {
    return mixer_film({.frames = frames}, 25, swing, {{0.1, 0}});
  };
  EXPECT_NE(refusal_of("vibration", mixer(8, 0.1), lengths).find("at least 12"), std::string::npos);
  EXPECT_NE(refusal_of("vibration", mixer(150, 0.1), lengths).find("4.7 periods"),
            std::string::npos);
  const MarkTracks still = mixer_film({.noise = 1e-3}, 25, 0, {{0.1, 0}});
  EXPECT_NE(refusal_of("vibration", still, lengths).find("no oscillation"), std::string::npos);
  EXPECT_NE(refusal_of("vibration", mixer(400, 0.1), {}).find("length of a pixel"),
            std::string::npos);
  EXPECT_NE(refusal_of("planetary", mixer(400, 0.1), lengths).find("along a line"),
            std::string::npos);
  EXPECT_NE(refusal_of("circular", mixer(400, 0.1), lengths).find("along a line"),
            std::string::npos);
  EXPECT_NE(refusal_of("figure-eight", mixer(400, 0.1), lengths).find("cannot give"),
            std::string::npos);
  EXPECT_NE(refusal_of("arc-shaker", {}, lengths).find("no mark"), std::string::npos);
  MarkTracks backwards = mixer(400, 0.1);
  backwards.time[7] = backwards.time[6];
  EXPECT_NE(refusal_of("vibration", backwards, lengths).find("does not increase"),
            std::string::npos);
}

TEST(Film, with_gaps_and_uneven_times_gives_the_same_motion) {
  const MarkTracks whole = mixer_film({.frames = 800}, 25, 0.06, {{136, 0}, {76, 0}});
  MarkTracks part;
  part.marks.resize(2);
  tests::Noise choose(5, 1);
  for (std::size_t i = 0; i < whole.time.size(); ++i) {
    if (choose.uniform(0, 1) < 0.3 || (i > 300 && i < 380)) continue;
    part.time.push_back(whole.time[i]);
    for (std::size_t m = 0; m < 2; ++m) {
      part.marks[m].x.push_back(whole.marks[m].x[i]);
      part.marks[m].y.push_back(whole.marks[m].y[i]);
    }
  }
  const Findings found = mill_motion("arc-shaker", part, lengths);
  EXPECT_NEAR(value_of(found, "mill.swing").mean, 0.06, 1e-4);
  EXPECT_NEAR(value_of(found, "mill.frequency").mean, 25, 0.01);
}

}  // namespace
}  // namespace mahlwerk::measure::mill_motion_test
