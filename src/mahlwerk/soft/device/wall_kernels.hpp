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

/// Distance and inward normal of a face at a position in the jar frame, at the present input.
template <class S>
inline geometry::Gap gap_of(const DeviceArrays& a, std::int32_t face, const Vec3& position) {
  const WallAxes& axes = a.input().axes;
  const Rotation& turned = face < a.first_rotor_face ? axes.own : axes.rotor;
  geometry::Gap gap = shape_of<S>(a).gap(face, turned.apply_inverse(position));
  gap.inward = turned * gap.inward;
  return gap;
}

/// The point of the face nearest to the ball.
template <class S>
inline void find_wall_point(const DeviceArrays& a, std::int64_t index) {
  if (a.halted()) return;
  const std::int32_t p = a.list.pairs + static_cast<std::int32_t>(index);
  const Vec3 position = a.now.rows[a.list.i[p]].position();
  const geometry::Gap gap = gap_of<S>(a, a.list.j[p], position);
  a.wall_points[index] = position - gap.distance * gap.inward;
}

/// Calls `f(face)` for the faces near ball k.
template <class S, class F>
inline void for_each_near_face(const DeviceArrays& a, std::int32_t k, const F& f) {
  const BallRecord& ball = a.now.rows[k];
  for (std::int32_t face = 0; face < a.faces; ++face) {
    const double gap = gap_of<S>(a, face, ball.position()).distance - ball.radius;
    if (gap > a.skin + a.pull_off_distance || !shape_of<S>(a).can_touch(face, ball.radius))
      continue;
    if (!(gap > -ball.radius)) atomic_lower(&a.control->bad_ball, a.now.id[k]);
    f(face);
  }
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
