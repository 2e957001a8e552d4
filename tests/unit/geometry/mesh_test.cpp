// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/mesh.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <vector>

#include "mahlwerk/geometry/box.hpp"
#include "mahlwerk/geometry/mesh_wall.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::mesh_test {
namespace {

using geometry::Gap;
using geometry::Mesh;

const std::vector<Triangles>& samples() {
  static const std::vector<Triangles> all{box(0.03, 0.042, 0.0325), cylinder(48, 0.042, 0.0325),
                                          drum_with_lifters(0.2, 0.06, 6, 0.012, 0.008),
                                          lumpy(0.02)};
  return all;
}

/// Triangles as stored in the mesh, which reverses or leaves out some.
Triangles triangles_of(const Mesh& mesh) {
  Triangles t;
  for (const auto& [a, b, c] : mesh.surface().triangles) {
    const auto& p = mesh.surface().points;
    const auto at = [&](std::int32_t i) { return p[static_cast<std::size_t>(i)]; };
    t.push_back({at(a), at(b), at(c)});
  }
  return t;
}

std::vector<Gap> touched(const Mesh& mesh, const Vec3& p, double within) {
  std::vector<Gap> found;
  for (int face = 0; face < mesh.faces; ++face)
    if (const Gap g = mesh.gap(face, p, within); g.distance <= within) found.push_back(g);
  return found;
}

TEST(Mesh, distance_is_the_least_of_all_triangles_and_its_sign_tells_inside) {
  double worst = 0;
  int wrong = 0, inside = 0;
  for (const Triangles& t : samples()) {
    const geometry::MeshWall wall(geometry::weld(t), crease);
    Random random(3, 1);
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = 1.2 * random_point_in(wall.extent(), random);
      const double found = wall.nearest(p).gap.distance;
      worst = max_or_nan(worst, std::abs(std::abs(found) - distance_to(t, p)));
      const bool in = winding(t, p) > 0.5;
      inside += in ? 1 : 0;
      wrong += in == (found > 0) ? 0 : 1;
    }
  }
  stays_below("distance [m]", worst, 1e-15, "all triangles one by one; roundings of 0.1 m");
  EXPECT_EQ(wrong, 0) << "points on the wrong side, by the winding number";
  EXPECT_GT(inside, 3000);
}

TEST(Mesh, distances_of_faces_are_those_of_their_triangles) {
  double worst = 0;
  for (const Triangles& t : samples()) {
    const Mesh mesh = mesh_of(t);
    const geometry::MeshWall wall(mesh.surface(), crease);
    const geometry::Facets facets = geometry::facets_of(mesh.surface(), crease);
    std::vector<double> found(static_cast<std::size_t>(mesh.faces));
    Random random(4, 1);
    for (int i = 0; i < 500; ++i) {
      const Vec3 p = random_point_in(wall.extent(), random);
      if (!(wall.nearest(p).gap.distance > 0)) continue;
      mesh.distances(p, 1, found);
      std::vector<double> least(found.size(), geometry::never);
      for (const geometry::Facet& f : facets.facets) {
        double& d = least[static_cast<std::size_t>(f.face)];
        d = std::min(d, norm(p - nearest_on(f.corner, p)));
      }
      for (std::size_t k = 0; k < found.size(); ++k)
        worst = max_or_nan(worst, std::abs(found[k] - least[k]));
    }
  }
  stays_below("distance [m]", worst, 1e-15, "all triangles one by one");
}

/// The definition (geo.10) in other words: of the nearest points of all triangles, the contacts are
/// those that are local minima of the distance over the whole wall.
TEST(Mesh, a_ball_touches_each_face_where_no_point_of_the_wall_around_is_nearer) {
  int touches = 0, wrong = 0;
  for (const Triangles& t : samples()) {
    const Mesh mesh = mesh_of(t);
    const Triangles all = triangles_of(mesh);
    Random random(5, 1);
    const double eps = 1e-6 * mesh.reach();
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = random_point_in(mesh.extent(), random);
      if (winding(all, p) < 0.5) continue;
      for (const Gap& gap : touched(mesh, p, 0.3 * mesh.reach())) {
        ++touches;
        const Vec3 foot = p - gap.distance * gap.inward;
        if (distance_to(all, foot) > 1e-14) ++wrong;
        for (const Corners& c : all) {
          const Vec3 near = nearest_on(c, foot);
          if (norm(near - foot) > 1e-13) continue;  // skips triangles away from the foot
          for (int n = 0; n < 4; ++n) {
            Vec3 way = random.direction();
            way = nearest_on(c, foot + eps * way) - p;
            if (norm(way) < gap.distance * (1 - 1e-12)) ++wrong;
          }
        }
      }
      // The nearest point of all triangles is always among the contacts, once.
      const double least = distance_to(all, p);
      int nearest = 0;
      for (const Gap& gap : touched(mesh, p, least * (1 + 1e-12))) nearest += gap.distance > 0;
      if (nearest != 1) ++wrong;
    }
  }
  EXPECT_GT(touches, 1000);
  EXPECT_EQ(wrong, 0);
}

TEST(Mesh, volume_is_that_of_the_solid) {
  states("box [m3]", mesh_of(samples()[0]).volume(), 0.03 * 0.042 * 0.0325, 1e-19, "w t h");
  const double polygon = 0.5 * 48 * 0.021 * 0.021 * std::sin(2 * std::numbers::pi / 48);
  states("prism [m3]", mesh_of(samples()[1]).volume(), polygon * 0.0325, 1e-18, "(geo.11)");
}

TEST(Mesh, faces_end_at_creases) {
  EXPECT_EQ(mesh_of(samples()[0]).faces, 6) << "a box";
  EXPECT_EQ(mesh_of(samples()[1]).faces, 3) << "side and ends of a round drum";
  EXPECT_EQ(mesh_of(cylinder(12, 0.04, 0.03)).faces, 14) << "bends of just 30 deg are creases";
  EXPECT_EQ(mesh_of(cylinder(13, 0.04, 0.03)).faces, 3);
  EXPECT_EQ(mesh_of(samples()[2]).faces, 2 + 6 * 4) << "ends; of each bar 3, and the shell beside";
  EXPECT_EQ(mesh_of(samples()[3], 0.6 * std::numbers::pi).faces, 1);
}

TEST(Mesh, a_box_of_triangles_is_a_box) {
  const geometry::Box exact{0.03, 0.042, 0.0325};
  const Mesh mesh = mesh_of(samples()[0]);
  double worst = 0;
  Random random(6, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random_point_in(mesh.extent(), random);
    for (int face = 0; face < 6; ++face) {
      const Gap wall = exact.gap(face, p);
      double least = geometry::never;
      for (const Gap& g : touched(mesh, p, 1))
        if (norm(g.inward - wall.inward) < 1e-12)
          least = std::min(least, std::abs(g.distance - wall.distance));
      worst = max_or_nan(worst, least);
    }
  }
  stays_below("gap [m]", worst, 1e-16, "geo.7; roundings of 0.04 m");
  states("largest ball [m]", mesh.inradius(), exact.inradius(), 1e-9 * mesh.reach(),
         "half the least side, to what the search resolves");
  states("reach [m]", mesh.reach(), exact.reach(), 1e-17, "corner");
}

TEST(Mesh, facets_tend_to_the_round_wall_as_their_width_squared) {
  double last = 0;
  for (const int n : {24, 48, 96, 192}) {
    const Mesh mesh = mesh_of(cylinder(n, 0.042, 0.0325));
    double worst = 0;
    Random random(7, 1);
    for (int i = 0; i < 2000; ++i) {
      const double r = 0.019 * std::sqrt(random.uniform(0, 1)), a = random.uniform(0, 7);
      const Vec3 p{r * std::cos(a), r * std::sin(a), random.uniform(-0.01, 0.01)};
      worst = max_or_nan(worst, std::abs(mesh.gap(0, p, 1).distance - (0.021 - r)));
    }
    stays_below("error [m]", worst, 0.021 * (1 - std::cos(std::numbers::pi / n)) + 1e-16,
                "the arrow of a facet's arc, width^2/(8 R)");
    if (last > 0) states("ratio", last / worst, 4, 0.1, "error goes as the width squared");
    last = worst;
  }
}

/// A ball moves around the edge of a bar at a constant distance: from its side onto its top.
TEST(Mesh, one_ball_over_a_convex_edge_is_one_contact_and_its_direction_turns_steadily) {
  const Mesh mesh = mesh_of(samples()[2]);
  const double r = 0.1, half = 0.004, foot = std::sqrt(r * r - half * half), d = 0.003;
  const Vec3 edge{foot - 0.012, half, 0};  // the bar lies along +x
  constexpr int steps = 20000;
  const double way = 0.003 + std::numbers::pi / 2 * d + 0.003, step = way / steps;
  Vec3 last;
  double turned = 0, distance = 0;
  int not_one = 0;
  for (int i = 0; i <= steps; ++i) {
    const double s = i * step, angle = std::clamp((s - 0.003) / d, 0.0, std::numbers::pi / 2);
    Vec3 p = edge + d * Vec3{-std::sin(angle), std::cos(angle), 0};
    if (s < 0.003) p.x += 0.003 - s;
    if (s > way - 0.003) p.y -= s - (way - 0.003);
    const std::vector<Gap> gaps = touched(mesh, p, 1.2 * d);
    if (gaps.size() != 1) {
      ++not_one;
      continue;
    }
    distance = max_or_nan(distance, std::abs(gaps[0].distance - d));
    if (i > 0) turned = max_or_nan(turned, norm(gaps[0].inward - last));
    last = gaps[0].inward;
  }
  EXPECT_EQ(not_one, 0);
  stays_below("change of the distance [m]", distance, 1e-16, "the path is at a constant distance");
  stays_below("turn of the direction in a step", turned, 1.001 * step / d,
              "arc over radius: no jump where the faces hand over");
}

TEST(Mesh, a_ball_in_the_corner_of_a_cube_has_three_contacts) {
  const Mesh mesh = mesh_of(box(0.04, 0.04, 0.04));
  const Vec3 p{0.015, -0.015, 0.015};
  EXPECT_EQ(touched(mesh, p, 0.0050001).size(), 3U);
  EXPECT_EQ(touched(mesh, {0.015, -0.015, 0}, 0.0050001).size(), 2U);
  EXPECT_EQ(touched(mesh, {0.015, 0, 0}, 0.0050001).size(), 1U);
}

/// Balls exactly over corners, edges and diagonals, where rounding decides.
TEST(Mesh, a_ball_over_any_line_of_the_triangles_is_one_contact) {
  Triangles t = box(0.04, 0.04, 0.04);
  const Mesh mesh = mesh_of(t);
  int wrong = 0;
  Random random(8, 1);
  for (const Corners& c : triangles_of(mesh))
    for (std::size_t k = 0; k < 3; ++k)
      for (int i = 0; i < 50; ++i) {
        const double share = i == 0 ? 0.5 : random.uniform(0, 1);
        const Vec3 q = c[k] + share * (c[(k + 1) % 3] - c[k]);
        const Vec3 n = cross(c[1] - c[0], c[2] - c[0]);
        const Vec3 p = q - 0.002 / norm(n) * n;
        const Vec3 beside = componentwise_abs(p);
        if ((beside.x > 0.0178) + (beside.y > 0.0178) + (beside.z > 0.0178) > 1) continue;
        const std::vector<Gap> gaps = touched(mesh, p, 0.0021);
        if (gaps.size() != 1 || std::abs(gaps[0].distance - 0.002) > 1e-16) ++wrong;
      }
  const std::vector<Gap> middle = touched(mesh, {0, 0, -0.018}, 0.0021);  // apex of a fan
  EXPECT_EQ(middle.size(), 1U);
  EXPECT_EQ(wrong, 0);
}

/// A fin across a box. It is so thin that a ball beside it is equally near to its far side.
TEST(Mesh, the_far_side_of_a_thin_wall_is_not_touched) {
  const double w = 0.02;
  const Vec3 foot{-1e-4, w, 0}, tip{-2e-5, 0.005, 0};
  const Mesh mesh = mesh_of(prism({{w, -w, 0},
                                   {w, w, 0},
                                   {-foot.x, foot.y, 0},
                                   {-tip.x, tip.y, 0},
                                   tip,
                                   foot,
                                   {-w, w, 0},
                                   {-w, -w, 0}},
                                  0.04));
  const Vec3 p{-0.003, 0.012, 0}, way = foot - tip;
  const double far = norm(cross(way, p - tip)) / norm(way);
  const std::vector<Gap> gaps = touched(mesh, p, 0.004);
  ASSERT_EQ(gaps.size(), 1U);
  states("distance of the near side [m]", gaps[0].distance, far, 1e-17, "from a line");
  EXPECT_LT(gaps[0].inward.x, -0.9999);
  std::vector<double> all(static_cast<std::size_t>(mesh.faces));
  mesh.distances(p, 0.004, all);
  EXPECT_EQ(std::ranges::count_if(all, [](double d) { return d < 0.0033; }), 2)
      << "both sides are watched, for the ball may come round the tip";
}

TEST(Mesh, hollows_are_as_tight_as_the_round_wall) {
  states("radius [m]", mesh_of(samples()[1]).min_concave_radius(), 0.021, 1e-12,
         "of the drum, whatever its facets (geo.12)");
  EXPECT_EQ(mesh_of(samples()[0]).min_concave_radius(), geometry::never)
      << "faces of a box are flat";
  const double found = mesh_of(ball(4, [](const Vec3&) { return 0.02; })).min_concave_radius();
  states("radius [m]", found, 0.02, 0.1 * 0.02, "of a sphere of 2048 uneven facets, to a tenth");
}

TEST(Mesh, corners_a_little_apart_are_one_and_triangles_without_area_are_left_out) {
  Triangles t = box(0.03, 0.042, 0.0325);
  const double volume = mesh_of(t).volume();
  t[0][0] += {1e-9, 0, 0};
  t.push_back({t[1][0], t[1][0], t[1][1]});
  EXPECT_FALSE(geometry::flaw_of(geometry::weld(t)));
  states("volume [m3]", mesh_of(t).volume(), volume, 1e-9 * 0.042 * 0.0325 / 2,
         "a corner moved by a nanometre");
  // A corner in the middle of an edge, connected by a triangle without area.
  Triangles cut = box(0.03, 0.042, 0.0325);
  const auto [a, b, c] = cut[0];
  const Vec3 middle = 0.5 * (a + b);
  cut[0] = {a, middle, c};
  cut.push_back({middle, b, c});
  cut.push_back({a, b, middle});
  const geometry::Surface s = geometry::weld(cut);
  EXPECT_FALSE(geometry::flaw_of(s));
  EXPECT_EQ(mesh_of(cut).faces, 6);
}

/// CPU time [s].
template <class Do>
double spent(Do what) {
  const std::clock_t from = std::clock();
  what();
  return static_cast<double>(std::clock() - from) / CLOCKS_PER_SEC;
}

/// At the centre of a sphere every triangle is equally near. Joining visits each triangle a few
/// times; measuring takes a dozen times as long, and took eighty.
TEST(Mesh, a_fine_sphere_is_measured_in_the_time_of_a_few_joins) {
  const Triangles sphere = ball_of_triangles(80, 0.04);
  geometry::Surface surface;
  const double joining = spent([&] { surface = geometry::weld(sphere); });
  double inradius = 0;
  const double measuring = spent([&] { inradius = Mesh(surface, crease).inradius(); });
  const double step = std::numbers::pi / 80;  // flattest facets lie 1/8 of its square inside
  EXPECT_GT(inradius, 0.04 * (1 - step * step));
  EXPECT_LT(inradius, 0.04);
  stays_below("measuring over joining, 25 280 triangles", measuring / joining, 40,
              "a few looks at each triangle, not one for each of 4000 places");
}

/// A box with its triangles split into fans. Triangles without height close its sides.
Triangles flat_ones(int count) {
  Triangles t = box(0.03, 0.03, 0.03), split;
  for (const Corners& c : t)
    for (int i = 0; i < count; ++i) {
      const Vec3 a = c[0] + (1.0 * i / count) * (c[1] - c[0]);
      const Vec3 b = c[0] + ((i + 1.0) / count) * (c[1] - c[0]);
      split.push_back({a, b, c[2]});
    }
  for (const Corners& c : t)
    for (int i = 0; i + 1 < count; ++i)
      split.push_back({c[1], c[0] + ((i + 1.0) / count) * (c[1] - c[0]),
                       c[0] + (1.0 * i / count) * (c[1] - c[0])});
  return split;
}

TEST(Mesh, triangles_without_area_are_taken_out_in_linear_time) {
  const auto time_of = [](int count) {
    const Triangles t = flat_ones(count);
    return spent([&] { geometry::weld(t); });
  };
  time_of(100);
  const double few = time_of(500), many = time_of(4000);
  stays_below("joining 96 000 triangles over 12 000", many / few, 32,
              "8 if linear, 64 if quadratic");
}

}  // namespace
}  // namespace mahlwerk::tests::mesh_test
