// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// Capture, grinding and dose of the powder (docs/theory/powder.md).
namespace mahlwerk::results {

/// Stress spectrum of the replicates in `of`, by kind of pair, for the energy that [capture]
/// chooses. New grinding parameters need no new run of the mill.
powder::StressSpectrum stress_spectrum(const cases::Case& mill_case,
                                       const std::vector<const Replicate*>& of);

/// The energy that [capture] chooses, as StressStream::Energy.
observe::StressStream::Energy stream_energy(const cases::Case& mill_case);

/// Size classes of a case with [grinding].
powder::SizeGrid size_grid(const cases::Case& mill_case);

/// Size evolution of the powder of a case with [grinding] by the population balance. `known`: its
/// capture table, if it is available.
powder::SizeEvolution milling_by_balance(const cases::Case& mill_case,
                                         const powder::StressSpectrum& stresses,
                                         const powder::CaptureTable* known = nullptr);
/// Capture table of the case. It is valid as long as [capture], [powder] and the classes do not
/// change. Empty for a mixed bed, whose captures change with the powder.
powder::CaptureTable beds(const cases::Case& mill_case, const powder::StressSpectrum& stresses);

/// [W/kg] Dose rate of the powder: dissipated power, or power of captured grains, by its mass.
double dose_rate(const cases::Case& mill_case, const std::vector<const Replicate*>& of,
                 const powder::StressSpectrum& stresses);

/// Capture rates of grains of the feed's median size.
CaptureRates capture_rates(const cases::Case& mill_case, const powder::StressSpectrum& stresses);

/// Fills `replicate.grinding` of a case with [capture] or [kinetics]. `index`: number of the
/// replicate, from 0, which selects its random numbers.
void grind(const cases::Case& mill_case, Replicate& replicate, int index);

Measures capture_measures();
Measures grinding_measures();

Table capture(const Outcome& outcome);  ///< capture.csv: a row per pair and bin of energy
Table captured_grains(
    const Outcome& outcome);             ///< captured_grains.csv: collisions by captured grains
Table grinding(const Outcome& outcome);  ///< grinding.csv: sizes over time
/// size_distribution.csv: shares of the classes in the feed and at some milling times.
Table size_distribution(const Outcome& outcome);

}  // namespace mahlwerk::results
