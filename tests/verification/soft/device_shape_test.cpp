// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Jars of triangles as kernels read them: arrays in the memory of a device.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <list>
#include <memory>
#include <vector>

#include "mahlwerk/geometry/mesh_view.hpp"
#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/device/kernels.hpp"
#include "meshes.hpp"

namespace mahlwerk::tests::device_shape_test {
namespace {

/// A mesh, and its arrays elsewhere.
struct Copied {
  explicit Copied(const geometry::Mesh& mesh) {
    const auto bytes = soft::shape_for_kernels(mesh, [&](const void* from, std::size_t size) {
      unsigned char* to = memory.emplace_back(*host).reserve(size);
      host->write(to, from, size);
      return to;
    });
    EXPECT_EQ(bytes.size(), sizeof view);
    std::memcpy(&view, bytes.data(), sizeof view);
  }
  bool holds(const void* array) const {
    return std::ranges::any_of(memory, [&](const auto& m) { return m.data() == array; });
  }

  std::shared_ptr<soft::Device> host = soft::host_device();
  std::list<soft::DeviceArray<unsigned char>> memory;
  geometry::MeshView view;
};

std::vector<geometry::Mesh> samples() {
  return {mesh_of(drum_with_lifters(0.05, 0.04, 6, 0.003, 0.004)), mesh_of(lumpy(0.026)),
          mesh_of(lumpy(0.026, 2), 0.2)};
}

std::array<std::uint64_t, 4> bits(const geometry::Gap& g) {
  return std::bit_cast<std::array<std::uint64_t, 4>>(
      std::array{g.distance, g.inward.x, g.inward.y, g.inward.z});
}

TEST(DeviceShape, of_a_mesh_has_all_arrays_in_the_memory_of_the_device) {
  for (const geometry::Mesh& mesh : samples()) {
    const Copied copied(mesh);
    const geometry::MeshView& view = copied.view;
    EXPECT_EQ(copied.memory.size(), 7U);
    EXPECT_TRUE(copied.holds(view.facets) && copied.holds(view.vertices) &&
                copied.holds(view.incident_sides) && copied.holds(view.roots) &&
                copied.holds(view.distance_bounds) && copied.holds(view.tree.nodes) &&
                copied.holds(view.face_tree.nodes));
  }
}

TEST(DeviceShape, of_a_mesh_answers_to_the_bit) {
  for (const geometry::Mesh& mesh : samples()) {
    const Copied copied(mesh);
    Random random(9, 0);
    int near = 0, outside = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = 1.1 * random_point_in(mesh.extent(), random);
      const double within = random.uniform(0.0005, 0.006);
      std::vector<double> all(static_cast<std::size_t>(mesh.faces)),
          found(all.size(), geometry::not_near);
      mesh.distances(p, within, all);
      copied.view.distances(p, within,
                            [&](int face, double d) { found[static_cast<std::size_t>(face)] = d; });
      EXPECT_EQ(all, found);
      outside += std::ranges::any_of(found, [](double d) { return d < 0; }) ? 1 : 0;
      for (int face = 0; face < mesh.faces; ++face) {
        const geometry::Gap gap = copied.view.gap(face, p, within);
        EXPECT_EQ(bits(mesh.gap(face, p, within)), bits(gap));
        EXPECT_EQ(mesh.distance(face, p, within), copied.view.distance(face, p, within));
        near += gap.distance <= within ? 1 : 0;
      }
    }
    EXPECT_GT(near, 200);
    EXPECT_GT(outside, 200);
  }
}

TEST(DeviceShape, of_a_mesh_without_a_surface_has_no_array) {
  const Copied copied((geometry::Mesh()));
  EXPECT_TRUE(copied.memory.empty());
  EXPECT_EQ(copied.view.faces, 0);
}

}  // namespace
}  // namespace mahlwerk::tests::device_shape_test
