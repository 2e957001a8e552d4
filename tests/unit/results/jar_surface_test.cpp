// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The drawn surface is the wall that balls collide with, for every shape in the register.
#include "mahlwerk/results/quantities/jar_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mahlwerk/geometry/shapes.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::jar_surface_test {
namespace {

using geometry::AnyShape;
using results::JarMesh;

constexpr double pi = std::numbers::pi;
constexpr double facet = 2 * pi / 96, facet_of_arms = 2 * pi / 24;  // [rad] (jar_surface.hpp)

geometry::LifterCylinder lifters(int count, double face_angle, double width) {
  geometry::LifterCylinder jar;
  jar.diameter = 0.2, jar.height = 0.1;
  jar.lifters = count, jar.lifter_height = 0.012, jar.lifter_width = width;
  jar.lifter_face_angle = face_angle;
  jar.complete();
  return jar;
}
geometry::Attritor stirrer() {
  geometry::Attritor jar;
  jar.diameter = 0.1, jar.height = 0.12, jar.shaft_diameter = 0.02, jar.shaft_clearance = 0.01;
  jar.arms = 4, jar.arm_diameter = 0.008, jar.arm_span = 0.08;
  jar.arm_clearance = 0.02, jar.arm_spacing = 0.02, jar.rotor_speed = 30;
  jar.complete();
  return jar;
}

std::vector<AnyShape> samples() {
  return {geometry::Capsule{0.012, 0.036},
          geometry::Sphere{0.03},
          geometry::Cylinder{0.042, 0.0325},
          geometry::RoundedCylinder{0.042, 0.0325, 0.006},
          geometry::RoundedCylinder{0.042, 0.042, 0.021},  // all fillet: a sphere
          geometry::Box{0.03, 0.042, 0.0325},
          geometry::PeriodicBox{0.03, 0.042, 0.0325},
          lifters(8, 70 * pi / 180, 0.02),
          lifters(1, 0.5 * pi, 0.05),
          lifters(2, 0.5 * pi, 0.05),
          lifters(150, 0.5 * pi, 0.002),  // more bars than facets
          stirrer(),
          mesh_of(lumpy(0.02))};
}

/// Distance of a point from the nearest wall [m]; a periodic box has its periodic boundaries as
/// walls.
double depth(const AnyShape& shape, const Vec3& p) {
  if (const auto* box = std::get_if<geometry::PeriodicBox>(&shape))
    return depth(geometry::Box{box->width, box->depth, box->height}, p);
  if (const auto* jar = std::get_if<geometry::RoundedCylinder>(&shape))
    return jar->gap(3, p).distance;  // the wall for small balls
  return std::visit(
      [&](const auto& s) {
        double least = geometry::never;
        for (int face = 0; face < s.faces; ++face) least = std::min(least, s.gap(face, p).distance);
        return least;
      },
      shape);
}

/// Distance of a corner of the drawn surface from the wall that it represents [m].
double off_wall(const AnyShape& shape, const JarMesh& mesh, const Vec3& p) {
  const auto* stirred = std::get_if<geometry::Attritor>(&shape);
  if (stirred == nullptr) return std::abs(depth(shape, p));
  if (!mesh.rotor)  // the shaft goes through the middle of its lid
    return std::abs(depth(geometry::Cylinder{stirred->diameter, stirred->height}, p));
  double least = std::abs(stirred->gap(2, p).distance);  // the shaft ends at the lid
  for (int face = stirred->first_rotor_face; face < stirred->faces; ++face)
    least = std::min(least, std::abs(stirred->gap(face, p).distance));
  return least;
}

template <class Of>
double of(const AnyShape& shape, const Of& what) {
  return std::visit(what, shape);
}

double volume(const JarMesh& mesh) {
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    six += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
  return six / 6;
}

std::string title(const AnyShape& shape, const JarMesh& mesh) {
  return std::string(geometry::name_of(shape)) + ", " + mesh.name;
}

TEST(JarSurface, every_vertex_lies_on_the_wall) {
  for (const AnyShape& shape : samples())
    for (const JarMesh& mesh : results::jar_surface(shape)) {
      double farthest = 0;
      for (const Vec3& p : mesh.vertices) farthest = max_or_nan(farthest, off_wall(shape, mesh, p));
      const double reach = of(shape, [](const auto& s) { return s.reach(); });
      stays_below(title(shape, mesh) + ": vertex off the wall [reach]", farthest / reach, 1e-9,
                  "geo.1");
    }
}

TEST(JarSurface, every_edge_is_shared_by_two_triangles_that_run_along_it_both_ways) {
  for (const AnyShape& shape : samples())
    for (const JarMesh& mesh : results::jar_surface(shape)) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
      for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
      for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1) << title(shape, mesh);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1U) << title(shape, mesh);
      }
      EXPECT_GT(mesh.triangles.size(), 0U);
      EXPECT_LT(mesh.triangles.size(), 20000U) << title(shape, mesh);
    }
}

/// A facet of a wall with radius of curvature R deviates from it by at most R (1 - cos(half a
/// facet)) in each of two directions, so a step four times as long to either side of it is certain.
TEST(JarSurface, triangles_run_anticlockwise_as_seen_from_outside) {
  for (const AnyShape& shape : samples())
    for (const JarMesh& mesh : results::jar_surface(shape)) {
      if (std::holds_alternative<geometry::Mesh>(shape)) continue;  // as in the input: geo.11
      const double step =
          of(shape, [](const auto& s) { return s.reach(); }) * 4 * (1 - std::cos(0.5 * facet));
      int inside_out = 0;
      for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const Vec3 across = cross(q - p, r - p), out = across / norm(across) * step;
        const Vec3 middle = (p + q + r) / 3;
        const double within = depth(shape, middle - out), without = depth(shape, middle + out);
        if (mesh.rotor ? within > 0 : within < 0 || without > 0) ++inside_out;
      }
      EXPECT_EQ(inside_out, 0) << title(shape, mesh);
    }
}

/// Lower bound of the volume drawn over the volume of a convex shape. The drawn surface deviates by
/// at most d: the shape shrunk by 1 - d/inradius fits into it.
double shrunk(double radius, double inradius, double angle) {
  const double d = 2 * radius * (1 - std::cos(0.5 * angle));
  return std::pow(1 - d / inradius, 3);
}

TEST(JarSurface, encloses_the_volume_but_for_its_facets) {
  const auto drawn = [](const AnyShape& shape) {
    return volume(results::jar_surface(shape).front());
  };
  const auto lies_within = [&](const AnyShape& shape, double share, const std::string& source) {
    const double whole = of(shape, [](const auto& s) { return s.volume(); });
    states(std::string(geometry::name_of(shape)) + ": volume drawn over volume",
           drawn(shape) / whole, 0.5 * (1 + share), 0.5 * (1 - share) + 1e-12, source);
  };
  const double polygon = std::sin(facet) / facet;  // area of 96 corners in a circle over its own
  for (const AnyShape& shape : samples()) {
    if (const auto* c = std::get_if<geometry::Capsule>(&shape))
      lies_within(shape, shrunk(0.5 * c->diameter, c->inradius(), facet), "convex, shrunk");
    if (const auto* s = std::get_if<geometry::Sphere>(&shape))
      lies_within(shape, shrunk(0.5 * s->diameter, s->inradius(), facet), "convex, shrunk");
    if (const auto* r = std::get_if<geometry::RoundedCylinder>(&shape))
      lies_within(shape, shrunk(0.5 * r->diameter, r->inradius(), facet), "convex, shrunk");
    if (std::holds_alternative<geometry::Box>(shape) ||
        std::holds_alternative<geometry::PeriodicBox>(shape) ||
        std::holds_alternative<geometry::Mesh>(shape))
      lies_within(shape, 1, "flat");
    if (const auto* l = std::get_if<geometry::LifterCylinder>(&shape))
      lies_within(
          shape,
          1 - (1 - polygon) * geometry::Cylinder{l->diameter, l->height}.volume() / l->volume(),
          "geo.14; no more is lost than all round the shell");
  }
  const geometry::Cylinder plain{0.042, 0.0325};
  states("cylinder: volume drawn over volume", drawn(plain) / plain.volume(), polygon, 1e-12,
         "a regular polygon of 96 corners");
}

TEST(JarSurface, the_vessel_and_the_stirrer_enclose_what_they_are) {
  const geometry::Attritor jar = stirrer();
  const std::vector<JarMesh> drawn = results::jar_surface(jar);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_FALSE(drawn[0].rotor);
  EXPECT_TRUE(drawn[1].rotor);
  const double polygon = std::sin(facet) / facet;
  const geometry::Cylinder vessel{jar.diameter, jar.height},
      shaft{jar.shaft_diameter, jar.height - jar.shaft_clearance};
  states("vessel: volume drawn over volume", volume(drawn[0]) / vessel.volume(), polygon, 1e-12,
         "a regular polygon of 96 corners");
  const geometry::Capsule arm{jar.arm_diameter, jar.arm_span - jar.arm_diameter};
  const double share = shrunk(0.5 * arm.diameter, arm.inradius(), facet_of_arms);
  states("arms: volume drawn over volume",
         (volume(drawn[1]) - polygon * shaft.volume()) / (jar.arms * arm.volume()),
         0.5 * (1 + share), 0.5 * (1 - share), "four capsules, convex, shrunk");
}

TEST(JarSurface, the_rotor_turns_about_the_axis_of_the_vessel) {
  const Vec3 arm = results::rotor_turn(stirrer(), 0.01) * Vec3{1, 0, 0};
  states("angle of the arm [rad]", std::atan2(arm.y, arm.x), 0.3, 1e-15, "30 rad/s for 10 ms");
  EXPECT_EQ(results::rotor_turn(geometry::Sphere{0.03}, 1), Rotation{});
}

TEST(JarSurface, of_a_periodic_cylinder_is_its_side_without_ends) {
  const double d = 0.2, length = 0.05;
  const JarMesh mesh = results::jar_surface(geometry::PeriodicCylinder{d, length}).front();
  double area = 0, outwards = INFINITY;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 n =
        0.5 * cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    area += norm(n);
    outwards = std::min(outwards, dot(n, mesh.vertices[a]));
  }
  states("area over pi d L", area / (pi * d * length), std::sin(0.5 * facet) / (0.5 * facet), 1e-12,
         "a regular polygon of 96 sides");
  EXPECT_GT(outwards, 0) << "normals point out of the jar";
}

}  // namespace
}  // namespace mahlwerk::tests::jar_surface_test
