// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/worn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "statement.hpp"

namespace mahlwerk::tests::worn_section_test {
namespace {

using geometry::PlanePoint;
using geometry::Section;

const Section bar{{0.09, -0.01}, {0.11, -0.015}, {0.11, 0.015}, {0.09, 0.01}};

/// A regular polygon, nearly a circle.
Section round_section(double radius, int corners) {
  Section s;
  for (int i = 0; i < corners; ++i) {
    const double at = 2 * std::numbers::pi * i / corners;
    s.push_back({radius * std::cos(at), radius * std::sin(at)});
  }
  return s;
}

std::vector<double> areas_of_depth(const Section& s, double depth) {
  std::vector<double> lost;
  for (std::size_t i = 0; i < s.size(); ++i) lost.push_back(depth * geometry::length_of(s, i));
  return lost;
}

double sum_of(const std::vector<double>& all) {
  return std::accumulate(all.begin(), all.end(), 0.0);
}

TEST(WornSection, loses_exactly_the_area_that_wore_off) {
  const Section cut = geometry::cut_into_pieces(bar, 1e-3);
  std::vector<double> lost(cut.size());
  for (std::size_t i = 0; i < cut.size(); ++i)  // any wear on the inner half
    if (cut[i].x < 0.1) lost[i] = 1e-7 * (1 + std::sin(300 * cut[i].y) * std::cos(i));
  const auto worn = geometry::worn_section(cut, lost);
  ASSERT_TRUE(worn.has_value());
  states("area lost [m2]", geometry::area_of(cut) - geometry::area_of(*worn), sum_of(lost),
         1e-15 * geometry::area_of(cut) * 10, "sum of the worn areas, to rounding (wea.12)");
}

TEST(WornSection, uniform_wear_of_a_round_bar_moves_its_surface_as_the_closed_form) {
  constexpr double radius = 0.05, depth = 2e-3;
  const Section s = round_section(radius, 400);
  // The worn area of a circle whose radius shrinks by `depth`, spread over its sides.
  const double area = geometry::area_of(s) * (1 - std::pow(1 - depth / radius, 2));
  std::vector<double> lost(s.size(), area / 400);
  const auto worn = geometry::worn_section(s, lost);
  ASSERT_TRUE(worn.has_value());
  for (const std::size_t i : {0U, 57U, 211U})
    states("radius of a corner [m]", std::hypot((*worn)[i].x, (*worn)[i].y), radius - depth, 1e-15,
           "R - depth");
}

TEST(WornSection, sides_of_one_depth_move_by_it_at_any_corner) {
  const Section square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  constexpr double depth = 0.1;
  std::vector<double> lost = areas_of_depth(square, depth);
  for (double& a : lost) a *= 1 - depth;  // a square of the side 1 - 2 depth has lost this area
  const auto worn = geometry::worn_section(square, lost);
  ASSERT_TRUE(worn.has_value());
  states("corner x [m]", (*worn)[0].x, depth, 1e-14, "moved in by the depth");
  states("corner y [m]", (*worn)[2].y, 1 - depth, 1e-14, "moved in by the depth");
}

TEST(WornSection, spreading_keeps_the_sum_and_a_uniform_depth) {
  const Section cut = geometry::cut_into_pieces(bar, 1e-3);
  std::vector<bool> exposed(cut.size());
  std::vector<double> one(cut.size()), even(cut.size());
  for (std::size_t i = 0; i < cut.size(); ++i) {
    exposed[i] = cut[i].x < 0.1;
    if (exposed[i]) even[i] = 1e-3 * geometry::length_of(cut, i);
  }
  one[2] = exposed[2] ? 1 : 0;
  one[0] = exposed[0] ? 1 : 0;
  const auto spread = geometry::spread_along(cut, one, exposed, 3e-3);
  states("sum", sum_of(spread), sum_of(one), 1e-14, "flows from side to side (wea.11)");
  for (std::size_t i = 0; i < cut.size(); ++i)
    EXPECT_TRUE(exposed[i] || spread[i] == 0) << "sides outside take no part";
  const auto same = geometry::spread_along(cut, even, exposed, 3e-3);
  for (std::size_t i = 0; i < cut.size(); ++i)
    EXPECT_NEAR(same[i], even[i], 1e-18) << "a uniform depth stays";
}

TEST(WornSection, spreading_has_the_standard_deviation_asked_for) {
  const Section strip = geometry::cut_into_pieces({{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}}, 0.01);
  const std::vector<bool> exposed(strip.size(), true);
  std::vector<double> lost(strip.size());
  lost[50] = 1;
  constexpr double width = 0.05;
  const auto spread = geometry::spread_along(strip, lost, exposed, width);
  double variance = 0;
  for (std::size_t i = 0; i < 100; ++i)
    variance += spread[i] * std::pow(0.01 * (static_cast<double>(i) - 50), 2);
  states("standard deviation [m]", std::sqrt(variance), width, 1e-3 * width,
         "conduction over tau = s^2/2 (wea.11)");
}

TEST(WornSection, short_sides_go_and_the_area_stays) {
  Section s = geometry::cut_into_pieces(bar, 2e-3);
  s.insert(s.begin() + 3,
           {s[2].x + 0.1 * (s[3].x - s[2].x), s[2].y + 0.1 * (s[3].y - s[2].y) + 1e-5});
  const Section fewer = geometry::without_short_sides(s, 5e-4);
  EXPECT_EQ(fewer.size(), s.size() - 1);
  states("area [m2]", geometry::area_of(fewer), geometry::area_of(s), 1e-18,
         "the corner in place of a side keeps it");
}

TEST(WornSection, of_a_profile_that_would_cross_itself_is_none) {
  const Section thin = geometry::cut_into_pieces({{0, 0}, {1, 0}, {1, 0.01}, {0, 0.01}}, 0.02);
  std::vector<double> lost(thin.size());
  lost[10] = 0.02 * 0.02;  // twice as deep as the bar is thick
  EXPECT_FALSE(geometry::worn_section(thin, lost).has_value());
  EXPECT_FALSE(geometry::worn_section(thin, areas_of_depth(thin, 0.1)).has_value());
}

TEST(WornSection, nearest_side_and_share_of_a_circle_are_those_of_the_outline) {
  EXPECT_EQ(geometry::nearest_side(bar, {0.08, 0}), 3U);
  EXPECT_EQ(geometry::nearest_side(bar, {0.1, 0.02}), 2U);
  constexpr double radius = 0.1;
  // The sides y = 0.01 + (x - 0.09)/4 cross the circle at this angle.
  double angle = 0.1;
  for (int i = 0; i < 100; ++i)
    angle = std::asin((0.01 + 0.25 * (radius * std::cos(angle) - 0.09)) / radius);
  states("share of the circle", geometry::share_of_circle(bar, radius), angle / std::numbers::pi,
         1e-14, "between the crossings of its sides");
  EXPECT_EQ(geometry::share_of_circle(bar, 0.2), 0);
  states("a circle inside", geometry::share_of_circle(round_section(1, 10), 0.5), 1, 0, "whole");
}

}  // namespace
}  // namespace mahlwerk::tests::worn_section_test
