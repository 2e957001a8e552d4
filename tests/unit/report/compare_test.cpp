// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/report/html.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report::compare_test {
namespace {

using results::fake_outcome;

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// A comparison in which the soft engine counts twice as many collisions.
Comparison doubled() {
  auto soft = fake_outcome({200, 240, 280});
  soft.cpu_seconds = 3;
  soft.notices = {note("time-step", "Steps are <short>.")};
  return compare(fake_outcome({100, 120, 140}), soft);
}

const EnginePair& of(const Comparison& c, std::string_view name) {
  const auto same = [&](const ComparedQuantity& q) { return q.name == name; };
  return std::find_if(c.quantities.begin(), c.quantities.end(), same)->estimates;
}

TEST(Beside, ratio_and_its_half_width_follow_from_both) {
  const EnginePair b{{10, 1}, {20, 4}};
  EXPECT_DOUBLE_EQ(b.ratio(), 2);
  EXPECT_DOUBLE_EQ(b.ratio_ci95(), 2 * std::hypot(0.1, 0.2));
  EXPECT_TRUE(b.differs());
  EXPECT_FALSE((EnginePair{{10, 6}, {20, 4}}).differs()) << "they touch";
  EXPECT_FALSE((EnginePair{{10, NAN}, {20, 4}}).differs()) << "interval unknown";
}

TEST(Compare, sets_the_same_quantities_beside_each_other) {
  const Comparison c = doubled();
  EXPECT_DOUBLE_EQ(of(c, "collision_rate").event.mean, 12);
  EXPECT_DOUBLE_EQ(of(c, "collision_rate").soft.mean, 24);
  EXPECT_NEAR(of(c, "dissipated_power").ratio(), 2, 1e-12);
  EXPECT_NEAR(of(c, "impact_speed_normal_mean").ratio(), 1, 1e-12);
  EXPECT_FALSE(of(c, "impact_speed_normal_mean").differs());
  EXPECT_DOUBLE_EQ(of(c, "computing_time").ratio(), 6);
  for (const ComparedQuantity& q : c.quantities) {
    EXPECT_NE(q.name, "energy_balance");
    EXPECT_NE(q.name, "replicates");
  }
}

TEST(Compare, spectra_hold_every_collision_once) {
  const Comparison c = doubled();
  for (const auto* bins : {&c.speeds, &c.energies, &c.speed_curve, &c.energy_curve}) {
    double event = 0, soft = 0;
    for (std::size_t i = 0; i < bins->size(); ++i) {
      event += (*bins)[i].rate.event.mean;
      soft += (*bins)[i].rate.soft.mean;
      if (i > 0) {
        EXPECT_EQ((*bins)[i].low, (*bins)[i - 1].high);
      }
    }
    EXPECT_NEAR(event, 12, 1e-12);
    EXPECT_NEAR(soft, 24, 1e-12);
  }
  EXPECT_DOUBLE_EQ(c.speeds.back().low, 2);  // hard collisions have 2 m/s, 4 mJ
  EXPECT_DOUBLE_EQ(c.speeds.back().rate.event.mean, 6);
  EXPECT_LE(c.energies.back().low, 0.004);
  EXPECT_GT(c.energies.back().high, 0.004);
  EXPECT_DOUBLE_EQ(c.energies.back().high, 4 * c.energies.back().low);
}

TEST(Compare, slowest_are_counted_in_the_last_row) {
  auto event = fake_outcome();
  for (results::Replicate& r : event.replicates) {
    scene::Collision slow = results::fake_collisions(1).front();
    slow.approach = 1e-7;
    r.tally.collisions({&slow, 1});
  }
  const Comparison c = compare(event, fake_outcome());
  EXPECT_EQ(c.speeds.size(), 10U);
  EXPECT_EQ(c.speeds.front().low, 0);
  EXPECT_NEAR(c.speeds.front().rate.event.mean, 0.1, 1e-12);
  EXPECT_EQ(c.speeds.front().rate.soft.mean, 0);
}

TEST(Compare, table_csv_and_page_show_both_columns) {
  const Comparison c = doubled();
  const std::string table = compare_table(c);
  for (const char* part : {"soft/event", "12.0 ± 5.0 /s", "24.0 ± 9.9 /s", "2 to 4 m/s",
                           "How to read it", "soft engine: Steps are <short>."})
    EXPECT_TRUE(has(table, part)) << part << "\n" << table;
  const std::string csv = compare_csv(c);
  EXPECT_TRUE(has(csv, "\ncollision_rate,1/s,12,")) << csv;
  EXPECT_TRUE(has(csv, ",2,4,m/s\n")) << csv;
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  for (std::size_t at = 0; at < csv.size(); at = csv.find('\n', at) + 1)
    EXPECT_EQ(commas(csv.substr(at, csv.find('\n', at) - at)), 11);
  const std::string html = compare_page(c, "1.2.3");
  for (const char* part : {"class=\"picture\"", "href=\"soft/report.html\"",
                           "Steps are &lt;short&gt;.", "A &lt;fake&gt; case &amp; more", "≠"})
    EXPECT_TRUE(has(html, part)) << part;
  for (const char* part : {"nan", "inf", "src=", "href=\"http"})
    EXPECT_FALSE(has(without_scripts(html), part));
}

TEST(Compare, says_where_the_case_means_another_thing_to_each_engine) {
  auto event = fake_outcome();
  event.mill_case.contact.rule.tangential_restitution = 0;  // surfaces stick as by friction
  EXPECT_EQ(compare(event, fake_outcome()).caution, "");
  event.mill_case.contact.rule.tangential_restitution = 0.9;
  const Comparison c = compare(event, fake_outcome());
  EXPECT_TRUE(has(c.caution, "tangential_restitution = 0.9"));
  EXPECT_TRUE(has(compare_table(c), c.caution));
  EXPECT_TRUE(has(compare_page(c, "1"), c.caution));
}

TEST(Compare, of_nothing_is_still_a_page) {
  auto none = fake_outcome();
  none.replicates.assign(2, results::Replicate(0.1));
  none = ended(std::move(none));
  const Comparison c = compare(none, none);
  EXPECT_TRUE(c.speeds.empty());
  EXPECT_TRUE(has(compare_page(c, "1"), "</html>"));
  EXPECT_TRUE(has(compare_table(compare(fake_outcome(), none)), "-"));
  EXPECT_FALSE(has(compare_page(compare(fake_outcome({5}), none), "1"), "nan"));
}

}  // namespace
}  // namespace mahlwerk::report::compare_test
