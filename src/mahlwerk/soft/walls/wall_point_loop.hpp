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

/// The gaps at positions in the jar frame. `axes`: from the shape's axes to those of the jar frame;
/// null: the same.
template <class V, class S>
[[gnu::always_inline]] inline geometry::LaneGap<V> gaps_at(const S& shape, const Rotation* axes,
                                                           const V& face, const Vec<V>& position) {
  if (axes == nullptr) return shape.gaps(face, position);
  const auto along = [&](const Vec3& e) __attribute__((always_inline)) {
    return e.x * position.x + e.y * position.y + e.z * position.z;
  };
  geometry::LaneGap<V> gap =
      shape.gaps(face, Vec<V>{along(axes->ex), along(axes->ey), along(axes->ez)});
  const Vec<V> n = gap.inward;
  const auto part = [&](double Vec3::*axis) __attribute__((always_inline)) {
    return n.x * axes->ex.*axis + n.y * axes->ey.*axis + n.z * axes->ez.*axis;
  };
  gap.inward = {part(&Vec3::x), part(&Vec3::y), part(&Vec3::z)};
  return gap;
}

template <class S>
struct WallPointLoop {
  const S& shape;
  std::span<const WallPointLanes> near;
  const Rotation* axes;  ///< of gaps_at()
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
    const geometry::LaneGap<V> gap = gaps_at<V>(shape, axes, group(of.face), position);
    const Vec<V> point = position - gap.distance * gap.inward;
    const V zero{};
    const Vec<V> w{zero + spin.x, zero + spin.y, zero + spin.z};
    group.put(block.position, point);
    group.put(block.velocity, cross(w, point));
    group.put(block.angular_velocity, w);
  }
};

/// The same for the balls of a packet of ManyBodySolver: the points alone.
template <class S>
struct PacketPointLoop {
  const S& shape;
  const BallRecord* rows;
  const std::array<std::int32_t, lanes>&balls, &faces;
  const Rotation* axes;
  Vec<Lanes>& points;

  template <int width>
  [[gnu::always_inline]] static void run(const PacketPointLoop& loop) {
    for (int first = 0; first < lanes; first += width)
      loop.template put<Register<width>>(LaneGroup<Register<width>>{first});
  }

 private:
  template <class V>
  [[gnu::always_inline]] void put(const LaneGroup<V>& group) const {
    const std::int32_t *ball = balls.data() + group.first, *face = faces.data() + group.first;
    const auto column = [&](double BallRecord::*part) __attribute__((always_inline)) {
      return lanes_from<V>([&](int l)
                               __attribute__((always_inline)) { return rows[ball[l]].*part; });
    };
    const Vec<V> position{column(&BallRecord::x), column(&BallRecord::y), column(&BallRecord::z)};
    const V of = lanes_from<V>([&](int l) __attribute__((always_inline)) {
      return static_cast<double>(face[l]);
    });
    const geometry::LaneGap<V> gap = gaps_at<V>(shape, axes, of, position);
    group.put(points, position - gap.distance * gap.inward);
  }
};

}  // namespace mahlwerk::soft
