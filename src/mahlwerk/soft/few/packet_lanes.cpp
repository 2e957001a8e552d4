// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/few/packet_lanes.hpp"

#include <type_traits>

namespace mahlwerk::soft {
namespace {

/// Calls `f` with every column of a packet except inverse_radius, which FewBodySolver does not use.
template <class F>
void each_column(PairPacket& p, const F& f) {
  for (LaneMask* c : {&p.i, &p.j, &p.touching, &p.wall, &p.tensile}) f(*c);
  for (Lanes* c : {&p.radius_i, &p.radius_j, &p.overlap_share, &p.pull_off_distance, &p.friction,
                   &p.twisting_radius, &p.load, &p.twist, &p.rolling_coefficient,
                   &p.rolling_stiffness_ratio, &p.inertia, &p.slip_factor,
                   &p.phase_squared_per_stiffness, &p.half_step_squared_over_mass, &p.stiffness})
    f(*c);
  for (Lanes& c : p.coefficients) f(c);
  for (Lanes& c : p.law_history) f(c);
  for (Vec<Lanes>* v : {&p.spring, &p.normal, &p.rolling_spring_torque, &p.turning_force})
    f(v->x), f(v->y), f(v->z);
  ContactWork& d = p.work;
  for (Lanes* c :
       {&d.impulse, &d.normal, &d.tangential, &d.rolling, &d.sliding, &d.wall, &d.max_overlap})
    f(*c);
  f(p.face), f(p.species_pair), f(p.used), f(p.onset);
}

/// Calls `f` with the same column of both packets.
template <class F>
void each_column_of_both(PairPacket& a, PairPacket& b, const F& f) {
  const auto* here = reinterpret_cast<const char*>(&a);
  auto* there = reinterpret_cast<char*>(&b);
  each_column(a, [&](auto& column) {
    using Column = std::remove_reference_t<decltype(column)>;
    f(column, *reinterpret_cast<Column*>(there + (reinterpret_cast<const char*>(&column) - here)));
  });
}

}  // namespace

void clear_lane(PairPacket& p, std::size_t lane) {
  each_column(p, [&](auto& column) {
    using One = std::remove_reference_t<decltype(column[0])>;
    column[lane] = std::remove_cvref_t<One>{};
  });
}

void copy_lane(const PairPacket& from, std::size_t lane, PairPacket& to, std::size_t other_lane) {
  each_column_of_both(const_cast<PairPacket&>(from), to,
                      [&](auto& one, auto& other) { other[other_lane] = one[lane]; });
}

void swap_lanes(PairPacket& a, std::size_t lane, PairPacket& b, std::size_t other_lane) {
  each_column_of_both(a, b, [&](auto& one, auto& other) {
    const auto kept = one[lane];
    one[lane] = other[other_lane];
    other[other_lane] = kept;
  });
}

}  // namespace mahlwerk::soft
