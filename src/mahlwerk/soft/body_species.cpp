// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/body_species.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

namespace mahlwerk::soft {
namespace {

BodySpecies body_species(const scene::Ball& ball, const scene::BodyShape& shape) {
  BodySpecies s;
  s.features = scene::BodyCore(shape);
  s.ball = ball, s.mass = ball.mass(), s.reach = shape.reach() * ball.radius;
  s.inertia = s.mass * ball.radius * ball.radius * shape.inertia_ratio;
  s.inverse_inertia = {1 / s.inertia.x, 1 / s.inertia.y, 1 / s.inertia.z};
  if (shape.is_rounded()) {
    s.core = shape.core.scaled(ball.radius), s.rounding = ball.radius * shape.rounding;
    s.offsets = {Vec3{}}, s.radii = {s.reach};
    return s;
  }
  for (const geometry::MemberSphere& sphere : shape.spheres) {
    s.offsets.push_back(ball.radius * sphere.centre);
    s.radii.push_back(ball.radius * sphere.radius);
  }
  return s;
}

/// The largest eigenvalue of [r]' I^-1 [r], which has rank two.
double largest_turning_share(const Vec3& r, const Vec3& a) {
  const double xx = a.y * r.z * r.z + a.z * r.y * r.y, yy = a.z * r.x * r.x + a.x * r.z * r.z,
               zz = a.x * r.y * r.y + a.y * r.x * r.x, xy = -a.z * r.x * r.y, yz = -a.x * r.y * r.z,
               zx = -a.y * r.z * r.x;
  const double trace = xx + yy + zz;
  const double minors = xx * yy - xy * xy + yy * zz - yz * yz + zz * xx - zx * zx;
  return 0.5 * (trace + std::sqrt(std::max(0.0, trace * trace - 4 * minors)));
}

}  // namespace

double BodySpecies::least_contact_mass(std::size_t sphere) const {
  // The moment of a normal at the surface of a sphere is that at its centre.
  double most = largest_turning_share(offsets[sphere], inverse_inertia);
  for (const Vec3& corner : core.corners)
    most = std::max(most, largest_turning_share(corner, inverse_inertia));
  if (core.is_cylinder())  // I is the same about all axes across
    most =
        std::max(most, largest_turning_share({core.radius, 0, core.half_length}, inverse_inertia));
  return 1 / (1 / mass + most);
}

int BodySpecies::spheres_on_a_plane() const {
  constexpr double level = 1e-6;
  int most = 0;
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, -1, 0},
                        Vec3{0, 0, -1}}) {
    double farthest = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k)
      farthest = std::max(farthest, dot(n, offsets[k]) + radii[k]);
    int count = 0;
    for (std::size_t k = 0; k < offsets.size(); ++k)
      if (dot(n, offsets[k]) + radii[k] > farthest - level * reach) ++count;
    most = std::max(most, count);
  }
  return most;
}

BodySpeciesTable::BodySpeciesTable(const std::vector<scene::Ball>& balls,
                                   const std::vector<scene::BodyShape>& shapes) {
  if (std::ranges::all_of(shapes, &scene::BodyShape::is_sphere)) return;
  std::map<std::tuple<std::int32_t, double, double>, std::int32_t> known;
  of_ball_.reserve(balls.size());
  for (const scene::Ball& b : balls) {
    const auto kind = static_cast<std::size_t>(b.kind);
    if (kind >= shapes.size() || shapes[kind].is_sphere()) {
      of_ball_.push_back(-1);
      continue;
    }
    const auto [at, fresh] = known.try_emplace({b.kind, b.radius, b.density},
                                               static_cast<std::int32_t>(species_.size()));
    if (fresh) species_.push_back(body_species(b, shapes[kind]));
    has_rounded_ = has_rounded_ || shapes[kind].is_rounded();
    of_ball_.push_back(at->second);
  }
}

template <class Part>
std::vector<scene::Ball> BodySpeciesTable::parts(const std::vector<scene::Ball>& balls,
                                                 const Part& part) const {
  std::vector<scene::Ball> all;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (of_ball(b) < 0) {
      all.push_back(balls[b]);
      continue;
    }
    const BodySpecies& s = (*this)[of_ball(b)];
    const double inertia = std::min({s.inertia.x, s.inertia.y, s.inertia.z});
    for (std::size_t k = 0; k < s.offsets.size(); ++k) {
      scene::Ball one = balls[b];
      const auto [r, m] = part(s, k);
      one.radius = r;
      one.density = m / (4.0 / 3 * std::numbers::pi * r * r * r);
      one.inertia_ratio = inertia / (m * r * r);
      all.push_back(one);
    }
  }
  return all;
}

std::vector<scene::Ball> BodySpeciesTable::spheres(const std::vector<scene::Ball>& balls) const {
  return parts(balls,
               [](const BodySpecies& s, std::size_t k) { return std::pair(s.radii[k], s.mass); });
}

std::vector<scene::Ball> BodySpeciesTable::heaviest_contacts(
    const std::vector<scene::Ball>& balls) const {
  return parts(balls, [](const BodySpecies& s, std::size_t k) {
    return std::pair(s.is_rounded() ? s.rounding : s.radii[k], s.mass);
  });
}

std::vector<scene::Ball> BodySpeciesTable::lightest_contacts(
    const std::vector<scene::Ball>& balls) const {
  // As many contacts share a face without a shorter step: the limits have a margin for a ball
  // between several neighbours (dem.31, dem.48).
  constexpr double shared = 4;
  double largest_ball = 0;
  for (std::size_t b = 0; b < balls.size(); ++b)
    if (of_ball(b) < 0) largest_ball = std::max(largest_ball, balls[b].radius);
  return parts(balls, [&](const BodySpecies& s, std::size_t k) {
    const double least = s.least_contact_mass(k);
    if (!s.is_rounded())
      return std::pair(s.radii[k], std::min(least, s.mass * shared / s.spheres_on_a_plane()));
    // Two of these have the largest R* of two bodies; a ball on a face has two thirds of it.
    return std::pair(std::max(4 * s.edge_radius(), 2 * largest_ball), least);
  });
}

}  // namespace mahlwerk::soft
