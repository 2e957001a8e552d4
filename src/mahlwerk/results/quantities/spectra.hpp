// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/table.hpp"

// Distributions of collisions: spectrum.csv, spectra_by_pair.csv and related tables.
namespace mahlwerk::results {

using HistogramMember = observe::LogHistogram observe::Spectra::*;

/// Spectra per second of counted time, as means over replicates.
class MeanSpectra {
 public:
  MeanSpectra();  ///< of no replicate
  /// Spectra of all kinds of pairs together.
  explicit MeanSpectra(const std::vector<const Replicate*>& replicates);
  /// Spectra of one kind of pair.
  MeanSpectra(const std::vector<const Replicate*>& replicates, int pair);

  double rate(HistogramMember part, int bin) const;   ///< [1/s] collisions in the bin
  double power(HistogramMember part, int bin) const;  ///< sum of the bin's values, per second
  /// First and one past the last non-empty bin of any replicate in any of `parts`; {0, 0} if all
  /// are empty.
  std::array<int, 2> filled_bins(const std::vector<HistogramMember>& parts) const;
  double rate(observe::Angles observe::Spectra::*part, std::size_t degree) const;  ///< [1/s]
  double rate(int normal, int tangential) const;  ///< [1/s] of the joint histogram
  bool empty() const { return replicates_ == 0; }
  /// Adds the spectra of a replicate, counted for `time` [s].
  void add(const observe::Spectra& spectra, double time);

 private:
  /// Sums over replicates of one histogram, each per second.
  struct Bins {
    std::vector<double> rate, power;
    int first = observe::LogHistogram::bins, last = 0;  // that any replicate fills
  };
  using AngleRates = std::array<double, observe::angle_bins>;
  const Bins& bins_of(HistogramMember part) const;
  double mean(double sum) const;
  double replicates_ = 0;
  std::vector<Bins> bins_;
  std::vector<double> joint_;
  AngleRates angle_all_{}, angle_above_{};
};

/// Spectra of an outcome: of all kinds of pairs together, or of one.
MeanSpectra mean_spectra(const Outcome& outcome);
MeanSpectra mean_spectra(const Outcome& outcome, int pair);

/// [m/s] Mean normal speed of the collisions in the bin of the fastest ones; 0 without collisions.
double largest_speed(const Replicate& replicate);

Table spectrum(const Outcome& outcome);
Table speeds(const Outcome& outcome);
Table angles(const Outcome& outcome);
/// Durations of contacts; no rows where collisions are instantaneous.
Table durations(const Outcome& outcome);
/// Flash temperature rises of collisions; no rows without [heat].
Table flashes(const Outcome& outcome);
/// Collisions per second by E_n and E_t together: a row per non-empty bin.
Table normal_tangential(const Outcome& outcome);
/// Spectra of each kind of pair, by face of the jar: a row per non-empty bin.
Table spectra_by_pair(const Outcome& outcome);

}  // namespace mahlwerk::results
