// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bodies that are clumps of spheres, and rounded convex bodies, beside balls: a drum of as many of
// each.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <span>

#include "benchmarks.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/body_shape.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "peers.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double radius = 0.005, density = 7800, time_step = 1e-5, drum_size = 0.25;
constexpr double settling = 0.3, measured = 0.05;  // [s]

struct NullObserver final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

scene::Solid sphere() {
  const double volume = 4.0 / 3 * std::numbers::pi * radius * radius * radius;
  return {{}, volume, {}};
}

/// Bodies on a lattice in a lying drum of 0.25 m.
std::vector<scene::Ball> on_lattice(const scene::Solid& solid, const scene::Chamber& drum) {
  const double r = solid.equivalent_radius(), reach = r * solid.shape().reach();
  const double gap = 2.02 * 0.0105, across = drum_size / 2 - reach, along = across;
  std::vector<scene::Ball> all;
  for (double x = -along; x <= along; x += gap)
    for (double y = -across; y <= across; y += gap)
      for (double z = -across; z <= across; z += gap)
        if (std::hypot(y, z) <= across)
          all.push_back({r, density, drum.mount * Vec3{y, z, x}, {}, {}});
  return all;
}

/// [ns] of processor time for a body and a step, of a drum at 60 rpm.
double ns_per_body(const scene::Solid& solid) {
  const scene::Chamber drum{geometry::Cylinder{drum_size, drum_size},
                            kinematics::Tumbling{6.28},
                            scene::mounted_along(kinematics::Tumbling::jar_axis),
                            {0, 0, -9.81}};
  const contact::ElasticConstants material{1e8, 0.3};
  const contact::Pair pair{.modulus = contact::effective_modulus(material, material),
                           .shear_modulus = contact::effective_shear_modulus(material, material),
                           .restitution = 0.6,
                           .friction = 0.4,
                           .rolling_friction = 0};
  soft::Settings rules{.model = {.law = contact::HertzMindlin{}}, .time_step = time_step};
  rules.few_ball_limit = 0;
  if (!solid.spheres.empty()) rules.shapes = {solid.shape()};
  const std::vector<scene::Ball> balls = on_lattice(solid, drum);
  const auto engine = soft::make_engine(drum, balls, rules, {1, geometry::Cylinder::faces, pair});
  NullObserver nobody;
  engine->advance(settling, nobody);
  std::vector<double> found;
  for (int k = 1; k <= 5; ++k) {
    const double began = cpu_seconds();
    engine->advance(settling + measured * k / 5, nobody);
    found.push_back((cpu_seconds() - began) / (measured / 5 / time_step) /
                    static_cast<double>(balls.size()) * 1e9);
  }
  return median(found);
}

}  // namespace

std::vector<Row> bodies() {
  std::vector<Row> rows;
  const std::string what = "drum of 25 cm, 1100 bodies of 10 mm";
  const double of_sphere = ns_per_body(sphere());
  const auto add = [&](const std::string& code, const scene::Solid& solid) {
    const double ns = ns_per_body(solid);
    rows.push_back({"bodies", what, code, "ns_per_body_and_step", ns});
    rows.push_back({"bodies", what, code, "times_a_sphere", ns / of_sphere});
  };
  rows.push_back({"bodies", what, "sphere", "ns_per_body_and_step", of_sphere});
  add("rod of 3 spheres", scene::rod_of_spheres(2 * radius, 4 * radius, 3));
  const double d = 2 * radius;
  const scene::Solid cylpebs =
      scene::cylinder_of_spheres(d, d, scene::usual_spheres_of_cylinder(d, d));
  add(fmt::format("cylpebs of {} spheres", cylpebs.spheres.size()), cylpebs);
  const scene::Solid cube = scene::cube_of_spheres(d, d / 4, 27);
  add(fmt::format("cube of {} spheres", cube.spheres.size()), cube);
  add("convex rod", scene::rounded_rod(d, 2 * d));
  add("convex cylpebs", scene::rounded_cylinder(d, d, d / 10));
  add("convex cube", scene::rounded_cube(d, d / 10));
  return rows;
}

}  // namespace mahlwerk::bench
