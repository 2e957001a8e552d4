// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::by_pair_test {
namespace {

using tests::states;

/// Five large balls, some smaller ones of two sizes, and grains, in a shaken jar.
cases::Case mixed(const std::string& engine) {
  cases::Case c;
  kinematics::Vibration shaken;
  shaken.frequency = 20;
  shaken.amplitude = 0.01;
  c.mill.motion = shaken;
  c.jar.shape = geometry::Cylinder{0.04, 0.04};
  cases::BallSet small{30, 3e-3, 7850, "", {70e6, 0.3}};
  small.classes = {{2e-3, 10}, {3e-3, 20}};
  cases::BallSet grains{40, 1.5e-3, 4930, "", {70e6, 0.3}};
  grains.grains = true;
  c.balls = {{5, 8e-3, 7850, "", {70e6, 0.3}}, small, grains};
  c.powder =
      cases::Powder{.material = "", .mass = 40 * grains.mass(), .size = 1e-4, .density = 4930};
  c.powder->grain_size = 1.5e-3;
  c.contact.rule.restitution = 0.7;
  c.contact.rule.friction = 0.3;
  c.contact.lasting = cases::SustainedContactModel::tc;
  c.contact.contact_time = 1e-4;
  c.run.engine = cases::to_enum<cases::EngineName>(engine, cases::engines());
  c.run.time = 0.2;
  c.run.replicates = 2;
  c.observe.threshold = 0.1;
  return c;
}

class ByPairOfARun : public testing::TestWithParam<const char*> {};

TEST_P(ByPairOfARun, sums_to_the_totals) {
  RunOptions options;
  options.threads = 2;
  const results::Outcome outcome = run(mixed(GetParam()), options);
  for (const results::Replicate& r : outcome.replicates) {
    observe::PairSums all, above;
    for (int i = 0; i < r.tally.by_pair.pairs(); ++i) {
      all.add(r.tally.by_pair[i].all());
      above.add(r.tally.by_pair[i].above);
    }
    EXPECT_GT(r.tally.all.count, 1000);
    EXPECT_EQ(all.count, r.tally.all.count);
    EXPECT_EQ(above.count, r.tally.above.count);
    const std::string why = "the same numbers in another order";
    states("normal energy, share", all.energy_normal / r.tally.all.energy_normal, 1, 1e-12, why);
    states("lost, share", (all.lost_normal + all.lost_tangential) / r.tally.all.lost, 1, 1e-12,
           why);
  }
  const auto pairs = results::by_pair(outcome);
  EXPECT_EQ(pairs.size(), 9U);
  double rate = 0;
  for (const results::PairSummary& pair : pairs) rate += pair.quantities.front().value;
  const std::vector<results::Quantity>& whole = outcome.summary.quantities;
  states("collisions per second", rate / whole.front().value, 1, 1e-12, "collision_rate");
  EXPECT_EQ(pairs.front().one, "balls.1");
  EXPECT_EQ(pairs.back().one, "powder");
  EXPECT_EQ(pairs.back().other, "jar");
}

TEST_P(ByPairOfARun, is_the_same_after_a_state_was_written_and_read) {
  const cases::Case mill_case = mixed(GetParam());
  ReplicateRun whole(mill_case, 0), first(mill_case, 0), second(mill_case, 0);
  while (!whole.done()) whole.run_slice();
  for (int i = 0; i < 5 && !first.done(); ++i) first.run_slice();
  Archive out;
  first.serialize(out);
  Archive in(out.bytes());
  second.serialize(in);
  in.finish();
  while (!second.done()) second.run_slice();
  const results::Replicate one = whole.result(), other = second.result();
  for (int i = 0; i < one.tally.by_pair.pairs(); ++i) {
    EXPECT_EQ(one.tally.by_pair[i].all().count, other.tally.by_pair[i].all().count);
    EXPECT_EQ(one.tally.by_pair[i].all().energy_normal, other.tally.by_pair[i].all().energy_normal);
    EXPECT_EQ(one.tally.by_pair[i].above.lost_normal, other.tally.by_pair[i].above.lost_normal);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, ByPairOfARun, testing::Values("event", "soft"),
                         [](const auto& of) { return std::string(of.param); });

TEST(ByPairOfARun, a_single_ball_has_no_table) {
  cases::Case c = mixed("event");
  c.powder.reset();
  c.balls = {{1, 8e-3, 7850, ""}};
  c.contact.lasting = cases::SustainedContactModel::roll;
  EXPECT_TRUE(results::by_pair(run(c)).empty());
}

TEST(ByPairOfARun, print_report_and_summary_tell_it) {
  const results::Outcome outcome = run(mixed("event"));
  const std::string printed = report::pair_table(results::by_pair(outcome), 0.1);
  EXPECT_NE(printed.find("\nballs.1 with powder  "), std::string::npos) << printed;
  EXPECT_NE(report::report_page(outcome, "1").find("Collisions by pair"), std::string::npos);
  const std::string summary = results::summary_json(outcome, "1");
  for (const char* words :
       {"\"_pairs\": [", "\"coarse_graining_ratio\": {", "Powder as grains: 40"})
    EXPECT_NE(summary.find(words), std::string::npos) << words;
}

TEST(ByPairOfARun, tables_name_sets_and_units) {
  const results::Outcome outcome = run(mixed("event"));
  const std::string rates = results::csv(results::collisions_by_pair(results::by_pair(outcome)));
  EXPECT_TRUE(rates.starts_with("one,other,collision_rate_per_s,collision_rate_ci95_per_s,"))
      << rates;
  EXPECT_NE(rates.find("\nballs.2,powder,"), std::string::npos) << rates;
  const std::string spectra = results::csv(results::spectra_by_pair(outcome));
  EXPECT_TRUE(spectra.starts_with(
      "one,other,energy_low_J,energy_high_J,rate_normal_per_s,rate_contact_point_per_s,"))
      << spectra;
  const std::string sizes = results::csv(results::sizes(outcome.mill_case));
  EXPECT_TRUE(
      sizes.starts_with("set,diameter_m,count,mass_share\nballs.1,0.008,5,1\nballs.2,0.002,10,"))
      << sizes;
}

}  // namespace
}  // namespace mahlwerk::campaign::by_pair_test
