// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/table.hpp"

// Tables of a result, one function per file (docs/formats.md).
namespace mahlwerk::results {

Table time_series(const Outcome& outcome);  ///< timeseries.csv: one row per time window
Table replicates(const Outcome& outcome);   ///< replicates.csv: one row per replicate

/// stopped-1.csv: the balls of one replicate when physics stopped it.
Table balls_at_stop(const Replicate& replicate);
/// final-1.csv: the balls of one replicate at its end, as run.start_from reads them.
Table balls_at_end(const Replicate& replicate);
Table start_state(const std::vector<cases::BallState>& state);  ///< the same of a start state
std::string final_name(int replicate);                          ///< "final-1" for `replicate` 0
std::string stopped_name(int replicate);                        ///< "stopped-1" for `replicate` 0

}  // namespace mahlwerk::results
