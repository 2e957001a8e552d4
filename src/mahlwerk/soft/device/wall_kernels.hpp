// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/geometry/shape.hpp"
#include "mahlwerk/soft/device/list_kernels.hpp"

// Kernels of balls and faces: a call computes one pair, or lists those of one ball.
namespace mahlwerk::soft {

template <class S>
const S& shape_of(const DeviceArrays& a) {
  static_assert(std::is_trivially_copyable_v<S> && sizeof(S) <= sizeof a.shape);
  return *reinterpret_cast<const S*>(a.shape);
}

inline const Rotation& axes_of_face(const DeviceArrays& a, std::int32_t face) {
  const WallAxes& axes = a.input().axes;
  return face < a.first_rotor_face ? axes.own : axes.rotor;
}

/// The point of the face nearest to the ball.
template <class S>
inline void find_wall_point(const DeviceArrays& a, std::int64_t index) {
  if (a.halted()) return;
  const std::int32_t p = a.list.pairs + static_cast<std::int32_t>(index), face = a.list.j[p];
  const BallRecord& ball = a.now.rows[a.list.i[p]];
  const Rotation& turned = axes_of_face(a, face);
  const double within = (1 + past_touch) * ball.radius + a.pull_off_distance;
  const Vec3 position = ball.position();
  const geometry::Gap gap =
      geometry::gap_near(shape_of<S>(a), face, turned.apply_inverse(position), within);
  a.wall_points[index] = position - gap.distance * (turned * gap.inward);
}

/// A shape that finds its near faces by itself, and by that whether a point is outside.
template <class S>
concept FindsNearFaces = requires(const S s, void (*f)(std::int32_t, double)) {
  s.distances(Vec3{}, 0.0, f);
};

/// Calls `f(face)` for the faces near ball k.
template <class S, class F>
inline void for_each_near_face(const DeviceArrays& a, std::int32_t k, const F& f) {
  const BallRecord& ball = a.now.rows[k];
  const S& shape = shape_of<S>(a);
  const double reach = a.skin + a.pull_off_distance, within = ball.radius + reach;
  std::int32_t first = 0, last = a.faces - 1;
  bool outside = false;
  if constexpr (FindsNearFaces<S>) {
    first = a.faces, last = -1;
    shape.distances(axes_of_face(a, 0).apply_inverse(ball.position()), within,
                    [&](std::int32_t face, double distance) {
                      first = std::min(first, face), last = std::max(last, face);
                      outside = outside || distance < 0;
                    });
  }
  for (std::int32_t face = first; face <= last; ++face) {
    const Vec3 p = axes_of_face(a, face).apply_inverse(ball.position());
    const double distance = geometry::distance(shape, face, p, within),
                 gap = distance - ball.radius;
    if (gap > reach || !shape.can_touch(face, ball.radius)) continue;
    outside = outside || !(gap > -ball.radius);
    f(face);
  }
  if (outside) atomic_lower(&a.control->bad_ball, a.now.id[k]);
}
template <class S>
inline void count_walls(const DeviceArrays& a, std::int64_t index) {
  std::int32_t count = 0;
  for_each_near_face<S>(a, static_cast<std::int32_t>(index), [&](std::int32_t) { ++count; });
  a.list.wall_first[index] = count;
}
template <class S>
inline void fill_walls(const DeviceArrays& a, std::int64_t index) {
  const auto k = static_cast<std::int32_t>(index);
  const ContactList& old = a.old_list;
  std::int32_t n = a.list.wall_first[k];
  for_each_near_face<S>(a, k, [&](std::int32_t face) {
    const std::int32_t p = a.list.pairs + n;
    a.list.i[p] = k, a.list.j[p] = face;
    a.list.touch[p] = Touch::apart;
    a.sums[p] = {};
    const std::int32_t was = a.order[k];
    if (old.touch != nullptr)
      for (std::int32_t m = old.wall_first[was]; m < old.wall_first[was + 1]; ++m)
        if (old.j[old.pairs + m] == face && old.touch[old.pairs + m] == Touch::touching) {
          keep_contact(a, p, old.pairs + m, 1);
          a.list.normals[n] = old.normals[m];
        }
    ++n;
  });
}

}  // namespace mahlwerk::soft
