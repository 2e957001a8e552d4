// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/part_map.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

// Maps and spectra of a run of many replicates: each is added to sums when it has ended, and
// forgotten.
namespace mahlwerk::results {

/// Sums over the replicates with Replicate::read_before, in their order, so that they are to the
/// bit those of a loop over all.
struct SummedUp {
  double expected = 0;  ///< number of replicates that the means on the wall are taken over
  MeanSpectra spectra;
  std::vector<MeanSpectra> by_pair;
  WallRates wall;
  std::vector<PartRates> parts;
  observe::Charge charge;
};

/// Whether the maps and spectra of a case's replicates can be forgotten: its powder and
/// the hits of bodies are computed from those of all replicates at the end.
bool can_be_summed_up(const cases::Case& mill_case);

/// Sums up the replicates of an outcome while it is computed. Thread-safe.
class SummingUp {
 public:
  explicit SummingUp(Outcome& outcome);
  void ended(std::size_t replicate);  ///< its result is in the outcome

 private:
  void add(std::size_t replicate);
  ReadBefore read(std::size_t replicate) const;

  Outcome& outcome_;
  std::shared_ptr<SummedUp> sums_;
  std::vector<Measure> measures_;
  cases::CaseBySense by_sense_;
  std::vector<bool> ended_;
  std::size_t next_ = 0;               // the first replicate that has not ended
  std::vector<std::size_t> complete_;  // before it, not yet summed up
  std::mutex mutex_;
};

}  // namespace mahlwerk::results
