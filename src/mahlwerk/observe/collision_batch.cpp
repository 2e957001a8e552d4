// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/collision_batch.hpp"

#include <cstring>
#include <numbers>

#include "mahlwerk/observe/histogram.hpp"

namespace mahlwerk::observe {
namespace {

/// atan of 0 <= x <= 1 within 2e-8 rad (Abramowitz & Stegun 4.4.49). Takes half the time of
/// std::atan2 and, unlike the C library's, gives the same bits on every machine.
template <class V>
[[gnu::always_inline]] inline V arc_tangent(V x) {
  const V s = x * x;
  V p = 0.0028662257 * s - 0.0161657367;
  p = p * s + 0.0429096138;
  p = p * s - 0.0752896400;
  p = p * s + 0.1065626393;
  p = p * s - 0.1420889944;
  p = p * s + 0.1999355085;
  p = p * s - 0.3333314528;
  return x * (p * s + 1.0);
}

/// atan2(a, b) for a, b >= 0; 0 if both are 0.
template <class V>
[[gnu::always_inline]] inline V angle_between(V a, V b) {
  const V large = max(a, b), small = min(a, b), none{};
  const V angle = arc_tangent(small / max(large, none + 1e-300));
  return select(b < a, 0.5 * std::numbers::pi - angle, angle);
}

template <class V>
[[gnu::always_inline]] inline V read(const Column<double>& c, std::size_t at) {
  return load<V>(c.values + at);
}
template <class T, class V>
[[gnu::always_inline]] inline void write(Column<T>& c, std::size_t at, V v) {
  static_assert(sizeof(T) == sizeof(double));
  std::memcpy(c.values + at, &v, sizeof v);
}

/// LogHistogram::bin_of() of each lane.
template <class V>
[[gnu::always_inline]] inline MaskOf<V> bins_of(V value) {
  using H = LogHistogram;
  using Words = typename RegisterOf<width_of<V>>::Words;
  const V none{};
  const Words bits = (Words)min(max(value, none + H::least), none + H::most);
  const V m = (V)((bits & 0xfffffffffffff) | 0x3ff0000000000000);  // 1 <= m < 2
  const MaskOf<V> octave = (MaskOf<V>)(bits >> 52) - (1023 + H::lowest_octave);
  return (octave << 2) + 3 + less(m, none + H::edges[1]) + less(m, none + H::edges[2]) +
         less(m, none + H::edges[3]);
}

/// Angle of (x, y) as a share of a turn, 0 <= share < 1.
template <class V>
[[gnu::always_inline]] inline V share_of_turn(V x, V y) {
  const V none{}, first = angle_between(abs(y), abs(x)) * (0.5 / std::numbers::pi);
  const V half = select(less(x, none), 0.5 - first, first);
  const V share = select(less(y, none), 1.0 - half, half);
  return select(less(share, none + 1.0), share, none);
}

/// Index of the slot, of `many`, that `share` falls into, clamped to the first and last.
template <class V>
[[gnu::always_inline]] inline V slot(V share, int many) {
  const V none{};
  const V at = min(max(share * many, none), none + (many - 1));
  constexpr double whole = 0x1p52;
  const V near = (at + whole) - whole;  // to the nearest whole number
  return select(less(at, near), near - 1.0, near);
}

/// Converts small whole numbers to integers.
template <class V>
[[gnu::always_inline]] inline MaskOf<V> whole(V a) {
  constexpr double shift = 0x1p52;
  return (MaskOf<V>)(a + shift) & ((std::int64_t{1} << 32) - 1);
}

/// Indices of WallGrid cells, as floating-point whole numbers.
template <class V>
[[gnu::always_inline]] inline V cells_of(const WallGrid& g, V x, V y, V z, V axial) {
  constexpr double level = std::numbers::sqrt2 / 2;
  const V none{}, turn = share_of_turn(x, y);
  const V side =
      slot((z - g.bottom) * (1 / (g.top - g.bottom)), WallGrid::along) * WallGrid::around +
      slot(turn, WallGrid::around);
  const V ring = slot((x * x + y * y) * (1 / (g.radius * g.radius)), WallGrid::rings);
  const V disc = WallGrid::side_cells + ring * WallGrid::sectors + slot(turn, WallGrid::sectors) +
                 select(less(none, axial), none + WallGrid::disc_cells, none);
  return select(less(none + level, abs(axial)), disc, side);
}

}  // namespace

double impact_angle(double approach, double slip) {
  return angle_between(slip, approach);  // (obs.1)
}

int cell_of(const WallGrid& grid, const Vec3& where, double axial) {
  return static_cast<int>(cells_of(grid, where.x, where.y, where.z, axial));
}

void CollisionBatch::load(std::span<const scene::Collision> records, const WallGrid& wall) {
  count = records.size();
  for (std::size_t i = 0; i < count; ++i) {
    const scene::Collision& c = records[i];
    mass.values[i] = c.mass;
    approach.values[i] = c.approach;
    slip.values[i] = c.slip;
    glide.values[i] = c.glide;
    lost_normal.values[i] = c.lost_normal;
    lost_tangential.values[i] = c.lost_tangential;
    duration.values[i] = c.duration;
    x.values[i] = c.where.x;
    y.values[i] = c.where.y;
    z.values[i] = c.where.z;
    axial.values[i] = c.normal.z;
  }
  derive_(*this, wall);
}

struct CollisionBatch::Derive {
  template <int width>
  [[gnu::always_inline]] static void run(CollisionBatch& batch, const WallGrid& wall) {
    batch.derive<Register<width>>(wall);
  }
};

CollisionBatch::CollisionBatch()
    : derive_(Multiversioned<Derive, void (*)(CollisionBatch&, const WallGrid&)>::best()) {}

template <class V>
[[gnu::always_inline]] inline void CollisionBatch::derive(const WallGrid& wall) {
  for (std::size_t i = 0; i < count; i += width_of<V>) {
    const V half = 0.5 * read<V>(mass, i), u = read<V>(approach, i), v = read<V>(slip, i);
    const V w = read<V>(glide, i), n = u * u, t = v * v;
    const V normal = half * u * u, tangential = half * t, point = half * (n + t);
    const V centre = half * (n + w * w), ln = read<V>(lost_normal, i),
            lt = read<V>(lost_tangential, i);
    write(energy_normal, i, normal);
    write(energy_tangential, i, tangential);
    write(energy_contact_point, i, point);
    write(energy_centre, i, centre);
    write(lost, i, ln + lt);
    write(angle, i, angle_between(v, u));
    const V grazing = 2.0 * u * v - 3.0 * n;
    write(erosion, i, read<V>(mass, i) * select<V>(less<V>(v, 3.0 * u), t * (1.0 / 3), grazing));
    write(bin_normal, i, bins_of(normal));
    write(bin_tangential, i, bins_of(tangential));
    write(bin_contact_point, i, bins_of(point));
    write(bin_centre, i, bins_of(centre));
    write(bin_lost, i, bins_of<V>(ln + lt));
    write(bin_lost_normal, i, bins_of(ln));
    write(bin_lost_tangential, i, bins_of(lt));
    write(bin_approach, i, bins_of(u));
    write(cell, i,
          whole(cells_of(wall, read<V>(x, i), read<V>(y, i), read<V>(z, i), read<V>(axial, i))));
  }
}

}  // namespace mahlwerk::observe
