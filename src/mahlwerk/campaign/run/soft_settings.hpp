// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::campaign {

/// How the soft engine will run a case: its rules with the time step, and what that step rests on.
struct SoftSettings {
  soft::Rules rules;
  soft::TimeSteps steps;
  double speed = 0;  ///< [m/s] at which balls may meet: peak wall speed and a fall through the jar
};
SoftSettings soft_settings(const cases::Case& what);

/// [1] Balls times steps of one replicate by the soft engine.
double soft_work(const cases::Case& what);

/// In words: the time step, and what it rests on.
Notices soft_notices(const cases::Case& what);
/// Before a run: whether balls that meet at the highest speed would overlap by much. A run tells
/// what it reached (results::warnings).
Notices overlap_warnings(const cases::Case& what);

/// What keeps the engine a case asks for from running it; empty if nothing does.
std::vector<Fault> run_faults(const cases::Case& what);

}  // namespace mahlwerk::campaign
