// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/step_block.hpp"
#include "mahlwerk/soft/kernel/force_rows.hpp"

// Bodies of the lanes of a packet: their numbers are gathered, their forces put to rows. V is a
// register.
namespace mahlwerk::soft {

/// With eight lanes and at most sixteen bodies, two registers hold a column of all bodies, and one
/// permute instruction picks eight. Clang has no such operation for registers of its vector type.
#if defined(__clang__)
template <class V>
constexpr bool can_permute = false;
#else
template <class V>
constexpr bool can_permute = width_of<V> == lanes;

/// Picks for each lane the number `at` of those of two registers.
template <class V>
[[gnu::always_inline]] inline V permute(const V& low, const V& high, const MaskOf<V>& at) {
  return __builtin_shuffle(low, high, at);
}

/// Adds the forces and torques of a packet to eight balls in registers, in the order of its lanes.
template <class V>
[[gnu::always_inline]] inline void gather_forces(const GatherMap& map, const ContactForce<V>& f,
                                                 Vec<V>& force, Vec<V>& torque) {
  const LaneGroup<V> group;
  const Vec<V> back = -f.force;
  for (std::size_t k = 0; k < static_cast<std::size_t>(map.max_contacts); ++k) {
    const MaskOf<V> source = group(map.source[k]), active = group(map.active[k]);
    const auto add = [&](V& all, const V& i, const V& j) {
      all += where<V>(active, permute<V>(i, j, source));
    };
    add(force.x, f.force.x, back.x);
    add(force.y, f.force.y, back.y);
    add(force.z, f.force.z, back.z);
    add(torque.x, f.torque_i.x, f.torque_j.x);
    add(torque.y, f.torque_i.y, f.torque_j.y);
    add(torque.z, f.torque_i.z, f.torque_j.z);
  }
}
#endif

/// The bodies of a packet, in memory or in registers.
template <class V>
struct Bodies {
  const BodyBlock* blocks;
  bool in_registers;

  /// Gathers a column of bodies i or j. `at` are their indices, `bodies` their addresses.
  template <std::size_t column>
  [[gnu::always_inline]] V gather(const LaneMask& at,
                                  const std::array<const double*, lanes>& bodies,
                                  const LaneGroup<V>& group) const {
    if constexpr (can_permute<V>)
      if (in_registers) {
        const auto columns = [&](std::size_t b) {
          return group(reinterpret_cast<const Lanes*>(blocks + b)[column]);
        };
        return permute<V>(columns(0), columns(1), group(at));
      }
    return lanes_from<V>([&](int l) { return bodies.data()[group.first + l][column * lanes]; });
  }
  /// Gathers three columns, from `column` on.
  template <std::size_t column>
  [[gnu::always_inline]] Vec<V> gather_vector(const LaneMask& at,
                                              const std::array<const double*, lanes>& bodies,
                                              const LaneGroup<V>& group) const {
    return {gather<column>(at, bodies, group), gather<column + 1>(at, bodies, group),
            gather<column + 2>(at, bodies, group)};
  }
  [[gnu::always_inline]] Vec<V> position(const LaneMask& at,
                                         const std::array<const double*, lanes>& bodies,
                                         const LaneGroup<V>& group) const {
    return gather_vector<0>(at, bodies, group);
  }
  [[gnu::always_inline]] Vec<V> velocity(const LaneMask& at,
                                         const std::array<const double*, lanes>& bodies,
                                         const LaneGroup<V>& group) const {
    return gather_vector<3>(at, bodies, group);
  }
  [[gnu::always_inline]] Vec<V> angular_velocity(const LaneMask& at,
                                                 const std::array<const double*, lanes>& bodies,
                                                 const LaneGroup<V>& group) const {
    return gather_vector<6>(at, bodies, group);
  }
};

/// The bits of a group's lanes among those of a packet.
template <class V>
[[gnu::always_inline]] inline std::uint32_t bits_of(const LaneGroup<V>& group) {
  return ((1U << width_of<V>)-1) << group.first;
}

/// Puts the forces and torques of a group to the rows of its lanes.
template <class V>
[[gnu::always_inline]] inline void put_forces(GatherMap& map, const LaneGroup<V>& group,
                                              const ContactForce<V>& f) {
  const ForceRows<V> on_i(f.force, f.torque_i), on_j = on_i.opposite(f.force, f.torque_j);
  ForceRow *const *row_i = map.row_i.data() + group.first, *const *row_j =
                                                               map.row_j.data() + group.first;
  unrolled<width_of<V>>([&](std::size_t l) __attribute__((always_inline)) {
    on_i.put(l, row_i[l]->values);
    on_j.put(l, row_j[l]->values);
  });
  map.filled |= bits_of(group);
}

/// Clears the rows of a group in which nothing touches any more.
template <class V>
[[gnu::always_inline]] inline void clear_forces(GatherMap& map, const LaneGroup<V>& group) {
  if ((map.filled & bits_of(group)) == 0) return;
  ForceRow *const *row_i = map.row_i.data() + group.first, *const *row_j =
                                                               map.row_j.data() + group.first;
  unrolled<width_of<V>>([&](std::size_t l)
                            __attribute__((always_inline)) { *row_i[l] = *row_j[l] = ForceRow{}; });
  map.filled &= ~bits_of(group);
}

}  // namespace mahlwerk::soft
