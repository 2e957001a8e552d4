// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/kinematics/motion.hpp"

// A mill whose speed is prescribed over time (kin.21, kin.27): its motion is that of the running
// mill, X(s), by a clock s(t).
namespace mahlwerk::kinematics {

/// Time of the running mill, and its two derivatives with the time of the run.
struct Clock {
  double time = 0;          ///< s [s]
  double rate = 1;          ///< ds/dt [1]
  double acceleration = 0;  ///< d2s/dt2 [1/s]
};

/// The speed at a time, as a share of the full speed; below 0 in the other sense.
struct SpeedRow {
  double time = 0;  ///< [s] since the start of the run
  double rate = 0;  ///< [1]
  bool operator==(const SpeedRow&) const = default;
};

/// The speed of a mill over time: rows, between which the rate goes by 3 u^2 - 2 u^3, so that the
/// acceleration of the mill is continuous. After the last row its rate holds, or all begins anew.
class SpeedProgram {
 public:
  SpeedProgram() = default;  ///< full speed throughout
  /// Rows in increasing times, the first at 0. `repeats`: the last has the rate of the first.
  explicit SpeedProgram(std::vector<SpeedRow> rows, bool repeats = false);
  /// From rest to full speed within `time` [s] > 0.
  static SpeedProgram ramp(double time) { return SpeedProgram({{0, 0}, {time, 1}}); }

  bool empty() const { return rows_.empty(); }
  const std::vector<SpeedRow>& rows() const { return rows_; }
  bool repeats() const { return repeats_; }
  double end() const { return empty() ? 0 : rows_.back().time; }  ///< [s] of the last row
  double last_rate() const { return empty() ? 1 : rows_.back().rate; }
  bool reverses() const;  ///< whether the mill turns in both senses

  Clock clock(double t) const;
  /// [s] Integral of the magnitude of the rate from 0 to `t` >= 0.
  double travel(double t) const;
  /// (kin.28) Bounds of the running mill, so that they hold at all times of the program.
  Bounds bounds(Bounds running) const;

  bool operator==(const SpeedProgram& o) const {
    return rows_ == o.rows_ && repeats_ == o.repeats_;
  }

 private:
  std::size_t row_at(double t) const;                 // the last one that is not after t
  double travel_in(std::size_t row, double u) const;  // [s] from it to the share u of the way

  std::vector<SpeedRow> rows_;
  std::vector<double> clocks_, travels_;  // [s] at the rows
  bool repeats_ = false;
};

}  // namespace mahlwerk::kinematics
