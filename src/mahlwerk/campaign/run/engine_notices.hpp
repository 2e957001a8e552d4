// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

#include "mahlwerk/campaign/run/engine_choice.hpp"

namespace mahlwerk::campaign {

/// Notices on the engine that ran and on the validity of its results. Where sustained contacts may
/// matter, two pilot runs measure their effect; setting `stop` ends them.
Notices engine_notices(const results::Outcome& outcome, const EngineChoice& choice,
                       const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
