// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/ball_record.hpp"

// Forces and torques as a row of eight numbers for each body, in the order of VectorPair: adding a
// row takes one or two instructions, adding six columns takes six for each lane.
namespace mahlwerk::soft {

/// Turns the force and torque of each lane into a row.
template <class V>
[[gnu::always_inline]] inline void to_rows(const Vec<V>& force, const Vec<V>& torque,
                                           double (*rows)[8]) {
  const V zero{};
  if constexpr (width_of<V> == 8) {
    V r[8] = {force.x, force.y, force.z, zero, torque.x, torque.y, torque.z, zero};
    transpose(r);
    for (std::size_t l = 0; l < 8; ++l) store<V>(rows[l], r[l]);
  } else if constexpr (width_of<V> == 4) {
    V f[4] = {force.x, force.y, force.z, zero}, t[4] = {torque.x, torque.y, torque.z, zero};
    transpose(f), transpose(t);
    for (std::size_t l = 0; l < 4; ++l) store<V>(rows[l], f[l]), store<V>(rows[l] + 4, t[l]);
  } else {
    const auto put = [&](const V& a, const V& b, std::size_t first) {
      store<V>(rows[0] + first, __builtin_shufflevector(a, b, 0, 2));
      store<V>(rows[1] + first, __builtin_shufflevector(a, b, 1, 3));
    };
    put(force.x, force.y, 0), put(force.z, zero, 2);
    put(torque.x, torque.y, 4), put(torque.z, zero, 6);
  }
}
/// Adds a row to another.
template <class V>
[[gnu::always_inline]] inline void add_row(double* sum, const double* row) {
  for (int part = 0; part < 8; part += width_of<V>)
    store<V>(sum + part, load<V>(sum + part) + load<V>(row + part));
}

}  // namespace mahlwerk::soft
