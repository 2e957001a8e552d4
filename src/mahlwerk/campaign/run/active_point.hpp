// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "mahlwerk/campaign/run/conclude.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/run_setup.hpp"
#include "mahlwerk/cases/uncertainty.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"

namespace mahlwerk::campaign {

/// An active point: its case, engine and replicates.
struct ActivePoint {
  ActivePoint(std::size_t point, const cases::Case& made, const std::atomic<bool>* stop)
      : index(point),
        choice(choose_engine_and_bounce(made, stop)),
        decided(decided_case(made, choice)),
        outcome(begun_outcome(made, choice)),
        distinct(cases::distinct_replicates(decided)),
        left(outcome.replicates.size()) {
    const std::size_t count = left;
    if (distinct > 1)
      for (std::size_t k = 0; k < std::min(count, distinct); ++k)
        drawn.push_back(cases::case_of_replicate(decided, k));
    for (cases::Case& one : drawn) {
      one.contact.softening = decided.contact.softening;
      setups.push_back(std::make_shared<const RunSetup>(one));
    }
    if (drawn.empty()) setups.push_back(std::make_shared<const RunSetup>(decided));
  }

  const std::shared_ptr<const RunSetup>& setup_of(std::size_t replicate) const {
    return setups[replicate % distinct];
  }

  /// Takes the result of a replicate.
  void take(std::size_t replicate, results::Replicate&& ended) {
    outcome.replicates[replicate] = std::move(ended);
    if (sums) sums->ended(replicate);
  }

  std::size_t index;
  EngineChoice choice;
  cases::Case decided;  // the case with the chosen engine
  results::Outcome outcome;
  std::unique_ptr<results::SummingUp> sums;             // with RunOptions::sums_up
  std::size_t distinct;                                 // replicates that have different cases
  std::vector<cases::Case> drawn;                       // their cases, if there is more than one
  std::vector<std::shared_ptr<const RunSetup>> setups;  // of each
  std::size_t next = 0;                                 // next replicate to begin
  std::size_t left = 0;                                 // replicates that have not ended
  std::exception_ptr failure;         // of the first failed replicate: no further one is begun
  std::atomic<bool> dropped = false;  // tells active replicates to end after a failure
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
};

}  // namespace mahlwerk::campaign
