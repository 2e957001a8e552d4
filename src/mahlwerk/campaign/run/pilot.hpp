// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {

/// Results of a short run with the event engine, from its second half.
struct Pilot {
  double time = 0;              ///< [s] simulated
  double contact_share = 0;     ///< [1] of the balls' time in contact
  double withheld_share = 0;    ///< [1] power that the TC rule withheld, over the dissipated power
  double hits_within = 0;       ///< [1] of the hits above the threshold, within t_c of another
  observe::Estimate power;      ///< [W] dissipated
  observe::Estimate hits;       ///< [1/s] collisions above the threshold
  observe::Estimate hit_power;  ///< [W] their normal energy per time
  bool stopped = false;         ///< a RunError ended it
};

/// Most collisions of a pilot run: about half a second of computing.
constexpr std::int64_t pilot_collisions = 400'000;

/// A pilot run of at most `time` [s] simulated and `most` collisions, the same on any machine.
/// Setting `stop` ends it.
Pilot pilot(const cases::Case& mill_case, const std::atomic<bool>* stop,
            std::int64_t most = pilot_collisions, double time = 1);

/// Effect of a shorter contact time t_c on a pilot run (man.8). Valid results do not depend on t_c.
struct ContactTimeEffect {
  observe::Estimate power, hits;  ///< [1] relative changes; NaN if they could not be measured
  observe::Estimate energy;       ///< of the mean normal energy of hits above the threshold

  static constexpr double shorter = 0.25;  ///< the shorter t_c, relative to the case's
  static constexpr double most = 0.05;     ///< [1] the largest acceptable change
  bool matters() const {
    return exceeds(power, most) || exceeds(hits, 2 * most) || exceeds(energy, 2 * most);
  }
  bool known() const { return power.ci95 <= 2 * most; }

 private:
  /// Whether a change exceeds the limit and its half-width.
  static bool exceeds(const observe::Estimate& change, double limit) {
    const double size = change.mean < 0 ? -change.mean : change.mean;
    return size > limit && size > change.ci95;
  }
};

/// Compares two pilot runs over the same time, with t_c and with a quarter of it. The first has at
/// most `most` collisions, the second four times as many.
ContactTimeEffect contact_time_effect(const cases::Case& mill_case, const std::atomic<bool>* stop,
                                      std::int64_t most = pilot_collisions);

/// "With a contact.contact_time of 25 us instead of 100 us the power of a pilot run changes by
/// ...".
std::string in_words(const ContactTimeEffect& effect, const cases::Case& mill_case);

}  // namespace mahlwerk::campaign
