// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/device/arrays.hpp"
#include "mahlwerk/soft/device/atomics.hpp"
#include "mahlwerk/soft/kernel/periodic.hpp"

// Kernels that build the lists of pairs. Balls are sorted by cells, each cell by the ids of its
// balls, so that lists and sums do not depend on the order in which threads come. A first pass
// counts what each ball or cell has, a scan gives each its place, and a second pass writes there.
namespace mahlwerk::soft {

// Cells.

/// A coordinate in cells, from the low end of the grid; within the grid, or folded into it.
inline std::int32_t cell_along(double x, double low, double inverse, std::int32_t count,
                               bool wrapped) {
  double at = (x - low) * inverse;
  if (wrapped) at -= count * __builtin_floor(at / count);
  const double last = count - 1;
  return static_cast<std::int32_t>(at < 0 ? 0 : at > last ? last : at);
}
struct CellPlace {
  std::int32_t at[3];
};
inline CellPlace place_in(const CellGrid& g, const BallRecord& row) {
  return {{cell_along(row.x, g.low.x, g.inverse_size.x, g.count[0], g.wrapped[0]),
           cell_along(row.y, g.low.y, g.inverse_size.y, g.count[1], g.wrapped[1]),
           cell_along(row.z, g.low.z, g.inverse_size.z, g.count[2], g.wrapped[2])}};
}
inline std::int32_t cell_number(const CellGrid& g, std::int32_t x, std::int32_t y, std::int32_t z) {
  return g.first + (z * g.count[1] + y) * g.count[0] + x;
}
inline int class_of(const DeviceArrays& a, std::int32_t k) {
  return a.size_class[a.now.species[k]];
}

/// Least and largest coordinates of some of the balls.
struct Corners {
  Vec3 low, high;
};
inline void find_corners(const DeviceArrays& a, std::int64_t index) {
  constexpr double far = 1e300;
  Corners c{{far, far, far}, {-far, -far, -far}};
  for (auto k = static_cast<std::int32_t>(index); k < a.balls; k += a.partials) {
    const Vec3 p = a.now.rows[k].position();
    if (!(squared(p) < far)) atomic_lower(&a.control->bad_ball, a.now.id[k]);
    c.low = {min(c.low.x, p.x), min(c.low.y, p.y), min(c.low.z, p.z)};
    c.high = {max(c.high.x, p.x), max(c.high.y, p.y), max(c.high.z, p.z)};
  }
  reinterpret_cast<Corners*>(a.partial)[index] = c;
}

inline void count_cells(const DeviceArrays& a, std::int64_t index) {
  const auto k = static_cast<std::int32_t>(index);
  const CellGrid& grid = a.grid[class_of(a, k)];
  const CellPlace place = place_in(grid, a.now.rows[k]);
  a.cell[k] = cell_number(grid, place.at[0], place.at[1], place.at[2]);
  atomic_add(&a.cell_first[a.cell[k]], 1);
}
inline void fill_cells(const DeviceArrays& a, std::int64_t index) {
  const auto k = static_cast<std::int32_t>(index);
  const std::int32_t cell = a.cell[k];
  a.order[a.cell_first[cell] + atomic_add(&a.cursor[cell], 1)] = k;
}
/// Sorts numbers by a key, in place.
template <class Key>
inline void sort_by(std::int32_t* numbers, std::int32_t count, const Key& key) {
  for (std::int32_t n = 1; n < count; ++n) {
    const std::int32_t number = numbers[n];
    const auto mine = key(number);
    std::int32_t at = n;
    for (; at > 0 && key(numbers[at - 1]) > mine; --at) numbers[at] = numbers[at - 1];
    numbers[at] = number;
  }
}
inline void sort_cell(const DeviceArrays& a, std::int64_t index) {
  const std::int32_t first = a.cell_first[index], last = a.cell_first[index + 1];
  sort_by(a.order + first, last - first, [&](std::int32_t k) { return a.now.id[k]; });
}
/// Copies the balls to their new rows.
inline void sort_balls(const DeviceArrays& a, std::int64_t index) {
  const std::int32_t from = a.order[index];
  a.sorted.rows[index] = a.now.rows[from];
  a.sorted.spins[index] = a.now.spins[from];
  a.sorted.half_step[index] = a.now.half_step[from];
  a.sorted.species[index] = a.now.species[from];
  a.sorted.id[index] = a.now.id[from];
  a.reference[index] = a.now.rows[from].position();
}

// Scans: sums of all numbers before each, in segments.

inline std::int32_t segment_begin(const DeviceArrays& a, std::int64_t segment) {
  return static_cast<std::int32_t>(segment * a.scan_count / a.partials);
}
inline void sum_segment(const DeviceArrays& a, std::int64_t index) {
  std::int32_t sum = 0;
  for (std::int32_t n = segment_begin(a, index); n < segment_begin(a, index + 1); ++n)
    sum += a.scanned[n];
  a.scan_partials[index] = sum;
}
/// By one thread.
inline void scan_segments(const DeviceArrays& a, std::int64_t) {
  std::int32_t sum = 0;
  for (std::int32_t n = 0; n < a.partials; ++n) {
    const std::int32_t count = a.scan_partials[n];
    a.scan_partials[n] = sum;
    sum += count;
  }
  a.scanned[a.scan_count] = sum;
}
inline void scan_segment(const DeviceArrays& a, std::int64_t index) {
  std::int32_t sum = a.scan_partials[index];
  for (std::int32_t n = segment_begin(a, index); n < segment_begin(a, index + 1); ++n) {
    const std::int32_t count = a.scanned[n];
    a.scanned[n] = sum;
    sum += count;
  }
}

// Pairs of balls.

/// Whether two balls are within the skin and the pair's pull-off distance.
inline bool are_near(const DeviceArrays& a, std::int32_t k, std::int32_t j) {
  const BallRecord &ball = a.now.rows[k], &other = a.now.rows[j];
  Vec<double> apart{other.x - ball.x, other.y - ball.y, other.z - ball.z};
  if (a.constants.periodic) apart = folded(apart, a.constants.periods);
  const std::int32_t pair = a.now.species[k] * a.species_row + a.now.species[j];
  const double within =
      ball.radius + other.radius + a.skin + a.parameters[pair].pull_off_distance[0];
  return dot(apart, apart) < within * within;
}

/// The cells around a place along one axis. Of a periodic axis with up to three cells, all are
/// near, and each counts once.
struct CellRange {
  std::int32_t low, high;
};
inline CellRange cells_around(const CellGrid& g, std::int32_t at, int axis) {
  const std::int32_t last = g.count[axis] - 1;
  if (g.wrapped[axis]) return last < 3 ? CellRange{0, last} : CellRange{at - 1, at + 1};
  return {at > 0 ? at - 1 : 0, at < last ? at + 1 : last};
}
inline std::int32_t wrapped_cell(const CellGrid& g, std::int32_t at, int axis) {
  const std::int32_t n = g.count[axis];
  return at < 0 ? at + n : at >= n ? at - n : at;
}

/// Calls `f(j)` for the balls j > k of one grid that are near ball k.
template <class F>
inline void for_each_near_in(const DeviceArrays& a, const CellGrid& g, std::int32_t k, const F& f) {
  const CellPlace place = place_in(g, a.now.rows[k]);
  const CellRange along_x = cells_around(g, place.at[0], 0),
                  along_y = cells_around(g, place.at[1], 1),
                  along_z = cells_around(g, place.at[2], 2);
  for (std::int32_t z = along_z.low; z <= along_z.high; ++z)
    for (std::int32_t y = along_y.low; y <= along_y.high; ++y)
      for (std::int32_t x = along_x.low; x <= along_x.high; ++x) {
        const std::int32_t cell =
            cell_number(g, wrapped_cell(g, x, 0), wrapped_cell(g, y, 1), wrapped_cell(g, z, 2));
        for (std::int32_t j = a.cell_first[cell]; j < a.cell_first[cell + 1]; ++j)
          if (j > k && are_near(a, k, j)) f(j);
      }
}

/// Calls `f(j)` for the balls j > k near ball k. Rows are sorted by size class, so that the larger
/// ball of two classes has the larger number.
template <class F>
inline void for_each_near(const DeviceArrays& a, std::int32_t k, const F& f) {
  for (int c = class_of(a, k); c < a.classes; ++c) for_each_near_in(a, a.grid[c], k, f);
}
inline void count_pairs(const DeviceArrays& a, std::int64_t index) {
  std::int32_t count = 0;
  for_each_near(a, static_cast<std::int32_t>(index), [&](std::int32_t) { ++count; });
  a.list.pair_first[index] = count;
}

/// Copies the history of a contact from the old list, with ball i as the first; `sign` is -1 where
/// the balls have changed places.
inline void keep_contact(const DeviceArrays& a, std::int32_t p, std::int32_t old, double sign) {
  a.list.touch[p] = Touch::touching;
  ContactState state = a.old_list.state[old];
  state.spring = sign * state.spring;
  a.list.state[p] = state;
  if (a.list.optional != nullptr) {
    OptionalState optional = a.old_list.optional[old];
    optional.rolling_spring_torque = sign * optional.rolling_spring_torque;
    a.list.optional[p] = optional;
  }
  if (a.list.friction != nullptr) {
    FrictionState friction = a.old_list.friction[old];
    friction.turning_force = sign * friction.turning_force;
    a.list.friction[p] = friction;
  }
}

inline void fill_pairs(const DeviceArrays& a, std::int64_t index) {
  const auto k = static_cast<std::int32_t>(index);
  const ContactList& old = a.old_list;
  std::int32_t p = a.list.pair_first[k];
  for_each_near(a, k, [&](std::int32_t j) {
    a.list.i[p] = k, a.list.j[p] = j;
    a.list.touch[p] = Touch::apart;
    a.sums[p] = {};
    const std::int32_t was_i = a.order[k], was_j = a.order[j];
    const std::int32_t first = was_i < was_j ? was_i : was_j,
                       second = was_i < was_j ? was_j : was_i;
    if (old.touch != nullptr)
      for (std::int32_t q = old.pair_first[first]; q < old.pair_first[first + 1]; ++q)
        if (old.j[q] == second && old.touch[q] == Touch::touching)
          keep_contact(a, p, q, first == was_i ? 1 : -1);
    ++p;
  });
}

// The pairs whose second ball is a given one.

inline void count_incoming(const DeviceArrays& a, std::int64_t index) {
  atomic_add(&a.incoming_first[a.list.j[index]], 1);
}
inline void fill_incoming(const DeviceArrays& a, std::int64_t index) {
  const std::int32_t j = a.list.j[index];
  a.incoming[a.incoming_first[j] + atomic_add(&a.cursor[j], 1)] = static_cast<std::int32_t>(index);
}
inline void sort_incoming(const DeviceArrays& a, std::int64_t index) {
  const std::int32_t first = a.incoming_first[index], last = a.incoming_first[index + 1];
  sort_by(a.incoming + first, last - first, [](std::int32_t p) { return p; });
}

}  // namespace mahlwerk::soft
