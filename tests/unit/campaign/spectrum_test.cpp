// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A ball dropped on a floor: every impact, and so every number of the spectrum, is computed by
// hand.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/summary.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::spectrum_test {
namespace {

using results::Table;
using tests::states;

constexpr double e = 0.8, high = 0.05, gravity = 9.81;  // [m], [m/s2]

/// A ball falls from the height `high` onto the frictionless floor of a box and makes this many
/// bounces.
cases::Case dropped(int bounces) {
  cases::Case c;
  c.mill.motion = kinematics::Still{};
  c.jar.shape = geometry::Box{0.2, 0.2, 0.2};
  c.balls = {{1, 0.01, 7850, ""}};
  c.balls[0].positions = {{0, 0, -0.1 + 0.005 + high}};
  c.contact.rule = {.restitution = e, .tangential_restitution = 1, .friction = 0};
  c.contact.lasting = cases::SustainedContactModel::none;
  const double fall = std::sqrt(2 * high / gravity);
  c.run.time = fall;  // ends at half of the flight after the last bounce
  for (int n = 1; n < bounces; ++n) c.run.time += 2 * fall * std::pow(e, n);
  c.run.time += fall * std::pow(e, bounces);
  c.observe.threshold = 0.1;
  return c;
}

double mass(const cases::Case& c) {
  return c.balls[0].mass();
}

/// Edges of the quarter-octave bin that contains `value`.
std::pair<double, double> quarter(double value) {
  const double low = std::floor(4 * std::log2(value));
  return {std::exp2(low / 4), std::exp2((low + 1) / 4)};
}

class Dropped : public testing::TestWithParam<int> {};

TEST_P(Dropped, spectrum_is_that_written_by_hand) {
  const cases::Case mill_case = dropped(GetParam());
  const results::Outcome outcome = run(mill_case);
  std::map<double, std::pair<int, double>> bins, lost;  // by lower edge: count and sum
  for (int n = 0; n < GetParam(); ++n) {
    const double energy = mass(mill_case) * gravity * high * std::pow(e, 2 * n);
    for (const auto& [list, value] : {std::pair(&bins, energy), {&lost, energy * (1 - e * e)}}) {
      auto& [count, sum] = (*list)[quarter(value).first];
      ++count;
      sum += value;
    }
  }
  const Table table = results::spectrum(outcome);
  const auto column = [&](const std::string& name) {
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      if (table.columns[i].name == name) return i;
    throw std::out_of_range(name);
  };
  ASSERT_EQ(outcome.replicates[0].tally.all.count, GetParam());
  std::size_t seen = 0, seen_lost = 0;
  const double time = mill_case.run.time;
  const std::string why = "m g h e^(2n); touches are found to 1e-12 of the radius";
  for (const auto& row : table.rows)
    for (const auto& [list, name] : {std::pair(&bins, "normal"), {&lost, "lost"}}) {
      const double count = row[column(std::string("rate_") + name)] * time;
      const double power = row[column(std::string("power_") + name)] * time;
      const auto wanted = std::ranges::find_if(
          *list, [&](const auto& bin) { return std::abs(bin.first / row[0] - 1) < 1e-12; });
      if (wanted == list->end()) {
        EXPECT_EQ(count, 0) << name << " from " << row[0];
        continue;
      }
      ++(list == &bins ? seen : seen_lost);
      states(std::string("count of ") + name, count, wanted->second.first, 1e-9, why);
      states(std::string("sum of ") + name + " over that by hand", power / wanted->second.second, 1,
             1e-9, why);
      EXPECT_NEAR(row[1] / row[0], std::exp2(0.25), 1e-15) << "a quarter of an octave";
    }
  EXPECT_EQ(seen, bins.size());
  EXPECT_EQ(seen_lost, lost.size());
}

TEST_P(Dropped, histograms_sum_to_the_geometric_series) {
  const cases::Case mill_case = dropped(GetParam());
  const observe::Spectra whole = run(mill_case).replicates[0].tally.total_spectra();
  const double first = mass(mill_case) * gravity * high, q = std::pow(e * e, GetParam());
  const std::string why = "m g h (1 - e^(2N))/(1 - e^2)";
  const double all = first * (1 - q) / (1 - e * e);
  states("impact energy over the series", whole.energy_normal.sum() / all, 1, 1e-9, why);
  states("of the touching points", whole.energy_contact_point.sum() / all, 1, 1e-9, "no slip");
  states("of the centres", whole.energy_centre.sum() / all, 1, 1e-9, "no glide");
  states("lost over m g h (1 - e^(2N))", whole.energy_lost.sum() / (first * (1 - q)), 1, 1e-9,
         "all but what is left");
  states("lost across [J]", whole.lost_tangential.sum(), 0, 0, "no friction");
  EXPECT_EQ(whole.angle_all[0], GetParam()) << "head-on";
}

INSTANTIATE_TEST_SUITE_P(Bounces, Dropped, testing::Values(1, 3, 12, 20));

}  // namespace
}  // namespace mahlwerk::campaign::spectrum_test
