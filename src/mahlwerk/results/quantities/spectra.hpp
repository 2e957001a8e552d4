// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"

// How collisions are distributed: spectrum.csv, spectra_by_pair.csv and what belongs to them.
namespace mahlwerk::results {

using HistogramMember = observe::LogHistogram observe::Spectra::*;

/// The spectra of some replicates, each with its counted time, as means over the replicates.
class MeanSpectra {
 public:
  /// Of all kinds of pairs together.
  explicit MeanSpectra(const std::vector<const Replicate*>& replicates);
  /// Of one kind of pair.
  MeanSpectra(const std::vector<const Replicate*>& replicates, int pair);

  double rate(HistogramMember part, int bin) const;   ///< [1/s] collisions in that bin
  double power(HistogramMember part, int bin) const;  ///< the sum of their values, per second
  /// First and one past the last bin that any replicate filled in any of `parts`; {0, 0}: none.
  std::array<int, 2> filled_bins(const std::vector<HistogramMember>& parts) const;
  double rate(observe::Angles observe::Spectra::*part, std::size_t degree) const;  ///< [1/s]
  double rate(int normal, int tangential) const;  ///< [1/s] of the joint histogram
  bool empty() const { return replicates_.empty(); }

 private:
  struct ReplicateSpectra {
    observe::Spectra spectra;
    double time;
  };
  template <class Of>
  double mean(const Of& of) const;
  std::vector<ReplicateSpectra> replicates_;
};

Table spectrum(const Outcome& outcome);
Table speeds(const Outcome& outcome);
Table angles(const Outcome& outcome);
/// How long contacts last; no rows where they are instantaneous.
Table durations(const Outcome& outcome);
/// The rise of the temperature in collisions; no rows where it is not known.
Table flashes(const Outcome& outcome);
/// Collisions per second by E_n and E_t together: a row per bin that holds any.
Table normal_tangential(const Outcome& outcome);
/// The spectra of each kind of pair, faces of the jar told apart: a row per bin that holds any.
Table spectra_by_pair(const Outcome& outcome);

}  // namespace mahlwerk::results
