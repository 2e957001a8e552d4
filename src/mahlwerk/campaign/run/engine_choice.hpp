// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Above this share of the balls' time in contact, the engines differ in their hits by more than a
/// tenth, and the soft engine is recommended (docs/theory/engine-choice.md).
constexpr double contact_share_limit = 0.1;
/// Above this share of hits that begin within the contact time of another hit of the same body, the
/// engines differ in their hits by more than a tenth (docs/theory/engine-choice.md).
constexpr double hits_within_limit = 0.3;
/// Above this share of power withheld by the TC rule, two pilot runs measure the effect of the
/// contact time (man.8).
constexpr double withheld_share_limit = 0.02;
/// Balls times steps that the soft engine computes in about an hour on one core: the most for which
/// "auto" chooses it.
constexpr double max_soft_work = 6e10;

/// The same for the check of an optimum, about ten minutes on one core.
constexpr double max_check_work = 1e10;

/// The engine that runs a case, and why.
struct EngineChoice {
  cases::EngineName engine;         ///< event or soft
  std::vector<std::string> reason;  ///< empty if the case names the engine
};

/// The engine that the case names. For "auto", chosen from the case and, if necessary, a short
/// pilot run of the event engine, which is the same on any machine. Setting `stop` ends the pilot
/// run.
EngineChoice choose_engine(const cases::Case& mill_case, const std::atomic<bool>* stop = nullptr);

/// Notices on the engine that ran and on the validity of its results. Where sustained contacts may
/// matter, two pilot runs measure their effect; setting `stop` ends them.
Notices engine_notices(const results::Outcome& outcome, const EngineChoice& choice,
                       const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
