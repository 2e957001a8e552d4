// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The mixing time of charges whose balls change their places by a known law, and its notices.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/parts/mixing/mixing.hpp"
#include "mahlwerk/parts/mixing/mixing_record.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "statement.hpp"

namespace mahlwerk::parts::mixing {
const cases::Part& part();
}

namespace mahlwerk::parts::mixing::mixing_time_test {
namespace {

using tests::states;

constexpr int side = 10, samples = 41;  // balls along an edge of the lattice, samples each second

/// Balls of two colours in two halves, of which a share changes places with each other.
std::vector<scene::Ball> charge(double share, Random& random) {
  std::vector<scene::Ball> balls;
  std::vector<std::size_t> moved;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        if (random.uniform() < share) moved.push_back(balls.size());
        balls.push_back({0.5, 1, {x - 4.5, y - 4.5, z - 4.5}, {}, {}, x < side / 2});
      }
  for (std::size_t i = moved.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(balls[moved[i - 1]].position, balls[moved[other]].position);
  }
  return balls;
}

/// A run of one replicate whose `share(time)` of balls has changed places.
template <class Share>
results::Outcome run_of(const Share& share) {
  auto record = std::make_unique<MixingRecord>(
      MixingSetup{.section = {},
                  .mill = {geometry::Box{side, side, side}, kinematics::Still{}, {}},
                  .interval = 1,
                  .cell = 3,
                  .reach = 1.2,
                  .diameter = 1});
  record->begin(0);
  Random random(5, 0);
  for (int i = 0; i < samples; ++i)
    record->take_balls({.time = 1.0 * i}, i, charge(share(i), random));
  results::Outcome outcome;
  outcome.replicates.emplace_back(0);
  outcome.replicates[0].energy_balance.time = samples - 1;
  outcome.replicates[0].recorders.add(std::move(record));
  return outcome;
}

double mixing_time(const results::Outcome& outcome) {
  for (const results::Measure& m : part().quantities())
    if (m.name == "mixing_time") return m.compute(outcome.mill_case, outcome.replicates[0]);
  return 0;
}

/// The codes of the notices, with a space after each.
std::string notices(const results::Outcome& outcome) {
  std::string codes;
  for (const Notice& one : part().notices(outcome)) codes += one.code + " ";
  return codes;
}

TEST(MixingTime, of_balls_that_change_places_is_half_the_time_in_which_they_do) {
  // A pair of neighbours keeps its colours while both are in their places: the square of their
  // share.
  constexpr double time = 8;
  const auto outcome = run_of([](double t) { return 1 - std::exp(-t / time); });
  // An index of 1000 balls with three neighbours each scatters by sqrt(1/3000); the fit by about
  // sqrt(8/4) of it in four samples of the time constant; four standard errors.
  states("mixing time", mixing_time(outcome), time / 2, 4 * time / 2 * std::sqrt(2.0 / 3000),
         "(1 - share)^2 = exp(-2 t/time)");
  EXPECT_EQ(notices(outcome), "");
}

TEST(MixingTime, of_a_charge_that_segregates_is_found) {
  // From half of the balls in any place to a fifth.
  const auto outcome =
      run_of([](double t) { return 1 - std::sqrt(0.64 - 0.39 * std::exp(-t / 4)); });
  // The change of the index is 0.39 instead of 1.
  states("segregation time", mixing_time(outcome), 4, 4 * 4 * std::sqrt(2.0 / 3000) / 0.39,
         "(1 - share)^2 = 0.64 - 0.39 exp(-t/4)");
  EXPECT_EQ(notices(outcome), "");
}

TEST(MixingTime, of_a_charge_that_is_mixed_has_a_note) {
  const auto outcome = run_of([](double) { return 1.0; });
  EXPECT_TRUE(std::isnan(mixing_time(outcome)));
  EXPECT_EQ(notices(outcome), "mixed-from-start ");
}

TEST(MixingTime, of_a_charge_that_does_not_mix_has_a_warning) {
  const auto still = run_of([](double) { return 0.0; });
  EXPECT_TRUE(std::isnan(mixing_time(still)));
  EXPECT_EQ(notices(still), "not-mixed ");
  // The square root of a line: the index grows as a line.
  const auto slow = run_of([](double t) { return 1 - std::sqrt(1 - 0.01 * t); });
  EXPECT_TRUE(std::isnan(mixing_time(slow)));
  EXPECT_EQ(notices(slow), "not-mixed ");
}

}  // namespace
}  // namespace mahlwerk::parts::mixing::mixing_time_test
