// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/svg_plot.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/report/plot/scale.hpp"

namespace mahlwerk::report::svg_plot_test {
namespace {

TEST(Ticks, are_round_numbers_inside) {
  EXPECT_EQ(ticks(0, 60, false, 6), (std::vector<double>{0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(ticks(-1, 1, false, 4), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(0.5, 2000, true, 6), (std::vector<double>{1, 10, 100, 1000}));
  EXPECT_EQ(ticks(1, 30, true, 6), (std::vector<double>{1, 2, 5, 10, 20}));
  EXPECT_TRUE(ticks(1, 1, false, 5).empty());
}

/// The ends of a logarithmic axis, below the least value, are numbers above 0 with few ticks.
TEST(Ticks, of_values_next_to_zero_are_on_an_axis_with_ends) {
  AxisScale scale(true);
  scale.include(5e-324);
  scale.include(1e-299);
  scale.set_limits({}, true);
  EXPECT_GT(scale.least, 1e-300);
  EXPECT_LT(ticks(scale.least, scale.most, true, 5).size(), 9U);
}

TEST(Ticks, are_a_few_whatever_the_range) {
  Random random(3, 0);
  for (int i = 0; i < 2000; ++i) {
    const double least = std::pow(10, random.uniform(-20, 10));
    const double most = least * (1 + std::pow(10, random.uniform(-2, 12)));
    for (const bool logarithmic : {false, true}) {
      const auto marks = ticks(least, most, logarithmic, 5);
      EXPECT_LE(marks.size(), 8U) << least << " " << most;
      for (const double mark : marks) {
        const double little = 1e-8 * (logarithmic ? mark : most - least);
        EXPECT_GE(mark, least - little);
        EXPECT_LE(mark, most + little);
      }
    }
    EXPECT_GE(ticks(least, most, false, 5).size(), 2U) << least << " " << most;
  }
}

/// Strange data must not put "nan" or "inf" into a path.
TEST(Svg, survives_strange_data) {
  for (const bool logarithmic : {false, true})
    for (const Mark mark : {Mark::line, Mark::points, Mark::dots, Mark::steps})
      for (const std::vector<double>& y : std::vector<std::vector<double>>{{},
                                                                           {0, 0, 0},
                                                                           {5},
                                                                           {NAN, 1, NAN},
                                                                           {INFINITY, 1, 2},
                                                                           {-1, 1e300, 1e-300},
                                                                           {1, 1, 1}}) {
        std::vector<double> x{0, 1, 2};
        if (mark == Mark::steps) x.push_back(3);
        const Plot plot{
            "<t>", {"x", logarithmic}, {"y", logarithmic}, {{"s", x, y, {NAN, 1, 2}, mark}}};
        const std::string text = svg(plot);
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.find("inf"), std::string::npos);
        EXPECT_EQ(text.find("<t>"), std::string::npos);
      }
}

TEST(Svg, puts_points_where_they_belong) {
  Plot plot{"", {"x"}, {"y"}, {{"", {0, 5, 10}, {0, 5, 10}, {}, Mark::line}}};
  plot.y.least = 0;
  plot.y.most = 10;
  const std::string text = svg(plot);
  // The plot area is 62 ... 704 by 12 ... 314: its corners and its middle.
  EXPECT_NE(text.find("M62.0 314.0L383.0 163.0L704.0 12.0"), std::string::npos) << text;
}

TEST(Svg, series_are_told_apart) {
  Plot plot{"", {"x"}, {"y"}, {}};
  for (int i = 0; i < 3; ++i) plot.series.push_back({"s", {0, 1}, {0, 1.0 * i}, {}, Mark::line});
  const std::string text = svg(plot);
  for (const char* colour : {"#0072B2", "#D55E00", "#009E73"})
    EXPECT_NE(text.find(colour), std::string::npos);
}

TEST(Svg, dots_are_not_joined_and_may_share_the_colour_of_a_line) {
  Plot plot{"",
            {"x"},
            {"y"},
            {{"model", {0, 5, 10}, {0, 5, 10}, {}, Mark::line},
             {"", {0, 5, 10}, {1, 5, 9}, {1, 1, 1}, Mark::dots, 0}}};
  const std::string text = svg(plot);
  EXPECT_EQ(text.find("#D55E00"), std::string::npos) << "the second colour";
  std::size_t circles = 0, joined = 0;
  for (auto at = text.find("<circle"); at != std::string::npos; at = text.find("<circle", at + 1))
    ++circles;
  for (auto at = text.find("stroke-linejoin"); at != std::string::npos;
       at = text.find("stroke-linejoin", at + 1))
    ++joined;
  EXPECT_EQ(circles, 3U);
  EXPECT_EQ(joined, 1U);
}

TEST(Svg, values_that_differ_by_rounding_alone_are_drawn_as_one) {
  const double v = 1.5e-3, next = std::nextafter(v, 1);
  for (const bool logarithmic : {false, true}) {
    EXPECT_TRUE(ticks(v, next, logarithmic, 5).empty());
    const Plot plot{.title = "",
                    .x = {.label = "x"},
                    .y = {.label = "y", .logarithmic = logarithmic},
                    .series = {{"", {0, 1}, {v, next}, {}, Mark::line}}};
    EXPECT_NE(svg(plot).find("<path"), std::string::npos);
  }
}

TEST(Svg, intervals_are_cut_at_the_range_of_the_axis_but_not_at_the_value) {
  const Series s{.name = "", .x = {0, 1, 2}, .y = {0.2, 0.9, -0.1}, .error = {0.5, 0.5, 0.5}};
  const Axis share{.label = "", .range_least = 0, .range_most = 1};
  EXPECT_EQ(interval_at(s, 0, share).low, 0);
  EXPECT_DOUBLE_EQ(interval_at(s, 0, share).high, 0.7);
  EXPECT_EQ(interval_at(s, 1, share).high, 1);
  EXPECT_EQ(interval_at(s, 2, share).low, -0.1);  // a value outside stays inside its interval
  EXPECT_DOUBLE_EQ(interval_at(s, 0, {}).low, -0.3);
  EXPECT_FALSE(interval_at(s, 3, {}).known());
  Plot plot{"", {"x"}, {"y"}, {{"", {1}, {0.5}, {1}, Mark::dots}}};
  plot.y.least = 0, plot.y.most = 2;
  EXPECT_NE(svg(plot).find("V389.5"), std::string::npos) << "to -0.5, below the axis";
  plot.y.range_least = 0;
  EXPECT_NE(svg(plot).find("V314.0"), std::string::npos) << "to 0";
}

TEST(Svg, measured_values_are_black_squares_with_bars_of_two_lengths) {
  Plot plot{"", {"x"}, {"y"}, {{"measured", {5}, {5}, {}, Mark::squares}}};
  plot.series[0].low = {4}, plot.series[0].high = {8};
  plot.x.least = plot.y.least = 0, plot.x.most = plot.y.most = 10;
  const std::string text = svg(plot);
  // The plot area has the same scale at both ends: 4 and 8 are one and three parts from 5.
  const std::size_t bar = text.find("M383.0 ");
  ASSERT_NE(bar, std::string::npos) << text;
  double high = 0, low = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + bar, "M383.0 %lfV%lf", &high, &low), 2);
  const double middle = high + 0.75 * (low - high);
  EXPECT_NE(text.find("<rect x=\"379.5\" y=\"" + std::to_string(middle - 3.5).substr(0, 4)),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("width=\"7\" height=\"7\" fill=\"#1d2329\""), std::string::npos);
  EXPECT_NE(text.find(">measured<"), std::string::npos);
}

TEST(Svg, an_area_lies_between_the_ends_of_its_intervals) {
  Plot plot{"", {"x"}, {"y"}, {{.name = "", .x = {0, 10}, .y = {NAN, NAN}, .mark = Mark::area}}};
  plot.series[0].low = {0, 5}, plot.series[0].high = {5, 10};
  plot.x.least = plot.y.least = 0, plot.x.most = plot.y.most = 10;
  // The plot area is 62 ... 704 by 12 ... 314.
  EXPECT_NE(svg(plot).find("M62.0 163.0L704.0 12.0L704.0 163.0L62.0 314.0Z"), std::string::npos)
      << svg(plot);
}

TEST(Svg, a_long_legend_entry_has_several_lines_inside_the_picture) {
  Plot plot{"", {"x"}, {"y"}, {{"", {0, 1}, {0, 1}, {}, Mark::line}}};
  plot.width = 340;
  for (int i = 0; i < 20; ++i) plot.series[0].name += "words ";
  const std::string text = svg(plot);
  std::size_t lines = 0;
  for (auto at = text.find(">words"); at != std::string::npos; at = text.find(">words", at + 1)) {
    const std::string line = text.substr(at + 1, text.find('<', at) - at - 1);
    EXPECT_LE(38 + letter_width * static_cast<double>(line.size()), 340) << line;
    ++lines;
  }
  EXPECT_GE(lines, 3U);
}

}  // namespace
}  // namespace mahlwerk::report::svg_plot_test
