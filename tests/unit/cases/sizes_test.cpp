// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::sizes_test {
namespace {

using namespace sample;
using tests::states;
using Law = Distribution::Law;

Distribution of(Law law, double diameter, double spread, std::int64_t classes) {
  return {.law = law, .diameter = diameter, .spread = spread, .classes = classes};
}

/// Mean of d^3 over a density between two bounds, by Simpson's rule.
template <class Density>
double mean_cube(double low, double high, Density density) {
  constexpr int n = 20000;
  double number = 0, cube = 0;
  for (int i = 0; i <= n; ++i) {
    const double d = low + (high - low) * i / n;
    const double weight = (i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * density(d);
    number += weight;
    cube += weight * d * d * d;
  }
  return cube / number;
}

/// A drum with `lines` in its ball set.
std::string drum_with(const std::string& lines, const std::string& count = "count = 1000") {
  return "[mill]\nkind = \"tumbling\"\nspeed = \"75 %\"\n[jar]\nkind = \"cylinder\"\ndiameter = "
         "\"400 mm\"\nheight = \"400 mm\"\n[[balls]]\ndensity = \"7850 kg/m3\"\n" +
         count + "\n" + lines + "\n[run]\ntime = \"1 s\"\n";
}

TEST(Sizes, the_mean_ball_is_that_of_the_whole_distribution) {
  const double m = 0.01, s = 0.2;
  const double normal = mean_cube(m * (1 - 3 * s), m * (1 + 3 * s), [&](double d) {
    const double z = (d - m) / (s * m);
    return std::exp(-0.5 * z * z);
  });
  states("normal: mean volume over pi/6, mm3",
         1e9 * std::pow(mean_volume_diameter(size_shares(of(Law::normal, m, s, 12))), 3),
         1e9 * normal, 1e-9, "Simpson's rule, 20000 steps; its error is below 1e-12");
  const double g = 1.5;
  const double lognormal = mean_cube(m / std::pow(g, 3), m * std::pow(g, 3), [&](double d) {
    const double z = std::log(d / m) / std::log(g);
    return std::exp(-0.5 * z * z) / d;
  });
  states("lognormal: mean volume over pi/6, mm3",
         1e9 * std::pow(mean_volume_diameter(size_shares(of(Law::lognormal, m, g, 12))), 3),
         1e9 * lognormal, 1e-6, "Simpson's rule, 20000 steps; its error is below 1e-8");
  const Distribution uniform{
      .law = Law::uniform, .smallest = 0.002, .largest = 0.004, .classes = 7};
  states("uniform: mean volume over pi/6, mm3",
         1e9 * std::pow(mean_volume_diameter(size_shares(uniform)), 3),
         1e9 * (std::pow(0.004, 4) - std::pow(0.002, 4)) / (4 * 0.002), 1e-12, "(chg.4)");
}

TEST(Sizes, the_number_of_classes_does_not_change_the_mass) {
  for (const auto& [law, spread] : {std::pair{Law::normal, 0.3}, {Law::lognormal, 2.0}}) {
    const double one = mean_volume_diameter(size_shares(of(law, 1, spread, 1)));
    for (const std::int64_t classes : {2, 8, 32})
      states("mean volume diameter", mean_volume_diameter(size_shares(of(law, 1, spread, classes))),
             one, 1e-12, "(chg.7): 32 sums of numbers good to 1e-14");
  }
}

TEST(Sizes, classes_lie_within_their_bounds_and_rise) {
  for (const Distribution& d : {of(Law::normal, 1, 0.3, 32), of(Law::lognormal, 1, 2, 32)}) {
    double share = 0, last = 0;
    for (const SizeShare& s : size_shares(d)) {
      EXPECT_GT(s.diameter, s.low);
      EXPECT_LT(s.diameter, s.high);
      EXPECT_GT(s.diameter, last);
      last = s.diameter;
      share += s.share;
    }
    states("sum of shares", share, 1, 1e-14, "shares of one whole, 32 roundings");
  }
}

TEST(Sizes, every_sieve_holds_its_share_of_the_mass) {
  const Distribution d{.law = Law::sieves,
                       .passing = {{{1e-3, 0}, {2e-3, 0.1}, {4e-3, 0.1}, {8e-3, 0.7}, {10e-3, 1}}}};
  const std::vector<SizeShare> shares = size_shares(d);
  ASSERT_EQ(shares.size(), 3U);  // nothing lies between 2 and 4 mm
  const double all = std::pow(mean_volume_diameter(shares), 3);
  const double wanted[] = {0.1, 0.6, 0.3};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(shares[i].diameter, shares[i].low);
    EXPECT_LT(shares[i].diameter, shares[i].high);
    states("share of the mass", shares[i].share * std::pow(shares[i].diameter, 3) / all, wanted[i],
           1e-14, "the table of sieves (chg.5)");
  }
}

TEST(Sizes, counts_sum_to_the_whole_and_are_within_one_of_their_share) {
  for (const std::int64_t count : {1, 7, 30, 1001, 99999})
    for (const std::int64_t classes : {1, 5, 32}) {
      const std::vector<SizeShare> shares = size_shares(of(Law::lognormal, 1, 1.4, classes));
      const std::vector<std::int64_t> counts = apportion(count, shares);
      EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), count);
      for (std::size_t i = 0; i < shares.size(); ++i)
        EXPECT_LT(
            std::abs(static_cast<double>(counts[i]) - shares[i].share * static_cast<double>(count)),
            1);
    }
}

TEST(Sizes, unless_said_otherwise_every_class_has_a_ball) {
  const Case many =
      read_sample(drum_with("distribution = \"normal\"\ndiameter = \"10 mm\"\nspread = \"5 %\""));
  EXPECT_EQ(many.balls[0].classes.size(), 12U);
  EXPECT_EQ(many.balls[0].distribution.classes, 12);
  EXPECT_EQ(source_of(many, "balls.1.classes"), "default: 12 at most, and a ball in each");
  const Case few = read_sample(
      drum_with("distribution = \"normal\"\ndiameter = \"10 mm\"\nspread = \"5 %\"", "count = 10"));
  EXPECT_LT(few.balls[0].classes.size(), 12U);
  std::int64_t count = 0;
  for (const SizeClass& size : few.balls[0].classes) {
    EXPECT_GT(size.count, 0);
    count += size.count;
  }
  EXPECT_EQ(count, 10);
}

TEST(Sizes, mass_and_filling_mean_the_whole_set) {
  const std::string words = "distribution = \"lognormal\"\ndiameter = \"5 mm\"\nspread = 1.4";
  const Case by_mass = read_sample(drum_with(words, "mass = \"20 kg\""));
  double mass = 0, one_of_each = 0;
  for (const SizeClass& s : by_mass.balls[0].classes) {
    const double ball = std::numbers::pi / 6 * std::pow(s.diameter, 3) * 7850;
    mass += static_cast<double>(s.count) * ball;
    one_of_each += ball;
  }
  states("mass, kg", mass, balls_mass(by_mass.balls), 1e-12, "classes against the set");
  states("mass, kg", mass, 20, one_of_each, "asked for; no class is off by a ball (chg.8)");
  const Case by_filling = read_sample(drum_with(words, "filling = \"20 %\""));
  const double volume = static_cast<double>(by_filling.balls[0].count) *
                        ball_volume(by_filling.balls[0]) / jar_volume(by_filling.jar);
  states("filling", volume, 0.2, 1e-4, "asked for; 1e4 balls and more, one is below 1e-4");
}

TEST(Sizes, retained_is_passing_said_otherwise) {
  const std::string rows =
      "[[\"5 mm\", \"30 %\"], [\"8 mm\", 0.5], [\"9 mm\", \"20 %\"], [\"10 mm\", 0]]";
  const Case retained = read_sample(drum_with("distribution = \"sieves\"\nretained = " + rows));
  const Case passing = read_sample(drum_with(
      "distribution = \"sieves\"\npassing = [[\"5 mm\", 0], [\"8 mm\", \"30 %\"], [\"9 mm\", "
      "\"80 %\"], [\"10 mm\", 1]]"));
  EXPECT_EQ(retained.balls, passing.balls);
}

TEST(Sizes, what_was_read_is_read_back) {
  for (const char* words :
       {"distribution = \"normal\"\ndiameter = \"10 mm\"\nspread = \"5 %\"",
        "distribution = \"lognormal\"\ndiameter = \"5 mm\"\nspread = 1.4\nclasses = 16",
        "distribution = \"uniform\"\nsmallest = \"2 mm\"\nlargest = \"4 mm\"",
        "distribution = \"sieves\"\npassing = [[\"5 mm\", 0], [\"8 mm\", \"30 %\"], [\"10 mm\", "
        "1]]",
        "distribution = \"equal\"\ndiameter = \"10 mm\""}) {
    const Case c = read_sample(drum_with(words));
    EXPECT_TRUE(read_sample(write(c)) == c) << write(c);
  }
}

TEST(Sizes, balls_of_all_classes_start_in_the_jar_as_one_kind) {
  const Case c = read_sample(
      drum_with("distribution = \"uniform\"\nsmallest = \"10 mm\"\nlargest = \"20 mm\""));
  const std::vector<scene::Ball> balls = starting_balls(c, 0);
  ASSERT_EQ(balls.size(), 1000U);
  std::size_t i = 0;
  for (const SizeClass& size : c.balls[0].classes)
    for (std::int64_t n = 0; n < size.count; ++n, ++i) {
      EXPECT_EQ(balls[i].radius, 0.5 * size.diameter);
      EXPECT_EQ(balls[i].kind, 0);
    }
}

/// The only fault of a drum with these lines in its ball set: its cause, remedy and code.
std::string wrong(const std::string& words, const std::string& count = "count = 1000") {
  const std::vector<Fault> found = faults_of(drum_with(words, count));
  if (found.size() != 1) return fault_of(drum_with(words, count));
  return found[0].what + "; " + found[0].remedy + " [" + found[0].code + "]";
}
#define EXPECT_SAYS(text, ...)                                                                \
  {                                                                                           \
    const std::string said = wrong(__VA_ARGS__);                                              \
    EXPECT_NE(said.find(text), std::string::npos) << "wanted: " << text << "\ngot: " << said; \
  }

TEST(SizeFaults, numbers_of_a_distribution_out_of_range) {
  EXPECT_SAYS("[out-of-range]",
              "distribution = \"normal\"\ndiameter = \"9 mm\"\nspread = \"31 %\"");
  EXPECT_SAYS("[out-of-range]", "distribution = \"lognormal\"\ndiameter = \"9 mm\"\nspread = 1");
  EXPECT_SAYS("[out-of-range]", "distribution = \"lognormal\"\ndiameter = \"9 mm\"\nspread = 2.1");
  EXPECT_SAYS("largest (9 mm) is not above smallest (9 mm)",
              "distribution = \"uniform\"\nsmallest = \"9 mm\"\nlargest = \"9 mm\"");
  EXPECT_SAYS("[out-of-range]",
              "distribution = \"uniform\"\nsmallest = \"8 mm\"\nlargest = \"9 mm\"\nclasses = 33");
}

TEST(SizeFaults, keys_that_are_missing_or_mean_nothing) {
  EXPECT_SAYS("lacks `spread`", "distribution = \"normal\"\ndiameter = \"9 mm\"");
  EXPECT_SAYS("lacks `passing`", "distribution = \"sieves\"");
  EXPECT_SAYS("there is no distribution = \"gauss\"",
              "distribution = \"gauss\"\ndiameter = \"9 mm\"");
  EXPECT_SAYS("spread has no meaning under distribution = \"equal\"",
              "diameter = \"9 mm\"\nspread = \"5 %\"");
  EXPECT_SAYS(
      "diameter has no meaning under distribution = \"uniform\"",
      "distribution = \"uniform\"\ndiameter = \"9 mm\"\nsmallest = \"8 mm\"\nlargest = \"9 mm\"");
  EXPECT_SAYS(
      "smallest has no meaning under distribution = \"normal\"",
      "distribution = \"normal\"\ndiameter = \"9 mm\"\nspread = \"5 %\"\nsmallest = \"8 mm\"");
  EXPECT_SAYS("cannot have given positions",
              "distribution = \"uniform\"\nsmallest = \"8 mm\"\nlargest = \"9 mm\"",
              "positions = [[\"0 mm\", \"0 mm\", \"0 mm\"]]");
}

TEST(SizeFaults, sieves_that_do_not_hold_the_whole) {
  const std::string sieves = "distribution = \"sieves\"\n";
  EXPECT_SAYS("the shares of `retained` sum to 90 %, not to 100 %",
              sieves + "retained = [[\"5 mm\", 0.3], [\"8 mm\", 0.6], [\"9 mm\", 0]]");
  EXPECT_SAYS("the largest sieve of `retained` retains mass",
              sieves + "retained = [[\"5 mm\", 0.4], [\"8 mm\", 0.6]]");
  EXPECT_SAYS("90 % of the mass pass the largest sieve",
              sieves + "passing = [[\"5 mm\", 0], [\"8 mm\", 0.9]]");
  EXPECT_SAYS("has no smallest size", sieves + "passing = [[\"5 mm\", 0.1], [\"8 mm\", 1]]");
  EXPECT_SAYS(
      "the shares of `passing` decrease",
      sieves + "passing = [[\"5 mm\", 0], [\"6 mm\", 0.5], [\"7 mm\", 0.4], [\"8 mm\", 1]]");
  EXPECT_SAYS("[unsorted-sieves]",
              sieves + "passing = [[\"5 mm\", 0], [\"5 mm\", 0.5], [\"8 mm\", 1]]");
  EXPECT_SAYS("must be a list of 2 to 33 rows", sieves + "passing = [[\"5 mm\", 0]]");
  EXPECT_SAYS("must be an opening and a share", sieves + "passing = [[\"5 mm\", 0], [\"8 mm\"]]");
}

TEST(SizeFaults, a_class_without_a_ball) {
  EXPECT_SAYS("none of the 30 balls falls between",
              "distribution = \"normal\"\ndiameter = \"9 mm\"\nspread = \"5 %\"\nclasses = 12",
              "count = 30");
  EXPECT_SAYS(
      "join this sieve with the next",
      "distribution = \"sieves\"\npassing = [[\"1 mm\", 0], [\"2 mm\", 0.99], [\"20 mm\", 1]]",
      "count = 30");
}

TEST(SizeFaults, the_largest_of_a_set_must_fit_the_jar) {
  EXPECT_SAYS("[ball-too-large]",
              "distribution = \"uniform\"\nsmallest = \"100 mm\"\nlargest = \"450 mm\"",
              "count = 12");
}

TEST(SizeFaults, too_many_sets) {
  std::string sets;
  for (int i = 0; i < 32; ++i) sets += "[[balls]]\ndiameter = \"2 mm\"\ndensity = \"7850 kg/m3\"\n";
  EXPECT_SAYS("there are 33 ball sets, more than 32", "diameter = \"9 mm\"\n" + sets);
}

}  // namespace
}  // namespace mahlwerk::cases::sizes_test
