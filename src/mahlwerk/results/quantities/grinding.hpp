// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

// What collisions do to the powder (docs/theory/powder.md).
namespace mahlwerk::results {

/// The collisions of some replicates together, by kind of pair, in the energy that [capture] chose.
/// A new run of the mill is not needed to grind anew.
powder::StressSpectrum stress_spectrum(const cases::Case& what,
                                       const std::vector<const Replicate*>& of);

/// The energy that [capture] chose, as the stream knows it.
observe::StressStream::Energy stream_energy(const cases::Case& what);

/// Classes of size for a case with [grinding].
powder::SizeGrid size_grid(const cases::Case& what);

/// How the powder of a case with [grinding] gets finer under these collisions, by the balance.
/// `known`: its beds by size, where they are at hand.
powder::SizeEvolution milling_by_balance(const cases::Case& what,
                                         const powder::StressSpectrum& stresses,
                                         const powder::CaptureTable* known = nullptr);
/// Those beds, which stay the same as long as [capture], [powder] and the classes do; of a mixed
/// bed nothing that could be kept.
powder::CaptureTable beds(const cases::Case& what, const powder::StressSpectrum& stresses);

/// [J/kg] That the powder gets in a second: what is dissipated, or what caught grains get.
double dose_rate(const cases::Case& what, const std::vector<const Replicate*>& of,
                 const powder::StressSpectrum& stresses);

/// Of grains of the median size of the feed.
CaptureRates capture_rates(const cases::Case& what, const powder::StressSpectrum& stresses);

/// Fills `replicate.grinding` of a case with [capture] or [kinetics].
void grind(const cases::Case& what, Replicate& replicate, int index);

std::vector<Measure> capture_measures(const cases::Case& what);
std::vector<Measure> grinding_measures(const cases::Case& what);
std::vector<Measure> kinetics_measures(const cases::Case& what);

Table capture(const Outcome& outcome);  ///< capture.csv: a row per pair and bin of energy
Table captured_grains(
    const Outcome& outcome);             ///< captured_grains.csv: collisions by grains caught
Table grinding(const Outcome& outcome);  ///< grinding.csv: sizes over time
/// size_distribution.csv: the classes at the feed and at some times of milling.
Table size_distribution(const Outcome& outcome);
Table conversion(const Outcome& outcome);  ///< conversion.csv: over time and dose

/// Where the models are asked beyond their range; empty if all is well.
Notices grinding_warnings(const Outcome& outcome);

}  // namespace mahlwerk::results
