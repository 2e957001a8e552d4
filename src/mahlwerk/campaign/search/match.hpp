// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"

// Similarity of two mills in what they do to their powder (docs/theory/optimum.md, "Two mills that
// do the same").
namespace mahlwerk::campaign {

/// Dose and energy spectrum of a replicate.
struct DoseSpectrum {
  double dose = 0;             ///< [W/kg] dissipated power per mass of powder; [W] without powder
  std::vector<double> shares;  ///< [1] of the collision power, by bin of energy lost
  double mean_energy = 0;      ///< [J] mean energy lost in a collision
};

/// Dose spectra of a mill: by replicate, and their mean.
struct MillSpectra {
  std::vector<DoseSpectrum> replicates;
  DoseSpectrum mean;
};

/// Per mass of powder if `by_powder`; the case must then have a powder. Replicates without
/// collisions are left out; if none is left, the mean is NaN.
MillSpectra mill_spectra(const results::Outcome& outcome, bool by_powder);
/// The same for one replicate.
DoseSpectrum dose_spectrum(const cases::Case& mill_case, const results::Replicate& replicate,
                           bool by_powder);

/// [1] Wasserstein distance of the two distributions of power over ln energy (opt.14).
double spectral_distance(const DoseSpectrum& a, const DoseSpectrum& b);
/// [1] Overlap of the two spectra: the share of power at the same energies (opt.15).
double overlap(const DoseSpectrum& a, const DoseSpectrum& b);
/// [1] Distance in dose and spectrum together (opt.16); NaN if one of them has no collisions.
double distance(const DoseSpectrum& a, const DoseSpectrum& b);
/// [J] Energy below which half of the collision power is lost.
double half_power_energy(const DoseSpectrum& m);

/// Differences of mill b from mill a; NaN: unknown.
struct Difference {
  observe::Estimate dose_a, dose_b;      ///< [W/kg], or [W]
  observe::IntervalEstimate dose;        ///< b over a (opt.13)
  observe::IntervalEstimate half_power;  ///< of the half-power energies, b over a
  observe::Estimate energy_a, energy_b;  ///< [J] mean energies lost in a collision
  double spectral = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double overlap = spectral, distance = spectral;              ///< [1]
  /// p-value of a permutation test: replicates assigned to the two mills at random differ as much
  /// (opt.17). NaN with fewer than two replicates of either mill.
  double p_value = spectral;
  bool within_scatter() const { return p_value > 0.05; }
};
Difference difference(const MillSpectra& a, const MillSpectra& b, std::uint64_t seed = 1);

/// Settings of mill b that do what mill a does, and how far that succeeds.
struct MatchResult {
  std::string title_a = {}, title_b = {}, file_a = {}, file_b = {};
  bool by_powder = false;      ///< doses are per mass of powder, else powers
  MillSpectra a = {}, b = {};  ///< b: run again at the best setting, with new seeds
  Difference difference = {};
  Optimum search = {};                 ///< the search that found the settings
  results::NoticeCounts notices = {};  ///< of the two mills
};

}  // namespace mahlwerk::campaign
