// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"

// The speed of a mill in a run, of all quantities that need it: not always that of its case.
namespace mahlwerk::results {

/// [1] Mean speed of the mill over that of its case (cases::shaft_speed) between two states of a
/// run: 1 of a mill of constant speed. A mill whose speed is prescribed over time counts in both
/// senses; that of a motor below 0 if it has turned the other way.
double mill_rate(const cases::Case& c, const scene::EnergyBalance& from,
                 const scene::EnergyBalance& to);
/// In the counted time of a replicate.
double mill_rate(const cases::Case& c, const Replicate& r);
/// Its mean over the averaged replicates; 1 without any.
double mill_rate(const Outcome& outcome);
/// Whether the mill turns in one sense, from which angles of the charge are measured.
inline bool has_one_sense(const cases::Case& c) {
  return !c.mill.speed_over_time.reverses();
}
constexpr std::string_view in_one_sense = "if they turn in one sense";
/// [rad/s] Mean speed of the shaft in the counted time; 0 where no shaft turns.
double mill_speed(const cases::Case& c, const Replicate& r);

}  // namespace mahlwerk::results
