// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "mahlwerk/soft/step_error.hpp"

namespace mahlwerk::campaign {

/// Settings of the soft engine for a case: its rules with the time step, the time scales that
/// determine it, and the elastic pairs.
struct SoftSettings {
  soft::Settings rules;
  soft::TimeSteps steps;
  contact::PairTable pairs;
  double speed = 0;  ///< [m/s] highest expected: peak wall speed and a fall through the jar
};
SoftSettings soft_settings(const cases::Case& mill_case);

/// Error of the case's time step in collisions at up to `speed` [m/s], the largest over all pairs.
soft::StepError step_error(const cases::Case& mill_case, const SoftSettings& s, double speed);
soft::StepError step_error(const cases::Case& mill_case, double speed);
/// The time step [s] that such collisions need.
double recommended_step(const cases::Case& mill_case, double speed);

/// [1] Balls times steps of one replicate by the soft engine.
double soft_work(const cases::Case& mill_case);

/// Notices on the time step, what determines it, and its error.
Notices soft_notices(const cases::Case& mill_case);
/// Before a run: warns if balls that collide at the highest expected speed overlap too much. After
/// a run, results::warnings reports the actual overlap.
Notices overlap_warnings(const cases::Case& mill_case);

/// Faults that prevent the requested engine from running a case; empty if there are none.
std::vector<Fault> run_faults(const cases::Case& mill_case);
/// Whether faults of the soft engine all come from values that another value mends: they are told,
/// and no reason for "auto" to take another engine.
bool is_of_values(const std::vector<Fault>& soft);

}  // namespace mahlwerk::campaign
