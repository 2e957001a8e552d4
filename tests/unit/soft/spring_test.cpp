// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "statement.hpp"

namespace mahlwerk::soft::spring_test {
namespace {

using tests::states;
using tests::stays_below;

using V = Register<2>;

Vec<V> alike(const Vec3& a) {
  return in_all_lanes<V>(a);
}
Vec3 first(const Vec<V>& a) {
  return {a.x[0], a.y[0], a.z[0]};
}
Vec3 normal(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

/// A tangential spring inclined by `lean` to the plane in which its normal turns by `angle` in this
/// many steps, and the exactly rotated spring.
struct Turned {
  Vec3 spring, exact;
};
Turned turned(double lean, double angle, int steps) {
  const auto at = [&](double a) {
    return Vec3{-std::cos(lean) * std::sin(a), std::cos(lean) * std::cos(a), std::sin(lean)};
  };
  Vec<V> spring = alike(at(0));
  for (int k = 1; k <= steps; ++k)
    spring = rotate_to_tangent_plane(spring, alike(normal(angle * k / steps)));
  return {first(spring), at(angle)};
}

TEST(Spring, keeps_its_length_and_lies_across_the_normal) {
  const Turned t = turned(0.6, std::numbers::pi, 1000);
  states("length", norm(t.spring), 1, 1e-12, "dem.18: 1000 roundings");
  states("along the normal", dot(t.spring, normal(std::numbers::pi)), 0, 1e-12, "dem.18");
}

TEST(Spring, turns_as_the_contact_does_but_for_a_quarter_of_the_angle_squared_over_the_steps) {
  const double pi = std::numbers::pi;
  for (const int steps : {100, 1000, 10000})
    stays_below("off after half a turn in " + std::to_string(steps) + " steps [rad]",
                norm(turned(pi / 4, pi, steps).spring - turned(pi / 4, pi, steps).exact),
                pi * pi / 4 / steps, "docs/theory/soft.md, Friction");
  states("along the turn or along its axis: off by",
         norm(turned(0, 1, 10000).spring - turned(0, 1, 10000).exact), 0, 1e-12,
         "symmetry, 10 000 roundings");
}

TEST(Spring, that_is_none_stays_none) {
  const Vec3 left = first(rotate_to_tangent_plane(alike({}), alike({0, 0, 1})));
  states("length", norm(left), 0, 0, "no division by its length");
}

}  // namespace
}  // namespace mahlwerk::soft::spring_test
