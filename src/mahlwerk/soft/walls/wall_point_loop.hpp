// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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
  std::span<const WallNeighbour> near;
  const Rotation* axes;  ///< from the shape's axes to those of the jar frame; null: the same
  Vec3 spin;             ///< [rad/s] of the wall
  const BodyBlock* balls;
  BodyBlock* points;  ///< point k is that of near[k]

  template <int width>
  [[gnu::always_inline]] static void run(const WallPointLoop& loop) {
    for (std::size_t k = 0; k < loop.near.size(); k += width) loop.template put<Register<width>>(k);
  }

 private:
  /// Points k to k + width - 1. Those after the last one of `near` are computed from its ball.
  template <class V>
  [[gnu::always_inline]] void put(std::size_t k) const {
    const auto at = [&](int l) __attribute__((always_inline))->const WallNeighbour& {
      return near[std::min(k + static_cast<std::size_t>(l), near.size() - 1)];
    };
    const auto column = [&](Lanes Vec<Lanes>::*axis) __attribute__((always_inline)) {
      return lanes_from<V>([&](int l) __attribute__((always_inline)) {
        const auto ball = static_cast<std::size_t>(at(l).ball);
        return (balls[ball / lanes].position.*axis)[ball % lanes];
      });
    };
    const V face = lanes_from<V>([&](int l) __attribute__((always_inline)) {
      return static_cast<double>(at(l).face);
    });
    const Vec<V> position{column(&Vec<Lanes>::x), column(&Vec<Lanes>::y), column(&Vec<Lanes>::z)};
    geometry::LaneGap<V> gap = shape.gaps(face, axes == nullptr ? position : to_shape(position));
    if (axes != nullptr) gap.inward = from_shape(gap.inward);
    const Vec<V> point = position - gap.distance * gap.inward;
    const V zero{};
    const Vec<V> w{zero + spin.x, zero + spin.y, zero + spin.z};
    BodyBlock& block = points[k / lanes];
    const LaneGroup<V> group{static_cast<int>(k % lanes)};
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
