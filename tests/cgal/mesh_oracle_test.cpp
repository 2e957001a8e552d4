// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Nearest points and sides of meshes compared with CGAL, which others develop: its AABB tree and
// its ray shooting. CGAL is under the GPL and serves tests only. Without CGAL these tests are left
// out.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "mahlwerk/geometry/mesh_wall.hpp"
#include "meshes.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::mesh_oracle_test {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Surface cgal_of(const geometry::Surface& s) {
  Surface out;
  for (const Vec3& p : s.points) out.add_vertex({p.x, p.y, p.z});
  for (const auto& [a, b, c] : s.triangles)
    out.add_face(Surface::Vertex_index(static_cast<unsigned>(a)),
                 Surface::Vertex_index(static_cast<unsigned>(b)),
                 Surface::Vertex_index(static_cast<unsigned>(c)));
  return out;
}

TEST(MeshOracle, distances_and_sides_are_those_of_cgal) {
  double worst = 0, foot_off = 0;
  int wrong = 0, points = 0;
  for (const Triangles& t : {box(0.03, 0.042, 0.0325), cylinder(300, 0.042, 0.0325),
                             drum_with_lifters(0.2, 0.06, 8, 0.012, 0.008), lumpy(0.02, 5)}) {
    const geometry::MeshWall wall(geometry::weld(t), crease);
    const Surface theirs = cgal_of(wall.surface());
    Tree tree(faces(theirs).first, faces(theirs).second, theirs);
    tree.accelerate_distance_queries();
    const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(theirs);
    Random random(11, 1);
    for (int i = 0; i < 20000; ++i, ++points) {
      const Vec3 p = 1.2 * random_point_in(wall.extent(), random);
      const Kernel::Point_3 q(p.x, p.y, p.z);
      const auto found = wall.nearest(p);
      const double distance = std::sqrt(tree.squared_distance(q));
      worst = max_or_nan(worst, std::abs(std::abs(found.gap.distance) - distance));
      wrong += (side(q) == CGAL::ON_BOUNDED_SIDE) == (found.gap.distance > 0) ? 0 : 1;
      const Vec3 foot = p - found.gap.distance * found.gap.inward;
      foot_off = std::max(
          foot_off, std::sqrt(tree.squared_distance(Kernel::Point_3(foot.x, foot.y, foot.z))));
    }
  }
  stays_below("distance [m]", worst, 1e-15, "CGAL's AABB tree; roundings of 0.1 m");
  stays_below("foot off the surface [m]", foot_off, 1e-15, "CGAL's AABB tree");
  EXPECT_EQ(wrong, 0) << "of " << points << " points, beside CGAL's Side_of_triangle_mesh";
}

}  // namespace
}  // namespace mahlwerk::tests::mesh_oracle_test
