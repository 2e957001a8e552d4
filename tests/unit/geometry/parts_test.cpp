// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Jars with internal parts (lifter bars, stirrers): gaps are true distances, volumes are exact, and
// inconsistent dimensions are refused.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "part_jars.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::parts_test {
namespace {

using geometry::Attritor;
using geometry::LifterCylinder;

constexpr double pi = std::numbers::pi;

template <class S>
double nearest(const S& jar, const Vec3& p) {
  double least = geometry::never;
  for (int face = 0; face < jar.faces; ++face) least = std::min(least, jar.gap(face, p).distance);
  return least;
}
template <class S>
Vec3 anywhere(const S& jar, Random& random) {
  const Vec3 half = 0.5 * jar.extent().size();
  return {random.uniform(-half.x, half.x), random.uniform(-half.y, half.y),
          random.uniform(-half.z, half.z)};
}

/// The foot of a gap is on the face, no point of the face is nearer, and the normal points from the
/// foot.
template <class S>
void has_distances(const S& jar) {
  Random random(1, 0);
  double foot = 0, nearer = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 p = anywhere(jar, random);
    if (nearest(jar, p) <= 0) continue;
    for (int face = 0; face < jar.faces; ++face) {
      const geometry::Gap gap = jar.gap(face, p);
      EXPECT_NEAR(norm(gap.inward), 1, 1e-14);
      foot = max_or_nan(foot, std::abs(jar.gap(face, p - gap.distance * gap.inward).distance));
      // Points within 0.999 d are not on the face: a distance changes at most by the displacement.
      const Vec3 q = p + 0.999 * gap.distance * random.direction();
      nearer = max_or_nan(nearer, 1e-3 * gap.distance - jar.gap(face, q).distance);
    }
  }
  stays_below("distance of the foot from its face [m]", foot, 1e-15, "rounding of sizes of 0.1 m");
  stays_below("how much nearer any other point is [m]", nearer, 1e-15, "geo.1");
}

template <class S>
void has_volume(const S& jar) {
  constexpr int points = 1000000;
  Random random(2, 0);
  int inside = 0;
  for (int i = 0; i < points; ++i) inside += nearest(jar, anywhere(jar, random)) > 0;
  const Vec3 size = jar.extent().size();
  const double share = static_cast<double>(inside) / points, box = 1e6 * size.x * size.y * size.z;
  states("volume [ml]", 1e6 * jar.volume(), box * share,
         5 * box * std::sqrt(share * (1 - share) / points), "Monte Carlo, five standard errors");
}

TEST(Lifters, gap_is_the_distance_of_each_bar) {
  has_distances(lifters());
  has_distances(lifters(1, 0.5 * pi));
}
TEST(Lifters, volume_is_that_of_the_points_inside) {
  has_volume(lifters());
  has_volume(lifters(3, 0.5 * pi));
}
/// By hand (geo.13): the middle of the top of bar i is at the angle 2 pi i/n, its height inside the
/// shell. Tolerances are about five roundings of the radius, and of a unit vector.
TEST(Lifters, stand_evenly_round_the_shell) {
  for (const int count : {1, 3, 8}) {
    const LifterCylinder jar = lifters(count);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * pi * i / count, above = 0.003;
      const Vec3 out{std::cos(angle), std::sin(angle), 0};
      const auto gap = jar.gap(3 + i, (0.1 - 0.012 - above) * out);
      EXPECT_NEAR(gap.distance, above, 1e-16);
      EXPECT_NEAR(norm(gap.inward + out), 0, 1e-15);
    }
  }
}
TEST(Lifters, only_bars_that_are_near_are_looked_at_closely) {
  const LifterCylinder jar = lifters();
  Random random(3, 0);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = anywhere(jar, random);
    for (int face = 0; face < jar.faces; ++face) {
      const double all = jar.gap(face, p).distance, near = jar.gap(face, p, 0.01).distance;
      if (all <= 0.01)
        EXPECT_EQ(near, all);
      else
        EXPECT_GT(near, 0.01);
    }
  }
}

TEST(Stirrer, gap_is_the_distance_of_shaft_and_arms) {
  has_distances(stirrer());
}
TEST(Stirrer, volume_is_that_of_the_points_inside) {
  has_volume(stirrer());
}
TEST(Stirrer, the_largest_ball_has_room_however_the_stirrer_stands) {
  const Attritor jar = stirrer();
  const Vec3 place = jar.middle();
  for (int i = 0; i < 360; ++i) {
    const Vec3 p = rotation_about({0, 0, 1}, i * pi / 180).apply_inverse(place);
    EXPECT_GE(nearest(jar, p), jar.inradius() - 1e-15);
  }
}

TEST(Parts, sizes_that_do_not_go_together_are_named) {
  EXPECT_EQ(lifters().flaw(), "");
  EXPECT_EQ(stirrer().flaw(), "");
  const auto bad_lifters = [](auto change) {
    LifterCylinder jar = lifters();
    change(jar);
    return jar.flaw();
  };
  const auto bad_stirrer = [](auto change) {
    Attritor jar = stirrer();
    change(jar);
    return jar.flaw();
  };
  const auto says = [](const std::string& flaw, const std::string& words) {
    EXPECT_NE(flaw.find(words), flaw.npos) << flaw;
  };
  says(bad_lifters([](auto& j) { j.lifters = 7.5; }), "whole number");
  says(bad_lifters([](auto& j) { j.lifter_height = 0.1; }), "middle");
  says(bad_lifters([](auto& j) { j.lifters = 40; }), "whole shell");
  says(bad_lifters([](auto& j) { j.lifter_width = 0.005; }), "meet below its top");
  says(bad_lifters([](auto& j) { j.lifters = 2, j.lifter_width = 0.1, j.lifter_height = 0.001; }),
       "bulges");
  says(bad_lifters([](auto& j) {
         j.lifters = 20, j.lifter_width = 0.03, j.lifter_height = 0.08;
         j.lifter_face_angle = 0.5 * pi;
       }),
       "run into each other");
  says(bad_stirrer([](auto& j) { j.arms = 2.5; }), "whole number");
  says(bad_stirrer([](auto& j) { j.arm_span = 0.1; }), "longer");
  says(bad_stirrer([](auto& j) { j.arm_span = 0.025; }), "stand out");
  says(bad_stirrer([](auto& j) { j.arm_diameter = 0.03; }), "thicker");
  says(bad_stirrer([](auto& j) { j.arm_clearance = 0.003; }), "bottom");
  says(bad_stirrer([](auto& j) { j.shaft_clearance = 0.02; }), "above the lowest arm");
  says(bad_stirrer([](auto& j) { j.arm_spacing = 0.005; }), "touch each other");
  says(bad_stirrer([](auto& j) { j.arms = 9; }), "above the vessel");
}

}  // namespace
}  // namespace mahlwerk::tests::parts_test
