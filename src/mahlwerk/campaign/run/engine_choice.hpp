// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Above this share of the balls' time in contact the event engine's answer is a gas of tiny
/// bounces, and the soft engine is advised (docs/theory/many-balls.md).
constexpr double contact_share_limit = 0.25;
/// Above this share of power withheld by the TC rule two pilot runs measure what it does (man.8).
constexpr double withheld_share_limit = 0.02;
/// Balls times steps that the soft engine does in about an hour on one core: "auto" does not ask
/// for more.
constexpr double most_soft_work = 6e10;

/// The same that the check of an optimum asks for, about ten minutes on one core.
constexpr double most_check_work = 1e10;

/// Which engine a case is run by, and why.
struct EngineChoice {
  cases::EngineName engine;         ///< event or soft
  std::vector<std::string> reason;  ///< empty where the case said it
};

/// As the case says; "auto" makes a short pilot run by the event engine, the same on any machine.
/// `stop` set ends the pilot.
EngineChoice choose_engine(const cases::Case& what, const std::atomic<bool>* stop = nullptr);

/// Which engine ran, why, and what to make of it.
/// Where sustained contacts may matter two pilot runs say how much; `stop` set ends them.
Notices engine_notices(const results::Outcome& outcome, const EngineChoice& choice,
                       const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
