// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

// How alike two mills treat their powder (docs/theory/optimum.md, "Two mills that do the same").
namespace mahlwerk::campaign {

/// What a replicate does, as mills are compared.
struct DoseSpectrum {
  double dose = 0;             ///< [W/kg] dissipated power per mass of powder; [W] without powder
  std::vector<double> shares;  ///< [1] of the power of collisions, by bin of the energy lost in one
  double mean_energy = 0;      ///< [J] mean energy lost in a collision
};

/// What a mill does: by replicate, and all together.
struct MillSpectra {
  std::vector<DoseSpectrum> replicates;
  DoseSpectrum mean;
};

/// By mass of the powder where `by_powder` says so, which the case must have. Replicates without
/// collisions are left out; with none left the mean is NaN.
MillSpectra mill_spectra(const results::Outcome& outcome, bool by_powder);
/// The same of one replicate.
DoseSpectrum dose_spectrum(const cases::Case& what, const results::Replicate& replicate,
                           bool by_powder);

/// [1] Between the two distributions of ln energy by power: how far one must be moved to become the
/// other (opt.14).
double spectral_distance(const DoseSpectrum& a, const DoseSpectrum& b);
/// [1] Power that both have at the same energies, as a share (opt.15).
double overlap(const DoseSpectrum& a, const DoseSpectrum& b);
/// [1] Of dose and spectrum together (opt.16); NaN where one of them has no collisions.
double distance(const DoseSpectrum& a, const DoseSpectrum& b);
/// [J] Half of the power is lost in collisions of less energy.
double half_power_energy(const DoseSpectrum& m);

/// A ratio with its 95 % interval.
struct Ratio {
  double value = 0, low = 0, high = 0;
};

/// How mill b differs from mill a.
struct Difference {
  Ratio dose;                         ///< b over a (opt.13)
  Ratio half_power;                   ///< of the energies with half of the power below, b over a
  double energy_a = 0, energy_b = 0;  ///< [J] mean energies lost in a collision
  double energy_a_ci95 = 0, energy_b_ci95 = 0;  ///< half-widths
  double spectral = 0, overlap = 0, distance = 0;
  /// How often replicates dealt to the two mills at random differ as much (opt.17); NaN with fewer
  /// than two of each.
  double p_value = 0;
  bool within_scatter() const { return p_value > 0.05; }
};
Difference difference(const MillSpectra& a, const MillSpectra& b, std::uint64_t seed = 1);

}  // namespace mahlwerk::campaign
