// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// From the collisions of a run to the particle sizes of its powder.
#include "mahlwerk/results/quantities/grinding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/parts/grinding/warnings.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "observed.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::grinding_test {
namespace {

using results::Outcome;
using tests::states;

/// Five balls in a shaken jar with a gram of grains that break into halves.
cases::Case grinding_case(const std::string& engine = "event") {
  cases::Case c = shaken(engine, 5);
  c.run.time = 1;
  c.run.replicates = 6;
  c.powder = cases::Powder{.material = "", .mass = 1e-3, .size = 0.3e-3, .density = 2650};
  c.powder->feed = {powder::Feed::Law::lognormal, 0.3e-3, 1.3};
  c.capture = cases::Capture{.model = powder::Barrios{50}};
  c.grinding = cases::Grinding{.breakage = powder::VogelPeukert{20, 1e-4},
                               .fragments = powder::AustinFragments{0.4, 0.8, 3},
                               .method = cases::Grinding::Method::both,
                               .time = 600,
                               .smallest = 1e-6,
                               .sample = 5000};
  c.kinetics =
      cases::Kinetics{.model = powder::DoseKinetics{2e3, 1, 0}, .time = 600, .property = ""};
  return c;
}

double named(const Outcome& outcome, std::string_view name) {
  for (const results::Quantity& q : results::summarise(outcome).quantities)
    if (q.name == name) return q.value;
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}

double column_sum(const results::Table& table, std::string_view name, std::string_view times = "") {
  const auto place = [&](std::string_view which) {
    std::size_t i = 0;
    while (table.columns.at(i).name != which) ++i;
    return i;
  };
  double sum = 0;
  for (const auto& row : table.rows)
    sum += row[place(name)] * (times.empty() ? 1 : row[place(times)]);
  return sum;
}

class GrindingRun : public ::testing::Test {
 protected:
  static const Outcome& outcome() {
    static const Outcome made = run(grinding_case());
    return made;
  }
};

TEST_F(GrindingRun, stresses_are_the_collisions_of_the_run) {
  const auto chosen = results::averaged_replicates(outcome());
  const powder::StressSpectrum all = results::stress_spectrum(outcome().mill_case, chosen);
  double rate = 0, power = 0, expected_rate = 0, expected_power = 0;
  for (const powder::Stress& s : all.stresses) rate += s.rate, power += s.rate * s.energy;
  for (const auto* r : chosen) {
    expected_rate += static_cast<double>(r->tally.all.count) / r->time() / 6;
    expected_power += r->tally.all.energy_normal / r->time() / 6;
  }
  // Collisions below 2^-80 J do not stress the powder; there are none.
  states("collisions per second", rate, expected_rate, 1e-12 * expected_rate, "the tally's count");
  states("power [W]", power, expected_power, 1e-12 * expected_power, "the tally's sum of energies");
}

TEST_F(GrindingRun, table_of_the_catch_adds_up_to_the_summary) {
  const results::Table table = results::capture(outcome());
  const double rate = named(outcome(), "captured_mass_rate");
  // The table merges the bins of all replicates, the summary evaluates each replicate. The captured
  // mass is not linear in the energy within a bin a quarter of an octave wide.
  states("mass per second", column_sum(table, "rate", "mass"), rate, 1e-3 * rate, "the same catch");
  states("share hit per second over mass per second",
         named(outcome(), "captured_share_rate") / rate, 1e3, 1e-9, "a gram");
}

TEST_F(GrindingRun, sample_of_the_stream_agrees_with_the_balance_of_its_spectrum) {
  const results::Table table = results::grinding(outcome());
  const auto chosen = results::averaged_replicates(outcome());
  for (const double share : {0.1, 0.5, 0.9}) {
    std::vector<double> apart;
    for (const auto* r : chosen) {
      const auto size = [&](const powder::SizeEvolution& m) {
        return powder::quantile(m.grid, m.shares.back(), share);
      };
      apart.push_back(std::log(size(*r->grinding->sample) / size(*r->grinding->balance)));
    }
    const observe::Estimate e = observe::estimate(apart);
    // Tolerance: the standard error, and the change of the balance if the width of classes is
    // halved.
    cases::Case finer = outcome().mill_case;
    finer.grinding->classes_per_octave = 12;
    const auto spectrum = results::stress_spectrum(finer, {chosen.front()});
    const powder::SizeEvolution twelve = results::milling_by_balance(finer, spectrum);
    const powder::SizeEvolution& six = *chosen.front()->grinding->balance;
    const double classes =
        std::abs(std::log(powder::quantile(twelve.grid, twelve.shares.back(), share) /
                          powder::quantile(six.grid, six.shares.back(), share)));
    const double error = e.ci95 / 2.5706;  // Student's t of five degrees of freedom
    states("ln of sample over balance, D" + std::to_string(static_cast<int>(100 * share)), e.mean,
           0, 3 * error + 4.0 / 3 * classes, "three standard errors, and the error of classes");
  }
}

TEST_F(GrindingRun, more_power_than_the_mill_dissipates_is_warned_of) {
  const auto warned = [](const Outcome& of) {
    for (const Notice& one : parts::grinding::warnings(of))
      if (one.code == "more-than-dissipated") return true;
    return false;
  };
  EXPECT_TRUE(warned(outcome()));  // with a restitution of 0.7 half of the stress energy is lost
  cases::Case mill_case = grinding_case();
  mill_case.capture->energy = cases::Capture::Energy::lost;
  EXPECT_FALSE(warned(run(mill_case)));
}

TEST_F(GrindingRun, in_which_no_hit_is_strong_enough_says_so_with_the_strongest_hit) {
  const auto told = [](const Outcome& of) {
    for (const Notice& one : parts::grinding::warnings(of))
      if (one.code == "nothing-breaks") return one.text;
    return std::string();
  };
  EXPECT_EQ(told(outcome()), "") << "the grains break";
  cases::Case mill_case = grinding_case();
  mill_case.run.replicates = 2;
  mill_case.grinding->breakage = powder::VogelPeukert{20, 3e5};
  const std::string text = told(run(mill_case));
  // One grain in a thousand: x W = x W_min + 1e-3/f_mat, and x W_min/x = 3e5/0.3e-3 J/kg.
  EXPECT_NE(text.find("1000 kJ/g"), std::string::npos) << text;
}

TEST_F(GrindingRun, mass_is_kept_and_sizes_fall_with_time) {
  for (const auto& r : outcome().replicates)
    for (const auto* m : {&*r.grinding->balance, &*r.grinding->sample}) {
      double last = 1;
      for (const auto& shares : m->shares) {
        EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-12);
        const double now = powder::quantile(m->grid, shares, 0.9);
        EXPECT_LE(now, last * (1 + 1e-12));
        last = now;
      }
    }
}

TEST_F(GrindingRun, conversion_is_that_of_the_dissipated_dose) {
  const double dose = named(outcome(), "dissipated_power") / 1e-3 * 600;  // [J/kg]
  states("dose [J/g]", named(outcome(), "milling_dose"), dose / 1000, 1e-9 * dose, "P t/m");
  double expected = 0;
  for (const auto* r : results::averaged_replicates(outcome()))
    expected += -std::expm1(-results::dissipated_power(*r) / 1e-3 * 600 / 2e3) / 6;
  states("conversion", named(outcome(), "conversion"), expected, 1e-12, "1 - exp(-D/D_0)");
}

TEST(GroundAnew, same_case_gives_the_same_sample_on_any_number_of_threads) {
  cases::Case mill_case = grinding_case();
  mill_case.run.replicates = 2;
  RunOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const Outcome a = run(mill_case, one), b = run(mill_case, two);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(a.replicates[i].grinding->sample->shares, b.replicates[i].grinding->sample->shares);
}

TEST(GroundAnew, run_that_was_saved_and_gone_on_with_grinds_the_same) {
  cases::Case mill_case = grinding_case();
  ReplicateRun whole(mill_case, 0), first(mill_case, 0);
  while (!whole.done()) whole.run_slice();
  for (int i = 0; i < 5; ++i) first.run_slice();
  Archive out;
  first.serialize(out);
  Archive in(out.bytes());
  ReplicateRun second(mill_case, 0);
  second.serialize(in);
  while (!second.done()) second.run_slice();
  EXPECT_EQ(whole.result().grinding->sample->shares, second.result().grinding->sample->shares);
  EXPECT_EQ(whole.result().grinding->balance->shares, second.result().grinding->balance->shares);
}

}  // namespace
}  // namespace mahlwerk::campaign::grinding_test
