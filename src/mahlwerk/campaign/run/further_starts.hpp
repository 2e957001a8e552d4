// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Runs one ball from further starts, 16 with the replicates, where engine = "auto" took the event
/// engine and a run is short: a warning if the starts lead to two states that the replicates do not
/// show (sta.7). Setting `stop` ends it.
Notices further_start_notices(const results::Outcome& outcome, const std::atomic<bool>* stop);

}  // namespace mahlwerk::campaign
