// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/prism.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/section_profile.hpp"
#include "mahlwerk/geometry/mesh_solid.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::prism_test {
namespace {

using geometry::Section;

/// An L, a comb and a triangle, clockwise or not.
const Section ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
const Section comb{{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3},
                   {3, 3}, {3, 1}, {4, 1}, {4, 3}, {5, 3}, {5, 0}};
const Section wedge{{0.9, -0.1}, {1, 0}, {0.9, 0.1}};

TEST(Prism, is_a_closed_surface_whose_volume_is_area_times_length) {
  const std::vector<std::pair<Section, double>> sections{{ell, 4}, {comb, 11}, {wedge, 0.01}};
  for (const auto& [section, area] : sections)
    for (const int copies : {1, 7}) {
      if (copies > 1 && section != wedge) continue;
      const geometry::Surface surface = geometry::weld(geometry::prism(section, 2.5, copies));
      EXPECT_FALSE(geometry::flaw_of_part(surface).has_value());
      EXPECT_FALSE(geometry::MeshSolid(surface, 0.5).is_sheet());
      states("volume [m3]", geometry::volume_of(surface), copies * area * 2.5, 1e-12 * area * 20,
             "area times length");
    }
}

TEST(Prism, copies_are_turned_about_its_axis) {
  const geometry::MeshSolid solid(geometry::weld(geometry::prism(wedge, 1, 4)), 0.5);
  for (int k = 0; k < 4; ++k) {
    const double angle = k * std::numbers::pi / 2;
    states("distance of the tip [m]",
           solid.clearance({1.3 * std::cos(angle), 1.3 * std::sin(angle), 0}), 0.3, 1e-12,
           "tip at radius 1");
    EXPECT_GT(solid.clearance({std::cos(angle + 0.7), std::sin(angle + 0.7), 0}), 0.3);
  }
}

TEST(Prism, sections_that_cross_themselves_or_have_no_area_are_refused) {
  EXPECT_EQ(geometry::flaw_of(ell), "");
  EXPECT_EQ(geometry::flaw_of(comb), "");
  EXPECT_NE(geometry::flaw_of(Section{{0, 0}, {1, 1}, {1, 0}, {0, 1}}), "");
  EXPECT_NE(geometry::flaw_of(Section{{0, 0}, {1, 0}, {2, 0}}), "");
  EXPECT_NE(geometry::flaw_of(Section{{0, 0}, {1, 0}}), "");
  EXPECT_NE(geometry::flaw_of(Section{{0, 0}, {1, 0}, {1, 0}, {0, 1}}), "");
}

TEST(Prism, angular_width_is_that_seen_from_the_axis) {
  states("wedge [rad]", geometry::angular_width(wedge), 2 * std::atan2(0.1, 0.9), 1e-12,
         "its two outer corners");
  states("round the axis [rad]", geometry::angular_width({{-1, -1}, {1, -1}, {0, 1}}),
         2 * std::numbers::pi, 1e-12, "the origin is inside");
}

TEST(SectionProfile, reads_corners_and_names_the_line_at_fault) {
  const Section found =
      cases::read_section_profile("# a bar\nx,y\n0, 0\n 3,0\n3,1\r\n\n1,1\n1,2\n0,2\n0,0\n", 1e-3);
  ASSERT_EQ(found.size(), 6U) << "the first corner, repeated, is left out";
  EXPECT_DOUBLE_EQ(found[2].x, 3e-3);
  const auto message = [](std::string_view text) {
    try {
      cases::read_section_profile(text, 1);
    } catch (const cases::MeshFileError& e) {
      return std::string(e.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(message("0,0\n1,0\n"), "the first line of a section must be \"x,y\"");
  EXPECT_EQ(message("x,y\n0,0\n1;0\n"), "line 3 is not a row of two numbers");
  EXPECT_EQ(message("x,y\n0,0\n1,nan\n"), "line 3 is not a row of two numbers");
  EXPECT_NE(message("x,y\n0,0\n1,1\n1,0\n0,1\n").find("meet"), std::string::npos);
  EXPECT_NE(message("").find("three corners"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::tests::prism_test
