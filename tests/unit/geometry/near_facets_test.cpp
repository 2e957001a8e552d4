// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/near_facets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "mahlwerk/geometry/mesh_wall.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::near_facets_test {
namespace {

using geometry::Gap;
using geometry::MeshWall;
using geometry::NearFacets;

std::vector<MeshWall> samples() {
  std::vector<MeshWall> all;
  for (const Triangles& t :
       {box(0.03, 0.042, 0.0325), cylinder(48, 0.042, 0.0325),
        drum_with_lifters(0.2, 0.06, 6, 0.012, 0.008), lumpy(0.02), ball_of_triangles(40, 0.02)})
    all.emplace_back(geometry::weld(t), crease);
  return all;
}

bool same_bits(const Gap& a, const Gap& b) {
  return a.distance == b.distance && a.inward == b.inward && a.curvature == b.curvature;
}

/// A ball wanders; its steps are from a millionth of the jar's size to a twentieth.
template <class Look>
void wander(const MeshWall& wall, Random& random, int steps, const Look& look) {
  Vec3 p = wall.largest_ball_centre();
  double step = 0;
  for (int i = 0; i < steps; ++i) {
    if (i % 20 == 0) step = wall.reach() * std::pow(10, random.uniform(-6, -1.3));
    const Vec3 next = p + step * random.direction();
    if (!(wall.nearest(next).gap.distance > 0)) continue;
    p = next;
    look(p);
  }
}

TEST(NearFacets, kept_facets_give_the_bits_of_a_search_from_the_root) {
  int touches = 0, others = 0;
  for (const MeshWall& wall : samples()) {
    Random random(11, 1);
    const int faces = std::min(wall.faces(), 30);
    for (const double share : {0.05, 0.3, 2.0}) {
      std::vector<NearFacets> kept(static_cast<std::size_t>(faces));
      const double within = share * wall.reach();
      wander(wall, random, 4000, [&](const Vec3& p) {
        for (int face = 0; face < faces; ++face) {
          const Gap found = wall.gap(face, p, within, kept[static_cast<std::size_t>(face)]);
          touches += found.distance < within;
          others += !same_bits(found, wall.gap(face, p, within));
        }
      });
    }
  }
  EXPECT_GT(touches, 20000);
  EXPECT_EQ(others, 0) << "gaps whose bits differ";
}

TEST(NearFacets, the_nearest_contact_has_the_bits_of_a_look_at_every_triangle) {
  int looks = 0, others = 0;
  for (const MeshWall& wall : samples()) {
    Random random(12, 1);
    if (wall.faces() > 30) continue;
    std::vector<std::int32_t> all(wall.surface().triangles.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<NearFacets> kept(static_cast<std::size_t>(wall.faces()));
    wander(wall, random, 1500, [&](const Vec3& p) {
      double least = geometry::never;
      for (int face = 0; face < wall.faces(); ++face)
        least = std::min(
            least,
            wall.gap(face, p, 2 * wall.reach(), kept[static_cast<std::size_t>(face)]).distance);
      ++looks;
      const double plain = wall.depth_beyond(0, p, all);
      others += least != plain || wall.nearest(p).gap.distance != plain;
    });
  }
  EXPECT_GT(looks, 3000);
  EXPECT_EQ(others, 0) << "distances whose bits differ";
}

/// The facets kept by one ball serve another one, and another face: they are renewed.
TEST(NearFacets, kept_facets_of_another_ball_or_face_change_no_bit) {
  int others = 0;
  for (const MeshWall& wall : samples()) {
    Random random(13, 1);
    NearFacets kept;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = random_point_in(wall.extent(), random);
      const int face = static_cast<int>(random.uniform(0, std::min(wall.faces(), 3)));
      const double within = random.uniform(0, 0.5) * wall.reach();
      others += !same_bits(wall.gap(face, p, within, kept), wall.gap(face, p, within));
    }
  }
  EXPECT_EQ(others, 0) << "gaps whose bits differ";
}

}  // namespace
}  // namespace mahlwerk::tests::near_facets_test
