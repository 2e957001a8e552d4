// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/lane_gap.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

// Wall contact points of a register of balls at a time.
namespace mahlwerk::soft {

/// A shape with gaps of a register of points.
template <class S>
concept HasLaneGaps = requires(const S s, Register<2> face, Vec<Register<2>> p) {
  s.gaps(face, p);
};

template <class S>
struct WallPointLoop {
  const S& shape;
  std::span<const WallPointLanes> near;
  const Rotation* axes;  ///< from the shape's axes to those of the jar frame; null: the same
  Vec3 spin;             ///< [rad/s] of the wall
  BodyBlock* points;     ///< block k is that of near[k]

  template <int width>
  [[gnu::always_inline]] static void run(const WallPointLoop& loop) {
    for (std::size_t k = 0; k < loop.near.size(); ++k)
      for (int first = 0; first < lanes; first += width)
        loop.template put<Register<width>>(loop.near[k], {first}, loop.points[k]);
  }

 private:
  template <class V>
  [[gnu::always_inline]] void put(const WallPointLanes& of, const LaneGroup<V>& group,
                                  BodyBlock& block) const {
    const double* const* ball = of.ball.data() + group.first;
    const auto column = [&](int c) __attribute__((always_inline)) {
      return lanes_from<V>([&](int l)
                               __attribute__((always_inline)) { return ball[l][c * lanes]; });
    };
    const Vec<V> position{column(0), column(1), column(2)};
    geometry::LaneGap<V> gap =
        shape.gaps(group(of.face), axes == nullptr ? position : to_shape(position));
    if (axes != nullptr) gap.inward = from_shape(gap.inward);
    const Vec<V> point = position - gap.distance * gap.inward;
    const V zero{};
    const Vec<V> w{zero + spin.x, zero + spin.y, zero + spin.z};
    group.put(block.position, point);
    group.put(block.velocity, cross(w, point));
    group.put(block.angular_velocity, w);
  }

  template <class V>
  [[gnu::always_inline]] Vec<V> to_shape(const Vec<V>& a) const {
    const auto along = [&](const Vec3& e) __attribute__((always_inline)) {
      return e.x * a.x + e.y * a.y + e.z * a.z;
    };
    return {along(axes->ex), along(axes->ey), along(axes->ez)};
  }
  template <class V>
  [[gnu::always_inline]] Vec<V> from_shape(const Vec<V>& a) const {
    const auto part = [&](double Vec3::*axis) __attribute__((always_inline)) {
      return a.x * axes->ex.*axis + a.y * axes->ey.*axis + a.z * axes->ez.*axis;
    };
    return {part(&Vec3::x), part(&Vec3::y), part(&Vec3::z)};
  }
};

}  // namespace mahlwerk::soft
