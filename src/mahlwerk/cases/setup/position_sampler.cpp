// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/position_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {

double wall_clearance(const geometry::AnyShape& shape, double radius, double share) {
  const double room = geometry::inradius(shape) - radius;
  return std::min(share * radius, 0.5 * room);
}

template <class S>
bool PositionSampler::free(const S& shape, const Vec3& p) const {
  bool free = true;
  geometry::for_each_near_face(shape, p, radius_, needed_, [&](int, const geometry::Gap& gap) {
    free = free && gap.distance >= needed_;
  });
  return free;
}

template <class S>
bool PositionSampler::square(const S& shape, const Vec3& p, const Vec3& axis) const {
  bool found = false;
  geometry::for_each_near_face(shape, p, radius_, needed_, [&](int, const geometry::Gap& gap) {
    found = found || (gap.distance <= needed_ && dot(gap.inward, axis) < -1 + 1e-12);
  });
  return found;
}

/// [m] Extent of the free region along an axis, by bisection. Jars are convex: if the wall at the
/// end of the axis is perpendicular to it, no free point is farther. Otherwise the reach of the
/// jar bounds the extent.
template <class S>
double PositionSampler::extent(const S& shape, const Vec3& axis) const {
  double in = 0, out = shape.reach();
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (in + out);
    (free(shape, middle * axis) ? in : out) = middle;
  }
  return S::axisymmetric || square(shape, out * axis, axis) ? out : shape.reach();
}

template <class S>
void PositionSampler::measure(const S& shape) {
  if constexpr (requires { shape.middle(); }) {  // not convex, and not centred on the origin
    const geometry::Extent e = shape.extent();
    const Vec3 low = componentwise_abs(e.low), high = componentwise_abs(e.high);
    box_ = {std::max(low.x, high.x), std::max(low.y, high.y), std::max(low.z, high.z)};
    half_size_ = 0.5 * e.size();
    centre_ = e.middle();
    middle_ = shape.middle();
    return;
  }
  const Vec3 half = 0.5 * geometry::periods_of(shape);
  box_ = {std::min(extent(shape, {1, 0, 0}), half.x), std::min(extent(shape, {0, 1, 0}), half.y),
          std::min(extent(shape, {0, 0, 1}), half.z)};
  half_size_ = box_;
}

PositionSampler::PositionSampler(const geometry::AnyShape& shape, double radius,
                                 const Obstacles* obstacles)
    : shape_(&shape),
      obstacles_(obstacles),
      radius_(radius),
      needed_(radius + wall_clearance(shape, radius, 1e-3)) {
  std::visit([&](const auto& s) { measure(s); }, shape);
}

bool PositionSampler::clear_of_parts(const Vec3& p) const {
  return obstacles_ == nullptr || obstacles_->clearance(p, radius_) >= needed_;
}

Vec3 PositionSampler::draw(Random& random) const {
  // Before the box is halved; at least half of the first box is free, unless parts fill the jar.
  const int tries = obstacles_ == nullptr || obstacles_->empty() ? 1000 : 100'000;
  for (double scale = 1; scale > 1e-9; scale *= 0.5)
    for (int i = 0; i < tries; ++i) {
      const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
      const double z = random.uniform(-1, 1);
      const Vec3 place = centre_ + Vec3{x * half_size_.x, y * half_size_.y, z * half_size_.z};
      const Vec3 p = middle_ + scale * (place - middle_);
      if (std::visit([&](const auto& s) { return free(s, p); }, *shape_) && clear_of_parts(p))
        return p;
    }
  throw InputError(
      Fault{"jar", "no position was found for a ball in the jar",
            "give a smaller ball; a mesh must not intersect itself, and parts must leave "
            "room",
            "does-not-fit"});
}

}  // namespace mahlwerk::cases
