// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/files/json_value.hpp"
#include "mahlwerk/results/files/result_tables.hpp"

// What a page asks of the simulator: to check a case, to compute one replicate in slices, and to
// merge the replicates that several workers computed.
namespace mahlwerk::web {

/// Values that replace those of the case's text, as `--set` does.
using Overrides = std::vector<cases::Override>;

/// The catalogue, which travels in the module.
const cases::Catalogue& catalogue();

/// Reads a case from text. Throws InputError with all faults, those of the engine included.
cases::Case read_case(const std::string& text, const Overrides& set);

/// Title, engine, balls, times, origins and notices of a valid case.
results::Json description(const cases::Case& mill_case);

/// Jar and balls at the start, as the data of a replay of one frame.
std::string first_picture(const cases::Case& mill_case);

/// `{"faults": [...]}`; the line and column are those of the case's text, 0 where it has none.
results::Json faults_json(const std::vector<Fault>& faults);

/// One replicate of a case.
class Session {
 public:
  /// The balls are in place, nothing is computed. Throws InputError.
  Session(cases::Case mill_case, int replicate);
  Session(const Session&) = delete;  // the replicate refers to the case
  Session& operator=(const Session&) = delete;

  /// Computes for about `milliseconds`; at least one slice. Returns how far the replicate is.
  results::Json advance(double milliseconds);
  /// The result of the open replicate so far; made once until the next advance().
  const results::Outcome& outcome_so_far();
  /// Its tables, likewise.
  const std::vector<results::NamedTable>& tables_so_far();
  /// The data of the replay; "null" with less than two frames.
  std::string film() const;
  std::string state();

 private:
  cases::Case mill_case_;
  campaign::EngineChoice choice_;
  cases::Case decided_;  // with the chosen engine
  campaign::ReplicateRun replica_;
  std::optional<results::Outcome> so_far_;
  std::vector<results::NamedTable> tables_;  // of so_far_; empty if not made
};

/// The outcome of the case from the states of all its replicates, in order, as `mahlwerk run` makes
/// it. Throws InputError if a state is not one of this case.
results::Outcome merged_outcome(const cases::Case& mill_case,
                                const std::vector<std::string_view>& states);

}  // namespace mahlwerk::web
