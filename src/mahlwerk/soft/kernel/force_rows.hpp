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
      unrolled<4>([&](std::size_t n)
                      __attribute__((always_inline)) { other.rows_[n] = -rows_[n]; });
      put_rows(torque, other.rows_ + 4);
      return other;
    }
  }

  /// Adds the row of a lane to eight numbers in memory.
  [[gnu::always_inline]] void add(std::size_t lane, double* sum) const {
    each_part(
        lane, [sum](std::size_t first, const V& part) __attribute__((always_inline)) {
          store<V>(sum + first, load<V>(sum + first) + part);
        });
  }
  /// Stores the row of a lane as eight numbers.
  [[gnu::always_inline]] void put(std::size_t lane, double* row) const {
    each_part(
        lane, [row](std::size_t first, const V& part)
                  __attribute__((always_inline)) { store<V>(row + first, part); });
  }

 private:
  static constexpr bool whole = width_of<V> == 8;  // a row fills a register

  template <class F>
  [[gnu::always_inline]] void each_part(std::size_t lane, const F& f) const {
    if constexpr (whole) return f(0, rows_[lane]);
    constexpr std::size_t parts = 4 / std::min(width_of<V>, 4);
    unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
      f(p * width_of<V>, rows_[lane * parts + p]);
      f(4 + p * width_of<V>, rows_[4 + lane * parts + p]);
    });
  }

  [[gnu::always_inline]] static void put_columns(const Vec<V>& a, V* columns) {
    columns[0] = a.x, columns[1] = a.y, columns[2] = a.z, columns[3] = V{};
  }
  [[gnu::always_inline]] static void put_rows(const Vec<V>& a, V* rows) {
    if constexpr (width_of<V> == 4) {
      V r[4];
      put_columns(a, r);
      transpose(r);
      unrolled<4>([&](std::size_t n) __attribute__((always_inline)) { rows[n] = r[n]; });
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

/// Sum of rows.
template <class V>
class RowSum {
 public:
  [[gnu::always_inline]] void add(const double* row) {
    unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
      sums_[p] += load<V>(row + p * width_of<V>);
    });
  }
  [[gnu::always_inline]] void put(double* row) const {
    unrolled<parts>([&](std::size_t p) __attribute__((always_inline)) {
      store<V>(row + p * width_of<V>, sums_[p]);
    });
  }

 private:
  static constexpr std::size_t parts = 8 / width_of<V>;
  V sums_[parts]{};
};

}  // namespace mahlwerk::soft
