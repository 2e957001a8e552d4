// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/soft/kernel/ball_record.hpp"

// Forces and torques as a row of eight numbers for each body, in the order of VectorPair: adding a
// row takes one or two instructions, adding six columns takes six for each lane.
namespace mahlwerk::soft {

/// Force and torque of each lane as a row.
template <class V>
class ForceRows {
 public:
  ForceRows() = default;
  [[gnu::always_inline]] ForceRows(const Vec<V>& force, const Vec<V>& torque) {
    if constexpr (whole) {
      put_columns(force, rows_), put_columns(torque, rows_ + 4);
      transpose(rows_);
    } else {
      put_rows(force, rows_), put_rows(torque, rows_ + 4);
    }
  }
  /// The rows of the other bodies: the opposite forces, and their own torques.
  [[gnu::always_inline]] ForceRows opposite(const Vec<V>& force, const Vec<V>& torque) const {
    if constexpr (whole) {
      return {-force, torque};
    } else {
      ForceRows other;
      for (int n = 0; n < 4; ++n) other.rows_[n] = -rows_[n];
      put_rows(torque, other.rows_ + 4);
      return other;
    }
  }

  /// Adds the row of a lane to eight numbers in memory.
  [[gnu::always_inline]] void add(std::size_t lane, double* sum) const {
    const auto add_part = [sum](std::size_t first, const V& part) {
      store<V>(sum + first, load<V>(sum + first) + part);
    };
    if constexpr (whole) return add_part(0, rows_[lane]);
    constexpr std::size_t parts = 4 / std::min(width_of<V>, 4);
    for (std::size_t p = 0; p < parts; ++p) {
      add_part(p * width_of<V>, rows_[lane * parts + p]);
      add_part(4 + p * width_of<V>, rows_[4 + lane * parts + p]);
    }
  }

 private:
  static constexpr bool whole = width_of<V> == 8;  // a row fills a register

  [[gnu::always_inline]] static void put_columns(const Vec<V>& a, V* columns) {
    columns[0] = a.x, columns[1] = a.y, columns[2] = a.z, columns[3] = V{};
  }
  [[gnu::always_inline]] static void put_rows(const Vec<V>& a, V* rows) {
    if constexpr (width_of<V> == 4) {
      V r[4];
      put_columns(a, r);
      transpose(r);
      for (int n = 0; n < 4; ++n) rows[n] = r[n];
    } else {
      const V zero{};
      rows[0] = __builtin_shufflevector(a.x, a.y, 0, 2);
      rows[1] = __builtin_shufflevector(a.z, zero, 0, 2);
      rows[2] = __builtin_shufflevector(a.x, a.y, 1, 3);
      rows[3] = __builtin_shufflevector(a.z, zero, 1, 3);
    }
  }

  V rows_[8];
};

}  // namespace mahlwerk::soft
