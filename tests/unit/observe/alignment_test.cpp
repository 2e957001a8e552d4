// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Order of the axes of bodies: closed forms of known distributions of directions.
#include "mahlwerk/observe/alignment.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::alignment_test {
namespace {

using tests::states;
using tests::stays_below;

constexpr double pi = std::numbers::pi;

/// Axes on a cone about `about`, which has the angle `from_jar` to the jar's axis, z.
Alignment cone(double half_angle, double from_jar) {
  Alignment made;
  constexpr int around = 360;
  const Vec3 e{std::cos(from_jar), 0, -std::sin(from_jar)}, f{0, 1, 0},
      about{std::sin(from_jar), 0, std::cos(from_jar)};
  for (int k = 0; k < around; ++k) {
    const double turn = 2 * pi * k / around;
    const Vec3 axis = std::cos(half_angle) * about +
                      std::sin(half_angle) * (std::cos(turn) * e + std::sin(turn) * f);
    made.add(k % 2 == 0 ? axis : -axis, axis.z, 0.1);
  }
  return made;
}

TEST(Alignment, of_axes_on_a_cone_is_that_of_their_angle) {
  for (const double angle : {0.0, 0.3, 0.9}) {
    const double order = 1.5 * std::cos(angle) * std::cos(angle) - 0.5;
    states(fmt::format("S of a cone of {} rad", angle), cone(angle, 0).nematic_order(), order,
           1e-12, "bod.17");
    states("  the same in other axes", cone(angle, 1.1).nematic_order(), order, 1e-12, "bod.17");
    states("  mean angle to its axis", cone(angle, 0).mean_angle(), angle, 1e-7, "bod.18");
  }
  states("S of all directions in a plane", cone(0.5 * pi, 0.4).nematic_order(), 0.25, 1e-12,
         "<x^2> = 1/2");
}

/// |Q|^2 has the mean 3/(2 N) and S^2 <= 2 |Q|^2/3, so that S is about N^-1/2 at most; |Q|^2 is
/// chi-squared of five: nine times its mean in 1e-8 of all samples.
TEST(Alignment, without_order_is_below_three_over_the_root_of_the_number) {
  Random random(5, 0);
  for (const int n : {100, 10000}) {
    Alignment made;
    for (int k = 0; k < n; ++k) {
      const Vec3 axis = random.direction();
      made.add(axis, axis.z, 1);
    }
    stays_below(fmt::format("S of {} random axes", n), made.nematic_order(), 3 / std::sqrt(n),
                "bod.17");
    // The angle has the mean 1 and the variance pi - 3.
    states("  mean angle to the jar's axis [rad]", made.mean_angle(), 1,
           4 * std::sqrt((pi - 3) / n), "bod.18");
  }
}

TEST(Alignment, of_two_halves_is_that_of_the_whole) {
  Alignment half = cone(0.3, 0);
  half.merge(cone(0.3, 0));
  states("S", half.nematic_order(), cone(0.3, 0).nematic_order(), 1e-12, "sums");
  states("angle", half.mean_angle(), cone(0.3, 0).mean_angle(), 1e-12, "sums");
  EXPECT_TRUE(std::isnan(Alignment().nematic_order()));
  EXPECT_TRUE(std::isnan(Alignment().mean_angle()));
}

}  // namespace
}  // namespace mahlwerk::observe::alignment_test
