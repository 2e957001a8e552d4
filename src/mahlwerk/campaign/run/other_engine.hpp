// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/run/run.hpp"

namespace mahlwerk::campaign {

/// Runs one ball, for which engine = "auto" took the event engine, in the soft engine too: a
/// warning if power, hits or their energy are others there (docs/theory/engine-choice.md, "One
/// ball").
Notices other_engine_notices(const results::Outcome& outcome, const RunOptions& options);

}  // namespace mahlwerk::campaign
