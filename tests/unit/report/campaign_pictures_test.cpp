// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mahlwerk/report/campaign/plots.hpp"
#include "unit/report/campaign_fake.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::campaign_pictures_test {
namespace {

using nlohmann::json;
using Names = std::multiset<std::string>;

std::string page_of(const Campaign& c) {
  const std::string page = campaign_page(c, "1");
  EXPECT_TRUE(well_formed(page));
  return page;
}

Names names(const Campaign& c) {
  const std::vector<std::string> list = picture_names(page_of(c));
  return {list.begin(), list.end()};
}

/// The first picture of the page with this kind and title.
json picture(const Campaign& c, const std::string& name) {
  for (json& one : pictures_in(page_of(c)))
    if (one["kind"].get<std::string>() + " " + one["title"].get<std::string>() == name) return one;
  ADD_FAILURE() << "no " << name;
  return {};
}

const Names maps{"map D50 (µm)", "map dissipated power (W)", "map Regime"};

TEST(CampaignFigures, are_lines_maps_or_dots_as_the_points_ask) {
  EXPECT_EQ(names(speeds(8)), (Names{"plot D50", "plot dissipated power"}));
  EXPECT_EQ(names(grid(8, 2)), (Names{"plot D50", "plot dissipated power", "map Regime"}))
      << "two lines";
  Names both = maps;
  both.insert({"plot D50", "plot dissipated power"});
  EXPECT_EQ(names(grid(8, 5)), both);
  EXPECT_EQ(names(grid(8, 6)), maps);
  EXPECT_EQ(names(scattered(30)),
            (Names{"plot D50", "plot D50", "plot D50", "plot dissipated power",
                   "plot dissipated power", "plot dissipated power"}))
      << "over each key";
}

TEST(CampaignFigures, keep_a_grid_of_which_some_points_are_missing) {
  Campaign c = grid(8, 6);
  c.points.erase(c.points.begin() + 7, c.points.begin() + 15);
  EXPECT_EQ(names(c), maps);
}

TEST(CampaignFigures, of_a_grid_of_three_keys_are_a_map_for_each_of_a_few_words) {
  Campaign c = grid(8, 6), twice = c;
  c.keys.push_back({"jar.material", ""});
  twice.points.clear();
  twice.keys = c.keys;
  for (const char* word : {"steel", "agate"})
    for (Point p : c.points) {
      p.values.emplace_back(word);
      twice.points.push_back(p);
    }
  EXPECT_EQ(names(twice), (Names{"map D50 (µm), material agate", "map D50 (µm), material steel",
                                 "map dissipated power (W), material agate",
                                 "map dissipated power (W), material steel"}));
}

TEST(CampaignFigures, keys_side_by_side_make_one_line) {
  Campaign c = speeds(6);
  c.keys.push_back({"run.time", "s", true});
  for (Point& p : c.points) p.values.push_back(fmt::format("{} s", p.number));
  const Sheet sheet(c);
  EXPECT_EQ(lines_of(sheet, sheet.axis()).size(), 1U);
  EXPECT_TRUE(layout_of(sheet).lines);
  EXPECT_TRUE(has(campaign_page(c, "1"), "run.time (s)"));
}

TEST(CampaignFigures, of_one_key_at_a_time_join_what_differs_in_that_key_alone) {
  Campaign c = scattered(0);
  const auto point = [&](double speed, double diameter, double friction) {
    Point p{.number = c.points.size() + 1,
            .values = {fmt::format("{} rpm", speed), fmt::format("{} mm", diameter),
                       fmt::format("{}", friction)}};
    fill(p, speed, diameter);
    c.points.push_back(std::move(p));
  };
  point(300, 10, 0.5);
  point(200, 10, 0.5), point(400, 10, 0.5);
  point(300, 8, 0.5), point(300, 12, 0.5);
  point(300, 10, 0.2), point(300, 10, 0.8);
  const std::vector<json> pictures = pictures_in(page_of(c));
  ASSERT_EQ(pictures.size(), 6U);
  for (const json& one : pictures)
    EXPECT_EQ(one["series"][0]["x"].size(), 3U) << one["title"] << ": of seven points";
}

TEST(CampaignFigures, shade_the_intervals_from_point_to_point) {
  Campaign c = speeds(3);
  for (Point& p : c.points) {
    p.value = {1e-6 * static_cast<double>(p.number), 1};
    p.ci95 = {1e-7, NAN};
  }
  const json band = picture(c, "plot D50")["series"][0];
  EXPECT_EQ(band["band"], true);
  EXPECT_EQ(band["low"], json::parse("[0.9,1.9,2.9]"));
  EXPECT_EQ(band["high"], json::parse("[1.1,2.1,3.1]"));
  EXPECT_FALSE(picture(c, "plot dissipated power")["series"][0].contains("low"))
      << "no interval, no band";
}

/// Number of the cell with `words` in what it says; the number of cells if there is none.
std::size_t cell_of(const json& map, const std::string& words) {
  const json& told = map["panels"][0]["told"];
  std::size_t k = 0;
  while (k < told.size() && !has(told[k].get<std::string>(), words)) ++k;
  return k;
}

TEST(CampaignFigures, maps_hold_their_numbers_and_say_them_in_words) {
  Campaign c = grid(8, 6);
  fail(c.points[10], "stopped");
  const json map = picture(c, "map dissipated power (W)");
  const json& panel = map["panels"][0];
  ASSERT_EQ(panel["values"].size(), 48U);
  // 12 W (1/2)^3 5/10 = 0.75 W is the least, 12 W (5/3)^3 1.5 = 83.3 W the most: over two decades.
  const auto at = [](const char* speed, const char* size) {
    return fmt::format("mill.speed {} rpm, balls.1.diameter {} mm: ", speed, size);
  };
  EXPECT_EQ(map["least"], 0.75);
  EXPECT_NEAR(map["most"], 83.3333, 1e-4);
  EXPECT_EQ(map["log"], true);
  EXPECT_EQ(panel["values"][cell_of(map, at("150", "5"))], 0.75);
  EXPECT_EQ(panel["values"][cell_of(map, at("500", "15"))], 83.33) << "four digits";
  EXPECT_LT(cell_of(map, at("300", "9") + "dissipated power 10.80 ± 0.24 W"), 48U);
  const std::size_t failed = cell_of(map, at("200", "13") + "failed: stopped");
  ASSERT_LT(failed, 48U);
  EXPECT_EQ(panel["failed"][failed], true);
  EXPECT_EQ(panel["values"][failed], json());
}

TEST(CampaignFigures, regimes_are_words_of_their_map_and_series_of_their_dots) {
  Campaign c = grid(8, 6);
  const json cells = picture(c, "map Regime");
  EXPECT_EQ(cells["words"], json::parse(R"(["cascading","cataracting"])"));
  const json& values = cells["panels"][0]["values"];
  EXPECT_EQ(values[cell_of(cells, "mill.speed 150 rpm, balls.1.diameter 5 mm: cascading")], 0);
  EXPECT_EQ(values[cell_of(cells, "mill.speed 500 rpm, balls.1.diameter 15 mm: cataracting")], 1);
  Campaign dots = scattered(40);
  dots.keys.pop_back();
  for (Point& p : dots.points) p.values.pop_back();
  const json scatter = picture(dots, "plot Regime");
  const auto slow =
      static_cast<std::size_t>(std::ranges::count(dots.points, "cascading", &Point::regime));
  EXPECT_EQ(scatter["series"][0]["name"], "cascading");
  EXPECT_EQ(scatter["series"][0]["x"].size(), slow);
  EXPECT_EQ(scatter["series"][1]["x"].size(), 40 - slow);
}

TEST(CampaignLaws, stand_beside_the_curve_with_units_and_intervals) {
  const std::string html = campaign_page(speeds(8), "1");
  // The points lie on 12 W (x/300 rpm)^3; at x0 = 303 rpm, the geometric mean, that is 12.36 W.
  EXPECT_TRUE(has(html, "A power law fits best."));
  EXPECT_TRUE(has(html, "c (x / 303 rpm)<sup>p</sup>"));
  EXPECT_TRUE(has(html, "c = 12.36"));
  EXPECT_TRUE(has(html, " W/rpm²"));
  EXPECT_TRUE(has(html, "p = 3.0"));
  const json plot = picture(speeds(8), "plot dissipated power");
  EXPECT_EQ(plot["series"][1]["mark"], "line") << "the law";
  EXPECT_GE(plot["series"][1]["colour"], 7) << "dashed";
}

TEST(CampaignLaws, are_not_fitted_to_three_values) {
  EXPECT_FALSE(has(campaign_page(speeds(3), "1"), "class=\"laws\""));
  EXPECT_TRUE(has(campaign_page(speeds(4), "1"), "Too few points to distinguish the laws"));
}

}  // namespace
}  // namespace mahlwerk::report::campaign_pictures_test
