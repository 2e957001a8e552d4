// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "mahlwerk/report/campaign/plots.hpp"
#include "mahlwerk/report/plot/colours.hpp"
#include "unit/report/campaign_fake.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::campaign_pictures_test {
namespace {

std::set<std::string> names(const Campaign& c) {
  std::set<std::string> list;
  for (const auto& [name, picture] : campaign_figures(c)) {
    EXPECT_TRUE(well_formed(picture)) << name;
    list.insert(name.substr(8, name.size() - 12));  // without figures/ and .svg
  }
  return list;
}

using Names = std::set<std::string>;

TEST(CampaignFigures, are_lines_maps_or_dots_as_the_points_ask) {
  EXPECT_EQ(names(speeds(8)), (Names{"d50", "dissipated_power"}));
  EXPECT_EQ(names(grid(8, 2)), (Names{"d50", "dissipated_power", "regimes"})) << "two lines";
  EXPECT_EQ(names(grid(8, 5)),
            (Names{"d50", "d50-map", "dissipated_power", "dissipated_power-map", "regimes"}));
  EXPECT_EQ(names(grid(8, 6)), (Names{"d50-map", "dissipated_power-map", "regimes"}));
  EXPECT_EQ(names(scattered(30)),
            (Names{"d50", "d50-balls.1.diameter", "d50-contact.friction", "dissipated_power",
                   "dissipated_power-balls.1.diameter", "dissipated_power-contact.friction"}));
}

TEST(CampaignFigures, keep_a_grid_of_which_some_points_are_missing) {
  Campaign c = grid(8, 6);
  c.points.erase(c.points.begin() + 7, c.points.begin() + 15);
  EXPECT_EQ(names(c), (Names{"d50-map", "dissipated_power-map", "regimes"}));
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
  EXPECT_EQ(names(twice),
            (Names{"d50-map", "d50-map-2", "dissipated_power-map", "dissipated_power-map-2"}));
  EXPECT_TRUE(has(campaign_figures(twice).at("figures/d50-map.svg"), ">D50 (µm), material agate<"));
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
  const auto figures = campaign_figures(c);
  ASSERT_EQ(figures.size(), 6U);
  for (const auto& [name, picture] : figures)
    EXPECT_EQ(times(picture, "<circle"), 3U) << name;  // of seven points
}

TEST(CampaignFigures, shade_the_intervals_from_point_to_point) {
  Campaign c = speeds(3);
  for (Point& p : c.points) {
    p.value = {1e-6 * static_cast<double>(p.number), 1};
    p.ci95 = {1e-7, NAN};
  }
  const std::string picture = campaign_figures(c).at("figures/d50.svg");
  const std::size_t band = picture.find("fill-opacity=\"0.16\"");
  ASSERT_NE(band, std::string::npos);
  const std::size_t start = picture.rfind("d=\"", band) + 3;
  const std::string path = picture.substr(start, picture.find('"', start) - start);
  // Along the upper ends, back along the lower ones: six corners, the last at the x of the first.
  EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 5);
  EXPECT_TRUE(path.ends_with("Z"));
  const double first = std::strtod(path.c_str() + 1, nullptr);
  const double last = std::strtod(path.c_str() + path.rfind('L') + 1, nullptr);
  EXPECT_EQ(first, last);
  EXPECT_FALSE(has(campaign_figures(c).at("figures/dissipated_power.svg"), "Z\" fill"))
      << "no interval, no band";
}

/// Colour of the cell with `words` in its title.
std::string colour_of(const std::string& picture, const std::string& words) {
  const std::size_t at = picture.find(words);
  if (at == std::string::npos) return "none";
  const std::size_t start = picture.rfind("fill=\"", at) + 6;
  return picture.substr(start, picture.find('"', start) - start);
}

TEST(CampaignFigures, maps_say_their_numbers_in_colour_text_and_title) {
  Campaign c = grid(8, 6);
  fail(c.points[10], "stopped");
  const std::string picture = campaign_figures(c).at("figures/dissipated_power-map.svg");
  EXPECT_EQ(times(picture, "<title>"), 48U);
  // 12 W (1/2)^3 5/10 = 0.75 W is the least, 12 W (5/3)^3 1.5 = 83.3 W the most: over two decades.
  const auto at = [](const char* speed, const char* size) {
    return fmt::format("mill.speed {} rpm, balls.1.diameter {} mm: ", speed, size);
  };
  EXPECT_EQ(colour_of(picture, at("150", "5")), viridis(0));
  EXPECT_EQ(colour_of(picture, at("500", "15")), viridis(1));
  EXPECT_TRUE(has(picture, "logarithmic scale"));
  EXPECT_TRUE(has(picture, ">0.75<"));
  EXPECT_TRUE(has(picture, ">83.3<"));
  // ln(12/0.75)/ln(83.33/0.75) = 0.5885 of the scale, in steps of 1/64: 38/64.
  Campaign middle = grid(8, 6);
  EXPECT_EQ(colour_of(campaign_figures(middle).at("figures/dissipated_power-map.svg"),
                      at("300", "9") + "dissipated power 10.80 ± 0.24 W"),
            viridis(36.0 / 64));  // ln(10.8/0.75)/ln(83.33/0.75) = 0.5661
  EXPECT_TRUE(has(picture, at("200", "13") + "failed: stopped"));
}

TEST(CampaignFigures, a_map_of_many_cells_is_drawn_in_runs) {
  const std::string picture = campaign_figures(grid(40, 40)).at("figures/d50-map.svg");
  EXPECT_EQ(times(picture, "<title>"), 0U);
  EXPECT_LT(picture.size(), 200000U);
}

TEST(CampaignFigures, regimes_have_the_colours_of_their_legend) {
  Campaign c = grid(8, 6);
  const std::string cells = campaign_figures(c).at("figures/regimes.svg");
  EXPECT_EQ(colour_of(cells, "mill.speed 150 rpm, balls.1.diameter 5 mm: cascading"),
            kind_colour(0));
  EXPECT_EQ(colour_of(cells, "mill.speed 500 rpm, balls.1.diameter 15 mm: cataracting"),
            kind_colour(1));
  EXPECT_TRUE(in_order(cells, {std::string(kind_colour(0)), ">cascading<",
                               std::string(kind_colour(1)), ">cataracting<"}));
  Campaign dots = scattered(40);
  dots.keys.pop_back();
  for (Point& p : dots.points) p.values.pop_back();
  const std::string scatter = campaign_figures(dots).at("figures/regimes.svg");
  const auto slow =
      static_cast<std::size_t>(std::ranges::count(dots.points, "cascading", &Point::regime));
  // The legend has one more of each.
  EXPECT_EQ(times(scatter, fmt::format("fill=\"{}\"", kind_colour(0))), slow + 1);
  EXPECT_EQ(times(scatter, fmt::format("fill=\"{}\"", kind_colour(1))), 40 - slow + 1);
}

TEST(CampaignLaws, stand_beside_the_curve_with_units_and_intervals) {
  const std::string html = campaign_page(speeds(8), "1");
  // The points lie on 12 W (x/300 rpm)^3; at x0 = 303 rpm, the geometric mean, that is 12.36 W.
  EXPECT_TRUE(has(html, "A power law fits best."));
  EXPECT_TRUE(has(html, "c (x / 303 rpm)<sup>p</sup>"));
  EXPECT_TRUE(has(html, "c = 12.36"));
  EXPECT_TRUE(has(html, " W/rpm²"));
  EXPECT_TRUE(has(html, "p = 3.0"));
  EXPECT_TRUE(has(html, "stroke-dasharray=\"7 3\""));
}

TEST(CampaignLaws, are_not_fitted_to_three_values) {
  EXPECT_FALSE(has(campaign_page(speeds(3), "1"), "class=\"laws\""));
  EXPECT_TRUE(has(campaign_page(speeds(4), "1"), "Too few points to distinguish the laws"));
}

}  // namespace
}  // namespace mahlwerk::report::campaign_pictures_test
