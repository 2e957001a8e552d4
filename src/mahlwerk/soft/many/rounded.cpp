// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "mahlwerk/geometry/convex_core.hpp"
#include "mahlwerk/soft/many/solver.hpp"

// Rounded convex bodies (docs/theory/bodies.md). Such a body has one row, the sphere that holds it.
// In a contact the sphere of its rounding that is nearest to the other body stands for it.
namespace mahlwerk::soft {

/// The species of a row that is a rounded body; else null.
const BodySpecies* ManyBodySolver::rounded_species(std::int32_t row) const {
  const auto at = static_cast<std::size_t>(row);
  if (!is_member(at)) return nullptr;
  const BodySpecies& of = body_species_[bodies_.rows[bodies_.body(at)].species];
  return of.is_rounded() ? &of : nullptr;
}

/// The core of a row that stands at `centre`; of a sphere its centre.
geometry::PlacedCore ManyBodySolver::placed_core(std::int32_t row, const Vec3& centre) const {
  const BodySpecies* of = rounded_species(row);
  if (of == nullptr) return {nullptr, centre, {}};
  const std::size_t body = bodies_.body(static_cast<std::size_t>(row));
  return {&of->core, centre, rotation_of(bodies_.now[body].orientation)};
}

ManyBodySolver::TouchingSpheres ManyBodySolver::touching_spheres(
    std::int32_t i, std::int32_t j, geometry::NearestHulls hulls) const {
  const BallRecord& a = rows_[static_cast<std::size_t>(i)];
  if (j < 0) {
    TouchingSpheres t = sphere_at_wall(i, ~j);
    const geometry::Gap gap =
        jar_->gap(~j, a.position() + t.arm_i, wall_axes_, t.radius_i + pull_off_distance_);
    t.distance = gap.distance, t.normal = -gap.inward;
    return t;
  }
  if (has_rounded({i, j})) {
    if (i < j) return of_rounded_pair(i, j, hulls);
    TouchingSpheres t = of_rounded_pair(j, i, hulls.swapped());  // so that both sides find the same
    std::swap(t.arm_i, t.arm_j), std::swap(t.radius_i, t.radius_j);
    std::swap(t.curvature_i, t.curvature_j);
    t.normal = -t.normal, t.hulls = t.hulls.swapped();
    return t;
  }
  const BallRecord& b = rows_[static_cast<std::size_t>(j)];
  const Vec3 separation = nearest(b.position() - a.position());
  const double distance = norm(separation);
  return {.radius_i = a.radius,
          .radius_j = b.radius,
          .normal = (1 / distance) * separation,
          .distance = distance,
          .curvature_i = 1 / a.radius,
          .curvature_j = 1 / b.radius};
}

/// By the points of both cores that are nearest to each other (bod.21).
ManyBodySolver::TouchingSpheres ManyBodySolver::of_rounded_pair(
    std::int32_t i, std::int32_t j, geometry::NearestHulls hulls) const {
  const Vec3 way = nearest(rows_[static_cast<std::size_t>(j)].position() -
                           rows_[static_cast<std::size_t>(i)].position());
  const geometry::PlacedCore a = placed_core(i, {}), b = placed_core(j, way);
  const auto rounding = [&](std::int32_t row) {
    const BodySpecies* of = rounded_species(row);
    return of != nullptr ? of->rounding : rows_[static_cast<std::size_t>(row)].radius;
  };
  TouchingSpheres t{.radius_i = rounding(i), .radius_j = rounding(j)};
  const geometry::NearestPoints near = geometry::nearest_points(a, b, hulls);
  t.hulls = hulls;
  if (near.distance == 0) {  // the step ends the run
    t.meeting = true;
    t.arm_i = 0.5 * way, t.arm_j = -0.5 * way;
    t.normal = (1 / norm(way)) * way;
    return t;
  }
  t.arm_i = near.on_a, t.arm_j = near.on_b - way;
  t.distance = near.distance, t.normal = (1 / near.distance) * (near.on_b - near.on_a);
  const auto curvature = [](const geometry::PlacedCore& core, double r, const Vec3& arm,
                            const Vec3& out, geometry::CoreFeature feature) {
    return core.core == nullptr
               ? 1 / r
               : geometry::mean_curvature(*core.core, r, core.axes.apply_inverse(arm),
                                          core.axes.apply_inverse(out), feature);
  };
  t.curvature_i = curvature(a, t.radius_i, t.arm_i, t.normal, near.feature_a);
  t.curvature_j = curvature(b, t.radius_j, t.arm_j, -t.normal, near.feature_b);
  return t;
}

/// The sphere that touches a face of the jar, without its distance: at the corner or the point of a
/// rim that is nearest to the face.
ManyBodySolver::TouchingSpheres ManyBodySolver::sphere_at_wall(std::int32_t i, int face) const {
  const BodySpecies* of = rounded_species(i);
  if (of == nullptr) {
    const double radius = rows_[static_cast<std::size_t>(i)].radius;
    return {.radius_i = radius, .curvature_i = 1 / radius};
  }
  TouchingSpheres t{
      .arm_i = wall_arm(i, face), .radius_i = of->rounding, .curvature_i = 1 / of->rounding};
  const Vec3 at = rows_[static_cast<std::size_t>(i)].position() + t.arm_i;
  t.meeting = !(jar_->gap(face, at, wall_axes_, geometry::never).distance > 0);  // ends the run
  return t;
}

Vec3 ManyBodySolver::wall_arm(std::int32_t i, int face) const {
  const Vec3 centre = rows_[static_cast<std::size_t>(i)].position();
  const geometry::PlacedCore core = placed_core(i, centre);
  if (core.core == nullptr) return {};
  return geometry::nearest_to_wall(
             core, [&](const Vec3& x) { return jar_->gap(face, x, wall_axes_, geometry::never); }) -
         centre;
}

bool ManyBodySolver::has_rounded(const NeighbourPair& pair) const {
  return body_species_.has_rounded() &&
         (rounded_species(pair.ball) != nullptr ||
          (pair.other >= 0 && rounded_species(pair.other) != nullptr));
}

/// Those that touch become contacts.
void ManyBodySolver::test_near_pairs(Chunk& chunk) {
  std::vector<NearPair>& all = chunk.near_pairs;
  for (std::size_t k = all.size(); k-- > 0;) {
    if (path_ < all[k].due) continue;
    const NeighbourPair pair = all[k].pair;
    all[k] = all.back();
    all.pop_back();
    activate(chunk, pair);  // or back into the list, until later
    ++chunk.sums.tests;
  }
}

/// [m] Bound of the distance that any point of the bodies of a chunk moves in this step.
double ManyBodySolver::largest_move(const Chunk& chunk) const {
  double most = 0;
  for (auto row = static_cast<std::size_t>(chunk.first); row < static_cast<std::size_t>(chunk.last);
       ++row) {
    if (!is_member(row)) {
      most = std::max(most, norm(next_rows_[row].position() - rows_[row].position()));
      continue;
    }
    if (bodies_.sphere_of[row] > 0) continue;
    const std::size_t b = bodies_.body(row);
    const BodySpecies& of = body_species_[bodies_.rows[b].species];
    const Vec3& inverse = of.inverse_inertia;
    const double turned = settings_.time_step * norm(second_vector(bodies_.motion[b].half_step)) *
                          std::max({inverse.x, inverse.y, inverse.z});
    most = std::max(most, norm(bodies_.next[b].centre - bodies_.now[b].centre) + of.reach * turned);
  }
  return most;
}

void ManyBodySolver::follow_moves() {
  double most = 0;
  for (const Chunk& chunk : chunks_) {
    most = std::max(most, chunk.largest_move);
    if (chunk.meeting_cores >= 0)
      stop(static_cast<std::size_t>(chunk.meeting_cores), "its edges are pressed in completely");
  }
  path_ += 2 * most + settings_.time_step * jar_->max_wall_speed();
}

void ManyBodySolver::place_contact_spheres(Chunk& chunk, ContactPackets& list, std::size_t n) {
  const ContactPacket& g = list.packets[n];
  const bool wall = &list == &chunk.wall;
  ContactSpheres& out = chunk.spheres;
  const auto place = [&](std::size_t at, std::int32_t row, const Vec3& arm, double radius) {
    const auto k = static_cast<std::size_t>(row);
    const BallRecord& body = rows_[k];
    const SpinRecord& spin = spins_[k];
    const Vec3 x = body.position() + arm,
               v = Vec3{body.u, body.v, body.w} + cross(Vec3{spin.x, spin.y, spin.z}, arm);
    out.rows[at] = {x.x, x.y, x.z, radius, v.x, v.y, v.z, 0};
    out.spins[at] = spin;
  };
  for (std::size_t l = 0; l < lanes; ++l) {
    TouchingSpheres t;
    if (g.touches(l)) {
      t = wall ? sphere_at_wall(g.i[l], g.j[l])
               : touching_spheres(g.i[l], g.j[l], list.hulls[n][l]);
      list.hulls[n][l] = t.hulls;
    }
    set_lane(out.arm_i, l, t.arm_i), set_lane(out.arm_j, l, t.arm_j);
    place(l, g.i[l], t.arm_i, t.radius_i);
    if (!wall) place(lanes + l, g.j[l], t.arm_j, t.radius_j);
    if (t.meeting) chunk.meeting_cores = g.i[l];
  }
}

}  // namespace mahlwerk::soft
