// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// The outcome of a case before its replicates: the case as it is run (decided_case()), with the
/// engine and the settling that it asks for, and empty replicates.
results::Outcome begun_outcome(const cases::Case& mill_case, const EngineChoice& choice);

/// Fills in what follows from the case and its ended replicates: CPU time, summary and notices, the
/// most severe first. Some notices need pilot runs; setting `stop` ends them.
void conclude(results::Outcome& outcome, const EngineChoice& choice,
              const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
