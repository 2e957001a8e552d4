// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <set>

#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/quantities/means.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::summary_test {
namespace {

double value(const Outcome& o, const std::string& name) {
  return named(summarise(o).quantities, name).value;
}

TEST(Summary, rates_are_means_over_replicates) {
  const std::vector<Quantity> list = summarise(fake_outcome()).quantities;
  const Quantity& rate = named(list, "collision_rate");
  EXPECT_DOUBLE_EQ(rate.value, 12);                             // 10, 12, 14
  EXPECT_NEAR(rate.ci95, 4.30265273 * 2 / std::sqrt(3), 1e-6);  // their spread is 2
  EXPECT_EQ(rate.unit, "1/s");
  EXPECT_DOUBLE_EQ(named(list, "collision_rate_above_threshold").value, 6);
}

TEST(Summary, means_over_collisions_with_and_without_the_threshold) {
  const Outcome o = fake_outcome();
  EXPECT_NEAR(value(o, "energy_normal_mean_above_threshold"), 0.004, 1e-15);
  EXPECT_NEAR(value(o, "energy_normal_mean"), 0.5 * (0.004 + 2.5e-6), 1e-15);
  EXPECT_NEAR(value(o, "energy_contact_point_mean_above_threshold"), 0.008, 1e-15);
  EXPECT_NEAR(value(o, "energy_centre_mean_above_threshold"), 0.005, 1e-15);
  EXPECT_NEAR(value(o, "energy_lost_mean"), 0.001, 1e-15);
  EXPECT_NEAR(value(o, "impact_speed_normal_mean"), 1.025, 1e-12);
  EXPECT_NEAR(value(o, "impact_speed_tangential_mean_above_threshold"), 2, 1e-12);
  EXPECT_NEAR(value(o, "impact_angle_mean_above_threshold"), 45, 2e-6);
  EXPECT_NEAR(value(o, "impact_angle_mean"), 22.5, 2e-6);
}

TEST(Summary, powers_and_shares_leave_out_what_was_before_counting) {
  const Outcome o = fake_outcome();
  EXPECT_NEAR(value(o, "dissipated_power"), 0.012, 1e-12);
  EXPECT_NEAR(value(o, "drawn_power"), 0.512, 1e-12);
  EXPECT_NEAR(value(o, "contact_time_share"), 0.2, 1e-15);
  EXPECT_NEAR(value(o, "lasting_contacts_rate"), 0.4, 1e-15);
  EXPECT_NEAR(value(o, "simulated_time"), 10, 1e-15);
  EXPECT_EQ(value(o, "replicates"), 3);
}

// (obs.14, obs.15) Solid volumes over 0.6; the voids of the balls are 0.4 of their bulk volume.
TEST(Summary, a_drum_states_its_speed_and_the_bulk_fillings_of_balls_and_powder) {
  Outcome o = fake_outcome();
  EXPECT_THROW(value(o, "bulk_filling"), std::exception) << "no drum";
  o.mill_case.mill.motion = kinematics::Tumbling{-std::numbers::pi};
  EXPECT_THROW(value(o, "bulk_filling"), std::exception) << "upright: tumbles end over end";
  o.mill_case.mill.jar_axis = kinematics::Tumbling::jar_axis;
  geometry::Cylinder jar;
  jar.diameter = 0.2;
  jar.height = 0.1;
  o.mill_case.jar.shape = jar;
  o.mill_case.balls = {{100, 0.02, 7800, ""}};
  o.mill_case.powder.emplace().mass = 0.5;
  EXPECT_THROW(value(o, "void_filling"), std::exception) << "no density of the powder";
  o.mill_case.powder->density = 2700;
  EXPECT_NEAR(value(o, "drum_speed"), 30, 1e-12);
  const double bulk = 100 * std::numbers::pi / 6 * 8e-6 / 0.6;  // [m3] of the balls
  EXPECT_NEAR(value(o, "bulk_filling"), bulk / (std::numbers::pi * 1e-3), 1e-12);
  EXPECT_NEAR(value(o, "void_filling"), 0.5 / 2700 / 0.6 / (0.4 * bulk), 1e-12);
}

// (obs.16, obs.17) 0.512 W are drawn at two turns a second; the balls' bulk density is 4680 kg/m3.
TEST(Summary, a_stirrer_states_its_torque_and_power_number) {
  Outcome o = fake_outcome();
  geometry::Attritor vessel;
  vessel.diameter = 0.1;
  vessel.height = 0.12;
  vessel.arm_span = 0.08;
  vessel.rotor_speed = -4 * std::numbers::pi;
  o.mill_case.jar.shape = vessel;
  o.mill_case.balls = {{10, 0.01, 7800, ""}};
  o.mill_case.mill.motion = kinematics::Still{};
  EXPECT_NEAR(value(o, "rotor_torque"), 0.512 / (4 * std::numbers::pi), 1e-12);
  EXPECT_NEAR(value(o, "power_number"), 0.512 / (4680 * 8 * std::pow(0.08, 5)), 1e-9);
  o.mill_case.mill.motion = kinematics::Vibration{};
  EXPECT_THROW(value(o, "rotor_torque"), std::exception) << "the vessel works, too";
}

// (obs.13) 50, 60 and 70 of 100, 120 and 140 hits are above the threshold; each hit loses 0.75 mJ
// along the normal and 0.25 mJ across it, and nothing else is dissipated.
TEST(Summary, the_impact_efficiency_is_the_normal_loss_of_hits_over_all_losses) {
  EXPECT_NEAR(value(fake_outcome(), "impact_efficiency"), 0.5 * 0.75, 1e-12);
  Outcome idle = fake_outcome();
  for (Replicate& r : idle.replicates) r.energy_balance.lost_normal = r.at_settled.lost_normal;
  EXPECT_TRUE(std::isnan(value(idle, "impact_efficiency")));
}

TEST(Summary, residuals_are_those_of_the_worst_replicate) {
  Outcome o = fake_outcome();
  EXPECT_DOUBLE_EQ(value(o, "energy_residual"), 1.4e-13);
  EXPECT_LT(value(o, "energy_balance"), 1e-15);
  o.replicates[1].energy_balance.kinetic = 0.1;  // energy from nothing
  const scene::EnergyBalance& a = o.replicates[1].energy_balance;
  EXPECT_NEAR(value(o, "energy_balance"), 0.1 / (a.wall_work + a.lost()), 1e-12);
  EXPECT_TRUE(std::isnan(named(summarise(o).quantities, "energy_balance").ci95));
}

TEST(Summary, without_power_there_is_no_imbalance_and_rounding_is_no_power) {
  Outcome o = fake_outcome({100, 100});
  for (Replicate& r : o.replicates) {
    r.energy_balance = r.at_settled;
    r.energy_balance.time = 11;
    r.energy_balance.kinetic = 1;
    r.energy_balance.lost_normal -= 1e-15;  // sums of elastic collisions
  }
  EXPECT_EQ(value(o, "dissipated_power"), 0);
  EXPECT_EQ(value(o, "drawn_power"), 0);
  EXPECT_TRUE(std::isnan(value(o, "power_imbalance"))) << "0/0";
  for (Replicate& r : o.replicates) r.energy_balance.lost_normal += 1e-9;
  EXPECT_NEAR(value(o, "dissipated_power"), 1e-10, 1e-15) << "above rounding";
  EXPECT_EQ(value(o, "power_imbalance"), -1) << "a charge that slows down";
}

TEST(Summary, an_interval_below_rounding_is_zero) {
  Quantity q{"contact_time_share", 0, 0, "1", ""};
  combine(q, {1 - 1e-15, 1 + 1e-15}, Interval::of_mean);
  EXPECT_EQ(q.ci95, 0);
  combine(q, {1 - 1e-9, 1 + 1e-9}, Interval::of_mean);
  EXPECT_NEAR(q.ci95, 12.7062 * 1e-9, 1e-13) << "Student's t for one degree of freedom";
}

TEST(Summary, one_replicate_has_no_interval) {
  const std::vector<Quantity> list = summarise(fake_outcome({100})).quantities;
  EXPECT_DOUBLE_EQ(named(list, "collision_rate").value, 10);
  EXPECT_TRUE(std::isnan(named(list, "collision_rate").ci95));
}

TEST(Summary, without_collisions_there_is_no_mean_energy) {
  const Outcome o = fake_outcome({0, 0});
  EXPECT_EQ(value(o, "collision_rate"), 0);
  EXPECT_TRUE(std::isnan(value(o, "energy_normal_mean")));
}

TEST(Summary, without_any_time_nothing_is_known) {
  Outcome o = fake_outcome();
  o.replicates.assign(2, Replicate(0.1));
  EXPECT_TRUE(std::isnan(value(o, "collision_rate")));
  EXPECT_EQ(value(o, "replicates"), 0);
  EXPECT_FALSE(complete(o));
}

TEST(Summary, replicates_cut_short_are_left_out_while_there_are_two_others) {
  Outcome o = fake_outcome({100, 120, 1000});
  o.replicates[2].complete = false;
  EXPECT_FALSE(complete(o));
  EXPECT_DOUBLE_EQ(value(o, "collision_rate"), 11);
  EXPECT_EQ(value(o, "replicates"), 2);
  o.replicates[1].complete = false;
  EXPECT_EQ(value(o, "replicates"), 3);
}

TEST(Summary, doses_need_powder) {
  Outcome o = fake_outcome();
  EXPECT_THROW(value(o, "specific_energy_dose"), std::out_of_range);
  o.mill_case.powder = cases::Powder{"tic", 0.002, {}, {}};
  EXPECT_NEAR(value(o, "specific_energy_dose_rate"), 0.012 / 2, 1e-12);  // W/g
  EXPECT_TRUE(std::isnan(value(o, "specific_energy_dose"))) << "10 s are no milling time";
  EXPECT_NEAR(value(o, "specific_energy_dose_per_hour"), 0.006 * 3600, 1e-9);
  // Replicates of 10, 12 and 14 mW: the mean of their times.
  const double inverse = (1 / 0.005 + 1 / 0.006 + 1 / 0.007) / 3;
  EXPECT_NEAR(value(o, "time_to_dose"), 1000 * inverse, 1e-6);  // 1 kJ/g
  o.mill_case.milling = cases::MillingTime{.time = 1800, .dose = 2e6};
  EXPECT_NEAR(value(o, "specific_energy_dose"), 0.006 * 1800, 1e-9);
  EXPECT_NEAR(value(o, "time_to_dose"), 2000 * inverse, 1e-6);
  o.mill_case.milling.reset();
  EXPECT_THROW(value(o, "milling_time"), std::out_of_range);
}

TEST(Summary, a_dose_is_over_the_time_that_the_case_says_the_mill_works) {
  Outcome o = fake_outcome();  // 0.006 W/g in 10 s
  o.mill_case.powder = cases::Powder{"tic", 0.002, {}, {}};
  o.mill_case.heat = cases::Heat{.milling = 600, .pause = 300, .cycles = 4};
  EXPECT_NEAR(value(o, "milling_time"), 2400, 1e-9);
  EXPECT_NEAR(value(o, "specific_energy_dose"), 0.006 * 2400, 1e-9);
  o.mill_case.kinetics.emplace().time = 1800;
  EXPECT_NEAR(value(o, "specific_energy_dose"), 0.006 * 1800, 1e-9);
  o.mill_case.grinding.emplace().time = 3600;
  EXPECT_EQ(cases::milling_time(o.mill_case), 3600);
  EXPECT_EQ(value(o, "simulated_time"), 10);
}

TEST(Summary, the_tc_rule_tells_its_share) {
  Outcome o = fake_outcome({100, 100});
  EXPECT_THROW(value(o, "tc_collision_share"), std::out_of_range);
  o.mill_case.contact.lasting = cases::SustainedContactModel::tc;
  double lost = 0, hits = 0;  // of a replicate
  for (Replicate& r : o.replicates) {
    r.energy_balance.tc_collisions = 25;
    r.at_settled.lost_within = 0.5;
    lost = r.energy_balance.lost() - r.at_settled.lost();
    hits = static_cast<double>(r.tally.above.count);
    r.energy_balance.lost_within = 0.5 + 0.3 * lost;
    r.energy_balance.hits_within = 4;
    r.energy_balance.withheld = 2 * lost;
  }
  EXPECT_DOUBLE_EQ(value(o, "tc_collision_share"), 0.25);
  EXPECT_NEAR(value(o, "power_share_within_contact_time"), 0.3, 1e-12);
  EXPECT_NEAR(value(o, "hit_share_within_contact_time"), 4 / hits, 1e-12);
  EXPECT_NEAR(value(o, "withheld_power_share"), 2, 1e-12);
  o.mill_case.run.engine = cases::EngineName::soft;  // has no such rule
  EXPECT_THROW(value(o, "tc_collision_share"), std::out_of_range);
}

TEST(Summary, every_quantity_is_named_once_and_explained) {
  Outcome o = fake_outcome();
  o.mill_case.powder = cases::Powder{"tic", 0.002, {}, {}};
  std::set<std::string> names;
  for (const Quantity& q : summarise(o).quantities) {
    EXPECT_TRUE(names.insert(q.name).second) << q.name;
    EXPECT_FALSE(q.unit.empty()) << q.name;
    EXPECT_FALSE(q.about.empty()) << q.name;
  }
}

}  // namespace
}  // namespace mahlwerk::results::summary_test
