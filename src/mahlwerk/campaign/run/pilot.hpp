// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {

/// What a short run by the event engine shows, over its second half.
struct Pilot {
  double time = 0;            ///< [s] simulated
  double contact_share = 0;   ///< [1] of the balls' time in contact
  double withheld_share = 0;  ///< [1] power that the TC rule withheld, over the dissipated power
  observe::Estimate power;    ///< [W] dissipated
  observe::Estimate hits;     ///< [1/s] collisions above the threshold
  bool stopped = false;       ///< physics stopped it
};

/// Collisions of a pilot run at most: half a second or so of work.
constexpr std::int64_t pilot_collisions = 400'000;

/// At most `time` [s] of simulated time or `most` collisions, the same on any machine. `stop` set
/// ends it.
Pilot pilot(const cases::Case& what, const std::atomic<bool>* stop,
            std::int64_t most = pilot_collisions, double time = 1);

/// What a shorter t_c changes in a pilot run (man.8). The engine's answer should not depend on it.
struct ContactTimeEffect {
  /// A relative change with its 95 % half-width; NaN where it could not be measured.
  struct Change {
    double share = 0, ci95 = 0;
    bool significant(double limit) const {  ///< above the limit and above what chance makes
      return (share < 0 ? -share : share) > limit && (share < 0 ? -share : share) > ci95;
    }
    bool known(double limit) const { return ci95 <= limit; }
  };
  Change power, hits;

  static constexpr double shorter = 0.25;  ///< the second t_c, over the case's
  static constexpr double most = 0.05;     ///< [1] a change that no result should depend on
  bool matters() const { return power.significant(most) || hits.significant(2 * most); }
  bool known() const { return power.known(2 * most); }
};

/// Two pilot runs over the same time, with t_c and a quarter of it; `most` collisions of the first
/// at most, four times as many of the second.
ContactTimeEffect contact_time_effect(const cases::Case& what, const std::atomic<bool>* stop,
                                      std::int64_t most = pilot_collisions);

}  // namespace mahlwerk::campaign
