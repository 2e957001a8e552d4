// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"
#include "mahlwerk/powder/stress.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// Kinetics of a reaction of the powder (docs/theory/kinetics.md).
namespace mahlwerk::results {

/// Treatment of the powder of a case with [kinetics] by the mill, mean over the replicates in `of`.
/// `stresses`: their spectrum, if the model or the dose needs it. Other constants of [kinetics] and
/// [capture] need no new run of the mill.
powder::MillingConditions milling_conditions(const cases::Case& mill_case,
                                             const std::vector<const Replicate*>& of,
                                             const powder::StressSpectrum& stresses);

/// Whether [kinetics] needs the stress spectrum.
bool kinetics_reads_hits(const cases::Case& mill_case);

/// [s] Milling time until ignition of a case with [kinetics] model = "ignition"; infinite if it
/// is beyond ten times the milling time.
double ignition_time(const cases::Case& mill_case, const powder::MillingConditions& mill);

Measures kinetics_measures();
Table conversion(const Outcome& outcome);  ///< conversion.csv: over time and dose

/// Warnings on [kinetics]: no hit reaches the threshold, or too few; no ignition.
Notices kinetics_warnings(const Outcome& outcome);

}  // namespace mahlwerk::results
