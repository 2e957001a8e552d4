// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <variant>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {
namespace {

/// Approximate number of triangles of a rotating jar in a frame
/// (results/quantities/jar_surface.hpp).
double triangles(const geometry::Box&) {
  return 12;
}
double triangles(const geometry::PeriodicBox&) {
  return 12;
}
double triangles(const geometry::LifterCylinder& jar) {
  return 16 * jar.lifters + 200;
}
double triangles(const geometry::PeriodicLifterCylinder& jar) {
  return 16 * jar.lifters + 200;
}
double triangles(const geometry::Attritor& jar) {
  return 160 * jar.arms + 400;
}
double triangles(const geometry::Mesh& jar) {
  return static_cast<double>(jar.surface().triangles.size());
}
template <class Round>
double triangles(const Round&) {
  return 2200;
}

double triangles_of_parts(const Case& c) {
  double sum = 0;
  for (const MachinePart& part : c.machine_parts)
    if (const auto* mesh = std::get_if<geometry::MeshSolid>(&*part.body.solid))
      sum += static_cast<double>(mesh->surface().triangles.size());
    else
      sum += 200;
  return sum;
}

}  // namespace

bool jar_mesh_is_static(const Case& c) {
  const Vec3 axis = kinematics::fixed_axis(*c.mill.motion);
  const bool turns = kinematics::bounds(*c.mill.motion).spin > 0;
  const bool stirred = geometry::as<geometry::Attritor>(*c.jar.shape) != nullptr;
  const bool along =
      geometry::axisymmetric(*c.jar.shape) && norm(cross(axis, c.mill.jar_axis)) < 1e-12;
  const bool still_parts = std::ranges::all_of(c.machine_parts, [](const MachinePart& p) {
    return !p.body.motion.moves() && !p.body.in_laboratory;
  });
  const bool round = c.machine_parts.empty() || !turns;  // parts turn with the jar
  return !stirred && still_parts && round && (!turns || along);
}

double frame_bytes(const Case& c) {
  double balls = 0;  // of bodies, their spheres
  for (const BallSet& set : c.balls) {
    const BallShape& body = set.body;
    const auto drawn =
        body.is_convex() ? static_cast<std::int64_t>(body.solid().spheres.size()) : body.count();
    balls += static_cast<double>(set.count) * static_cast<double>(drawn);
  }
  const bool forces = c.run.engine == EngineName::soft || c.run.engine == EngineName::automatic;
  double bytes = 0;
  if (c.observe.frames_format != FramesFormat::vtk) bytes += 530 + (forces ? 270 : 210) * balls;
  if (c.observe.frames_format == FramesFormat::xyz) return bytes;
  bytes += 2200 + (forces ? 160 : 128) * balls;
  if (!jar_mesh_is_static(c))  // half as many vertices as triangles, in base64
    bytes += 1000 + 37.3 * std::visit([](const auto& s) { return triangles(s); }, *c.jar.shape) +
             37.3 * triangles_of_parts(c);
  return bytes;
}

}  // namespace mahlwerk::cases
