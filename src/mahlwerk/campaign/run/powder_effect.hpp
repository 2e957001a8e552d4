// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::campaign {

struct EngineChoice;

/// The restitution of bodies with powder between them (fbk.1), found by runs of one replicate, each
/// with the restitution that follows from the last.
struct PowderEffect {
  double clean = 1;            ///< without powder
  double balls = 1, wall = 1;  ///< of balls with each other, and with jar and parts
  int runs = 0;
  double last_change = 0;                     ///< [1] by the last run
  double power_clean = 0, power_found = 0;    ///< [W] dissipated
  std::optional<double> size = std::nullopt;  ///< [m] of the powder after the milling time
};

/// Of a case with [powder_feedback], as decided. None without it, or if `stop` is set or a run
/// fails. The same on any machine.
std::optional<PowderEffect> powder_effect(const cases::Case& decided,
                                          const std::atomic<bool>* stop = nullptr);

/// The case with this restitution; pairs of its own keep theirs.
cases::Case with_powder(cases::Case mill_case, const PowderEffect& effect);

/// What the powder changes, in a sentence.
std::string in_words(const PowderEffect& effect, double accuracy);

}  // namespace mahlwerk::campaign
