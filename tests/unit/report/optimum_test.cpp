// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/optimum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/report/match.hpp"

namespace mahlwerk::report::optimum_test {
namespace {

bool holds(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

bool says(const std::vector<std::string>& sentences, const std::string& words) {
  return std::ranges::any_of(sentences, [&](const std::string& s) { return holds(s, words); });
}

/// Replicates whose numbers no report reads.
std::vector<std::vector<double>> replicates(std::size_t count) {
  return std::vector<std::vector<double>>(count);
}

/// Two keys and a limit; the second of three settings is best, the third failed.
Optimum some() {
  Optimum made{.title = "A <mill>",
               .case_file = "case.toml",
               .outcome = {.name = "dissipated_power", .unit = "W", .about = "power"}};
  made.keys = {{.key = "mill.speed", .unit = "rpm", .text = {.from = "200 rpm", .to = "600 rpm"}},
               {.key = "mill.ratio", .text = {.from = "-3", .to = "-1"}}};
  for (KeyOptimum& k : made.keys) {
    k.text.best = k.text.low = k.text.high = k.text.from;
    k.text.model = k.text.to;
    k.text.good_low = k.text.from;
    k.text.good_high = k.text.to;
    k.x = {1, 2};
    k.slice = {{1, 0.1}, {2, 0.1}};
  }
  made.keys[0].at_high_end = true;
  made.keys[1].flat = true;
  made.limits = {{.quantity = "wear_rate", .unit = "kg/s", .text = "below 1 mg/h", .binds = true}};
  made.trials = {{.point = {},
                  .replicates = replicates(2),
                  .failure = {},
                  .round = 0,
                  .observed = {{1.5, 0.1}, {1e-10, 1e-11}},
                  .model = {1.4, 0.1},
                  .probability_feasible = 1,
                  .probability_best = 0.02,
                  .values = {"200 rpm", "-3"},
                  .x = {200, -3}},
                 {.point = {},
                  .replicates = replicates(4),
                  .failure = {},
                  .round = 1,
                  .observed = {{2.5, 0.2}, {2e-10, 1e-11}},
                  .model = {2.25, 0.125},
                  .probability_feasible = 0.9,
                  .probability_best = 0.98,
                  .values = {"598 rpm", "-2"},
                  .x = {598, -2}},
                 {.point = {},
                  .replicates = {},
                  .failure = "the ball, it does not fit",
                  .round = 1,
                  .values = {"600 rpm", "-1"},
                  .x = {600, -1}}};
  made.best = 1;
  made.model_value = {2.3, 0.2};
  made.failed = 1;
  return made;
}

/// The same report. Its best setting is outside the validity of its engine and distinct from the
/// others.
Optimum invalid_best() {
  Optimum made = some();
  made.trials[1].probability_best = 1;
  made.trials[1].notices = {invalid("long-contacts", "The balls <touch>.")};
  made.notices = {{made.trials[1].notices.front(), 2}};
  return made;
}

TEST(OptimumReport, an_optimum_outside_the_validity_of_its_engine_is_not_certain) {
  Optimum sure = some();
  sure.trials[1].probability_best = 1;
  EXPECT_TRUE(sure.certain());
  EXPECT_TRUE(says(sentences(sure), "is distinguished from all others"));
  EXPECT_FALSE(invalid_best().certain());
  const std::vector<std::string> told = sentences(invalid_best());
  EXPECT_FALSE(says(told, "is distinguished from all others"));
  EXPECT_TRUE(says(told, "The optimum is not certain"));
  EXPECT_TRUE(says(told, "(long-contacts)"));
}

TEST(OptimumReport, a_check_stands_beside_what_the_search_gave) {
  Optimum made = invalid_best();  // 2.5 W +- 0.2 W
  made.check = {.engine = cases::EngineName::soft, .value = {0.5, 0.1}, .replicates = 4};
  EXPECT_TRUE(made.disagrees());
  EXPECT_TRUE(says(sentences(made),
                   "the soft engine gives a dissipated power of 500 ± 100 mW (4 "
                   "replicates), the search gave 2.50 ± 0.20 W: the two disagree"))
      << optimum_table(made);
  EXPECT_TRUE(holds(optimum_table(made), "500 ± 100 mW"));
  EXPECT_TRUE(holds(optimum_page(made, "1"), "500 ± 100 mW"));
  made.check->value = {2.3, 0.1};
  EXPECT_FALSE(made.disagrees());
  EXPECT_TRUE(says(sentences(made), "the two agree"));
  made.check->value = {1.5, NAN};  // one replicate
  EXPECT_TRUE(made.disagrees());
  made.check->value = {2.4, NAN};
  EXPECT_FALSE(made.disagrees());
}

TEST(OptimumReport, says_why_the_best_was_not_checked) {
  Optimum made = invalid_best();
  made.check = {.engine = cases::EngineName::soft, .failure = "it takes too long"};
  EXPECT_FALSE(made.disagrees());
  EXPECT_TRUE(says(sentences(made), "was not checked by the soft engine: it takes too long"));
}

TEST(OptimumReport, counts_the_warnings_of_its_settings) {
  const Optimum made = invalid_best();
  EXPECT_TRUE(
      holds(optimum_table(made), "Warning: 2 of 3 settings: long-contacts: The balls <touch>."));
  EXPECT_TRUE(
      holds(optimum_page(made, "1"), "2 of 3 settings: long-contacts: The balls &lt;touch&gt;."));
  EXPECT_TRUE(holds(optimum_csv(made), ",failure,warnings\n"));
  EXPECT_TRUE(holds(optimum_csv(made), ",long-contacts\n"));
}

TEST(OptimumReport, says_what_is_sure_and_what_is_not) {
  const std::vector<std::string> told = sentences(some());
  EXPECT_TRUE(says(told, "probability of 98 %"));
  EXPECT_TRUE(says(told, "flat in mill.ratio: any value from -3 to -1"));
  EXPECT_FALSE(says(told, "flat in mill.speed"));
  EXPECT_TRUE(says(told, "best mill.speed lies at the upper end of its range, 600 rpm"));
  EXPECT_FALSE(says(told, "best mill.ratio lies"));
  EXPECT_TRUE(says(told, "below 1 mg/h\" is active"));
  EXPECT_TRUE(says(told, "is a prediction"));
  EXPECT_TRUE(says(told, "1 of 3 settings could not be run"));
  Optimum free = some();
  free.limits[0].binds = false;
  EXPECT_TRUE(says(sentences(free), "is not active"));
}

TEST(OptimumReport, says_no_more_than_that_the_best_is_told) {
  Optimum told = some();
  told.trials[1].probability_best = 1;
  for (KeyOptimum& k : told.keys) k.text.model = k.text.best;
  EXPECT_TRUE(says(sentences(told), "distinguished from all others"));
  EXPECT_FALSE(says(sentences(told), "the expected loss is"));
  EXPECT_FALSE(says(sentences(told), "prediction"));
}

TEST(OptimumReport, says_that_there_is_no_best) {
  Optimum none = some();
  none.best.reset();
  EXPECT_TRUE(says(sentences(none), "likely to satisfy the limits"));
  none.failed = 3;
  EXPECT_TRUE(says(sentences(none), "could be run"));
  EXPECT_FALSE(holds(optimum_table(none), "best tried"));
  EXPECT_FALSE(holds(optimum_page(none, "1"), "<h2>The best settings</h2>"));
}

TEST(OptimumReport, table_has_the_best_and_its_means) {
  const std::string table = optimum_table(some());
  EXPECT_TRUE(holds(table, "2.25 ± 0.12 W") || holds(table, "2.25 ± 0.13 W")) << table;
  EXPECT_TRUE(holds(table, "mean of its own 4 replicates: 2.5"));
  EXPECT_TRUE(holds(table, "3 settings tried, 6 runs"));
}

TEST(OptimumReport, an_interval_without_width_is_told_as_an_end_of_the_range_or_as_its_value) {
  Optimum found = some();  // both intervals are points, the first key's at an end
  EXPECT_TRUE(holds(optimum_table(found), "at the end of its range"));
  EXPECT_TRUE(holds(optimum_page(found, "1"), "at the end of its range</td>"));
  EXPECT_FALSE(holds(optimum_page(found, "1"), "-3 to -3"));
  found.keys[0].text.high = "210 rpm";
  EXPECT_TRUE(holds(optimum_table(found), "200 rpm to 210 rpm"));
}

TEST(OptimumReport, csv_has_a_row_per_setting_and_reads_back) {
  const std::string csv = optimum_csv(some());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
  EXPECT_TRUE(
      csv.starts_with("setting,round,replicates,mill.speed,mill.ratio,dissipated_power,"
                      "dissipated_power_ci95,dissipated_power_model,"
                      "dissipated_power_model_ci95,wear_rate,wear_rate_ci95,allowed,"
                      "chance_best,failure,warnings\n"))
      << csv;
  EXPECT_TRUE(holds(csv, "2,1,4,598 rpm,-2,2.5,0.2,2.25,0.125,2e-10,1e-11,0.9,0.98,,\n")) << csv;
  EXPECT_TRUE(holds(csv, "\"the ball, it does not fit\""));
}

TEST(OptimumReport, page_is_safe_and_shows_every_setting) {
  const std::string page = optimum_page(some(), "1.2.3");
  EXPECT_TRUE(holds(page, "A &lt;mill&gt;"));
  EXPECT_FALSE(holds(page, "<mill>"));
  EXPECT_TRUE(holds(page, "598 rpm"));
  EXPECT_TRUE(holds(page, "the ball, it does not fit"));
  EXPECT_FALSE(holds(page, "nan"));
  EXPECT_EQ(optimum_plots(some()).size(), 3U);
}

TEST(OptimumReport, history_is_the_best_until_then) {
  const Plot history = optimum_plots(some()).front();
  const Series& best = history.series.back();
  EXPECT_EQ(best.x, (std::vector<double>{1, 2, 3}));  // from the first setting on
  EXPECT_EQ(best.y, (std::vector<double>{1.4, 2.25, 2.25}));
  EXPECT_EQ(history.series.front().x.size(), 2U);  // without the one that failed
}

MatchResult matched() {
  MatchResult made{.title_a = "A", .title_b = "B", .file_a = "a.toml", .file_b = "b.toml"};
  made.by_powder = true;
  campaign::Difference& d = made.difference;
  d.dose_a = {100, 5};
  d.dose_b = {110, 5};
  d.energy_a = d.energy_b = {1e-3, 1e-4};
  d.dose = {1.1, 1.02, 1.19};
  d.half_power = {1, 0.9, 1.1};
  d.overlap = 0.87;
  d.distance = 0.15;
  d.p_value = 0.31;
  made.a.mean.shares = {0.5, 0.5, 0};
  made.b.mean.shares = {0.2, 0.8, 0};
  made.search = some();
  return made;
}

TEST(MatchReport, says_whether_the_mills_do_the_same) {
  MatchResult found = matched();
  EXPECT_TRUE(says(sentences(found), "cannot be distinguished"));
  EXPECT_TRUE(says(sentences(found), "31 of 100"));
  EXPECT_TRUE(says(sentences(found), "mill.speed could not be matched within its range"));
  found.difference.p_value = 0.001;
  EXPECT_TRUE(says(sentences(found), "still differ"));
  found.difference.p_value = NAN;
  EXPECT_TRUE(says(sentences(found), "scatter is unknown"));
}

TEST(MatchReport, says_what_to_set_how_hits_change_and_what_cannot_be_matched) {
  MatchResult found = matched();
  found.difference.dose = {1.05, 0.98, 1.12};
  EXPECT_TRUE(says(sentences(found), "Set B to mill.speed = "));
  EXPECT_TRUE(says(sentences(found), "about as large as in A"));
  EXPECT_TRUE(says(sentences(found), "loses about as much as one of A on average"));
  EXPECT_FALSE(says(sentences(found), "The dose rate cannot be matched"));
  EXPECT_FALSE(says(sentences(found), "13 % of the power of B")) << "no more than by chance";
  found.difference.p_value = 0.001;
  EXPECT_TRUE(says(sentences(found), "13 % of the power of B"));
  found.difference.energy_b = {0.2e-3, 1e-5};
  found.difference.dose_b = {50, 2};
  found.difference.dose = {0.5, 0.45, 0.55};
  found.difference.half_power = {0.1, 0.09, 0.11};
  EXPECT_TRUE(says(sentences(found), "0.5 times as large as in A"));
  EXPECT_TRUE(says(sentences(found), "loses 0.2 times as much as one of A on average"));
  EXPECT_TRUE(says(sentences(found), "2.5 times as many collisions as A"));
  EXPECT_TRUE(says(sentences(found), "The dose rate cannot be matched"));
  EXPECT_TRUE(says(sentences(found), "Larger or heavier balls would change that"));
  found.difference.overlap = 0.97;
  EXPECT_FALSE(says(sentences(found), "balls would change that"));
}

TEST(MatchReport, tells_of_a_best_outside_the_validity_of_its_engine_and_counts_both_mills) {
  MatchResult found = matched();
  found.search = invalid_best();
  found.notices = {{invalid("long-contacts", "They touch."), 1}};
  EXPECT_TRUE(says(sentences(found), "The optimum is not certain"));
  EXPECT_TRUE(holds(match_table(found), "Warning: 1 of 2 mills: long-contacts: They touch."));
  EXPECT_TRUE(holds(match_page(found, "1"), "1 of 2 mills: long-contacts: They touch."));
}

TEST(MatchReport, shows_both_mills) {
  const std::string table = match_table(matched());
  EXPECT_TRUE(holds(table, "100.0 ± 5.0 W/kg")) << table;
  EXPECT_TRUE(holds(table, "1.1 (1.02 to 1.19)")) << table;
  EXPECT_TRUE(holds(table, "87 %"));
  EXPECT_TRUE(holds(table, "probability of 98 %")) << table;
  const std::string page = match_page(matched(), "1");
  EXPECT_TRUE(holds(page, "distance of the means"));
  EXPECT_TRUE(holds(page, "their scatter increases their distance, to 2.25"));
  EXPECT_TRUE(holds(page, "Do the mills agree?"));
  EXPECT_FALSE(holds(page, "nan"));
  const Plot plot = match_plot(matched());
  EXPECT_EQ(plot.series[0].y, (std::vector<double>{50, 50}));
  EXPECT_EQ(plot.series[1].y, (std::vector<double>{20, 80}));
  EXPECT_EQ(plot.series[1].x.size(), 3U);
}

}  // namespace
}  // namespace mahlwerk::report::optimum_test
