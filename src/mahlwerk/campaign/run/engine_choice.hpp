// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/run/powder_effect.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Above this share of the balls' time in contact, the engines differ in their hits by more than a
/// tenth, and the soft engine is recommended (docs/theory/engine-choice.md).
constexpr double contact_share_limit = 0.1;
/// Above this share of hits that begin within the contact time of another hit of the same body, the
/// engines differ in their hits by more than a tenth (docs/theory/engine-choice.md).
constexpr double hits_within_limit = 0.1;

/// [s] CPU time of a ball and step of the soft engine (docs/performance.md).
constexpr double ball_step_cost = 33e-9;
/// Balls times steps of all replicates up to which "auto" takes the soft engine with contacts as
/// stiff as the case gives them: about two minutes on one core. It softens contacts of longer runs.
constexpr double comfortable_work = 3e9;
/// The most for which "auto" takes the soft engine without looking whether the event engine is
/// valid: about half an hour on one core.
constexpr double max_soft_work = 6e10;
/// The same for the check of an optimum, about five minutes on one core.
constexpr double max_check_work = 1e10;

/// The engine that runs a case, how, and why.
struct EngineChoice {
  cases::EngineName engine;              ///< never auto
  std::vector<std::string> reason = {};  ///< empty if the case names the engine
  /// Factor on the stiffness of contacts if "auto" shortens a long run; none: as in the case.
  std::optional<double> softening = std::nullopt;
  /// Of a case with [powder_feedback]; choose_engine() finds it only if asked.
  std::optional<PowderEffect> powder = std::nullopt;
};

/// The engine that the case names. For "auto": the event engine for one ball; for several the soft
/// engine, with softened contacts where the run would take long, and the event engine only if the
/// soft engine cannot run the case, or if it would take too long and a pilot run of the settled
/// mill shows that the event engine is valid (docs/theory/engine-choice.md). The same on any
/// machine. Setting `stop` ends a pilot run.
EngineChoice choose_engine(const cases::Case& mill_case, const std::atomic<bool>* stop = nullptr);
/// The same, and for a case with [powder_feedback] the restitution with powder, which takes runs.
EngineChoice choose_engine_and_bounce(const cases::Case& mill_case,
                                      const std::atomic<bool>* stop = nullptr);

/// The name of the contact law if it is adhesive; the event engine does not model adhesion.
std::optional<std::string_view> adhesive_law(const cases::Case& mill_case);

/// The case as it is run: with the chosen engine and softening, and with the counted time that
/// follows from run.settle = "auto" (cases::counted_time()). The origins of the values say so.
cases::Case decided_case(const cases::Case& mill_case, const EngineChoice& choice);

}  // namespace mahlwerk::campaign
