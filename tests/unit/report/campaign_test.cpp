// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/results/files/json_value.hpp"
#include "unit/report/campaign_fake.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::campaign_test {
namespace {

/// All cell values of one row of the table of points, unrounded.
std::vector<double> row_of(const std::string& html, std::size_t number) {
  std::size_t at = html.find("<tbody>", html.find("id=\"points\""));
  for (std::size_t i = 0; i < number; ++i) at = html.find("<tr>", at + 1);
  const std::string row = html.substr(at, html.find("</tr>", at) - at);
  constexpr std::string_view mark = "data-v=\"";
  std::vector<double> values;
  for (std::size_t k = row.find(mark); k != std::string::npos; k = row.find(mark, k + 1))
    values.push_back(std::strtod(row.c_str() + k + mark.size(), nullptr));
  return values;
}

bool sound(const std::string& html) {
  return well_formed(html) && !has(html, "\"nan") && !has(html, " nan") && !has(html, "Mnan") &&
         !has(html, "Lnan") && !has(html, "inf\"") && !has(html, "-nan") && !has(html, "infinite");
}

TEST(CampaignPage, holds_the_numbers_of_its_points_in_full) {
  const Campaign c = grid(8, 6);
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(sound(html));
  for (const std::size_t n : {1U, 20U, 48U}) {
    const Point& p = c.points[n - 1];
    const std::vector<double> row = row_of(html, n);
    ASSERT_EQ(row.size(), 4U);
    EXPECT_EQ(fmt::format("{} rpm", row[0]), p.values[0]);
    EXPECT_EQ(fmt::format("{} mm", row[1]), p.values[1]);
    EXPECT_EQ(row[2], p.value[0]);
    EXPECT_EQ(row[3], p.value[1]);
  }
}

TEST(CampaignPage, says_what_varies_what_failed_and_what_stands_out) {
  Campaign c = speeds(8);
  fail(c.points[2], "the jar is too small");
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(sound(html));
  EXPECT_TRUE(has(html,
                  "8 points. Varied keys: mill.speed from 150 rpm to 500 rpm (8 values). "
                  "1 point failed. The charge is cascading at 2, cataracting at 5."))
      << html.substr(html.find("lead"), 400);
  // 12 W (speed/300 rpm)^3 with 2 %: 1.5 W at 150 rpm, 55.6 W at 500 rpm, ratio
  // (500/150)^3 = 37.04.
  EXPECT_TRUE(
      has(html,
          "The largest change is that of dissipated power: from 1.500 ± 0.030 W (speed 150 rpm) to "
          "55.6 ± 1.1 W (speed 500 rpm), 37 times as much."));
  EXPECT_TRUE(has(html, "Run 3: the jar is too small"));
  EXPECT_TRUE(has(html, "failed: the jar is too small"));
}

TEST(CampaignPage, counts_warnings_and_notes_by_code) {
  Campaign c = speeds(8);
  EXPECT_FALSE(has(campaign_page(c, "1"), ">warnings<"));
  c.notices = {{invalid("long-contacts", "In <contact>."), 3}, {note("engine-chosen", "Soft."), 8}};
  c.points[4].warnings = "long-contacts;stopped";
  fail(c.points[2], "the jar is too small");
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(sound(html));
  EXPECT_TRUE(has(html, "3 of 8 points: long-contacts: In &lt;contact&gt;."));
  EXPECT_TRUE(has(html, "8 of 8 points: engine-chosen: Soft."));
  EXPECT_TRUE(has(html, "<th>warnings</th>"));
  EXPECT_TRUE(has(html, "<td>long-contacts, stopped</td>"));
  const std::string table = campaign_table(c);
  EXPECT_TRUE(has(table, "long-contacts;stopped"));
  EXPECT_TRUE(has(table, "warnings"));
  EXPECT_FALSE(has(campaign_table(speeds(8)), "warnings"));
  EXPECT_EQ(notice_lines(c.notices, 8, "point"),
            "Warning: 3 of 8 points: long-contacts: In <contact>.\n");
}

TEST(CampaignPage, tells_a_reason_once_for_all_that_failed_of_it) {
  Campaign c = speeds(30);
  for (Point& p : c.points) fail(p, "no space left");
  c.points[4].failure = "line one\nline two";
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(sound(html));
  EXPECT_TRUE(has(html, "30 points."));
  EXPECT_TRUE(has(html, "All of them failed."));
  EXPECT_TRUE(has(html, "Runs 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, ... (29 in all): no space left"));
  EXPECT_TRUE(has(html, "Run 5: line one<br/>line two"));
  EXPECT_FALSE(has(html, "class=\"picture\""));
}

TEST(CampaignJson, has_the_head_of_a_study_the_points_and_what_matters) {
  Campaign c = grid(2, 2);
  c.case_file = "case.toml";
  fail(c.points[1], "too large");
  c.points[2].state = campaign::RunState::waiting;
  c.sensitivities = {{.quantity = "d50",
                      .unit = "m",
                      .design = Design::morris,
                      .effects = {{.key = "mill.speed", .mean_absolute = {2, 1, 3}, .count = 4}}}};
  const results::Json made = results::Json::parse(campaign_json(c, "1.2.3"));
  const auto text = [&](const char* key) { return made.find(key)->text(); };
  EXPECT_EQ(text("study"), "\"sweep\"");
  EXPECT_EQ(text("mahlwerk"), "\"1.2.3\"");
  EXPECT_EQ(text("case"), "\"case.toml\"");
  EXPECT_TRUE(has(text("keys"), R"({"key":"mill.speed","unit":"rpm","follows":false})"));
  EXPECT_TRUE(has(text("columns"), R"({"name":"d50","unit":"m","about":"size of the)"));
  EXPECT_EQ(std::get<results::Json::Array>(made.find("points")->value()).size(), 4U);
  EXPECT_TRUE(has(text("points"), R"("values":["150 rpm","5 mm"],"status":"done")"));
  EXPECT_TRUE(has(text("points"), R"("failure":"too large","value":[null,null])"));
  EXPECT_TRUE(has(text("points"), R"("status":"waiting")"));
  EXPECT_TRUE(has(text("sensitivities"), R"("mean_absolute":{"value":2.0,"low":1.0,"high":3.0})"));
  EXPECT_TRUE(has(text("remarks"), "mill.speed matters most"));
}

TEST(CampaignJson, of_many_points_leaves_them_to_the_table) {
  EXPECT_TRUE(has(campaign_json(speeds(5001), "1"), "\"points\":null"));
}

TEST(CampaignPage, points_that_wait_have_not_failed) {
  Campaign c = grid(8, 6);
  for (std::size_t i = 40; i < 48; ++i) {
    fail(c.points[i], "");
    c.points[i].state = campaign::RunState::waiting;
  }
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(sound(html));
  EXPECT_TRUE(has(html, " 8 wait to be run."));
  EXPECT_EQ(times(html, ">not run yet</td>"), 8U);
  EXPECT_FALSE(has(html, "failed:"));
  c.points.erase(c.points.begin(), c.points.begin() + 38);
  EXPECT_TRUE(in_order(campaign_table(c), {"450 rpm", " W", "not run yet"}));
  EXPECT_FALSE(has(campaign_table(c), "failed"));
}

TEST(CampaignPage, of_little_or_strange_numbers_is_still_a_page) {
  Campaign none = speeds(0), one = speeds(1), strange = grid(4, 3);
  EXPECT_TRUE(sound(campaign_page(none, "1")));
  EXPECT_TRUE(has(campaign_page(none, "1"), "No point has been computed yet."));
  EXPECT_TRUE(sound(campaign_page(one, "1")));
  EXPECT_TRUE(
      has(campaign_page(one, "1"), "1 point. Varied keys: mill.speed (150 rpm at all points)"));
  strange.points[0].value = {NAN, INFINITY};
  strange.points[1].value = {0, -1};
  strange.points[2].ci95 = {NAN, NAN};
  strange.points[3].value = {};  // no values given
  strange.points[4].ci95 = {};
  strange.points[5].value = {1e300, 1e-300};
  std::string html = campaign_page(strange, "1");
  html.erase(html.find("<h2>Points"));  // this table prints infinite values as such
  EXPECT_EQ(html.find("nan"), std::string::npos) << html.substr(html.find("nan") - 300, 400);
  EXPECT_FALSE(pictures_in(html).empty()) << "which are JSON, so without nan and inf";
  for (Point& p : strange.points) p.value = {NAN, NAN};
  EXPECT_TRUE(sound(campaign_page(strange, "1")));
  EXPECT_TRUE(sound(campaign_page({.title = "Nothing at all"}, "1")));
}

TEST(CampaignPage, does_not_take_words_for_markup) {
  const std::string bad = "<b>&\"x\"</b>";
  Campaign c = grid(4, 3);
  c.title = bad;
  c.keys[0].key = c.keys[1].key = bad;
  c.keys[1].unit = "";
  c.columns[0].about = bad;
  for (Point& p : c.points) {
    p.values[1] += bad;
    p.regime = p.number % 2 == 0 ? bad : "rolling";
    p.folder = bad;
  }
  fail(c.points[5], bad);
  c.sensitivities = {
      {.quantity = bad, .unit = bad, .base = {.value = 1}, .effects = {{.key = bad}}}};
  c.sensitivities[0].effects[0].low.value = 2;
  c.sensitivities[0].effects[0].low_end = bad;
  const std::string html = campaign_page(c, bad);
  EXPECT_TRUE(well_formed(html));
  EXPECT_FALSE(has(html, "<b>"));
  EXPECT_TRUE(has(html, "&lt;b&gt;&amp;&quot;x&quot;"));
}

TEST(CampaignPage, of_5000_points_is_below_5_mb) {
  Campaign wide = grid(100, 50);
  for (const Campaign& c : {scattered(5000), wide}) {
    const std::string html = campaign_page(c, "1");
    EXPECT_LT(html.size(), 5U << 20U) << c.title;
    EXPECT_TRUE(has(html, "The first 1000 of 5000 points; campaign.csv has all of them."));
    const std::string table = html.substr(html.find("id=\"points\""));
    EXPECT_EQ(times(table, "<tr><td"), 1000U);
  }
}

TEST(CampaignPage, has_a_column_of_regimes_where_they_differ) {
  Campaign c = speeds(6);
  EXPECT_TRUE(has(campaign_page(c, "1"), "<th>regime</th>"));
  EXPECT_TRUE(has(campaign_table(c), "regime"));
  for (Point& p : c.points) p.regime = "rolling";
  EXPECT_FALSE(has(campaign_page(c, "1"), "<th>regime</th>"));
  EXPECT_FALSE(has(campaign_table(c), "regime"));
}

TEST(CampaignPage, links_the_runs_that_were_kept) {
  Campaign c = speeds(3);
  c.points[1].folder.clear();
  const std::string html = campaign_page(c, "1");
  EXPECT_EQ(times(html, "/report.html\""), 2U);
  EXPECT_TRUE(has(html, "<a href=\"point-003/report.html\">3</a>"));
}

TEST(CampaignTable, shows_40_points_and_says_where_the_rest_is) {
  const std::string text = campaign_table(speeds(100), "speeds/campaign.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 40 + 1);
  EXPECT_TRUE(text.ends_with("... and 60 more points: speeds/campaign.csv\n"));
  const std::string few = campaign_table(speeds(41));
  EXPECT_EQ(std::count(few.begin(), few.end(), '\n'), 1 + 41);
  EXPECT_FALSE(has(few, "more points"));
}

TEST(CampaignTable, shows_why_a_point_failed_in_short) {
  Campaign c = speeds(3);
  fail(c.points[1], "balls do not fit: " + std::string(200, 'x') + "\nsecond line");
  const std::string text = campaign_table(c);
  EXPECT_TRUE(has(text, "200 rpm     failed: balls do not fit: xxx"));
  EXPECT_TRUE(has(text, "x…\n"));
  EXPECT_FALSE(has(text, "second line"));
  EXPECT_TRUE(in_order(text, {"150 rpm", "1.500 ± 0.030 W", "200 rpm", "failed", "250 rpm"}));
}

TEST(Campaign, quantities_that_came_later_are_columns_of_their_own) {
  Campaign c;
  add(c, {.number = 1, .values = {"1"}}, {{"a", 1, 0.5, "m", "an a"}});
  add(c, {.number = 2, .values = {"2"}}, {{"b", 2, NAN, "1", "a b"}, {"a", 3, 0.25, "m", "an a"}});
  ASSERT_EQ(c.columns.size(), 2U);
  EXPECT_EQ(c.columns[0].name, "a");
  EXPECT_EQ(c.columns[0].unit, "m");
  EXPECT_EQ(c.columns[1].about, "a b");
  EXPECT_EQ(c.points[1].value, (std::vector<double>{3, 2}));
  EXPECT_EQ(c.points[1].ci95[0], 0.25);
}

}  // namespace
}  // namespace mahlwerk::report::campaign_test
