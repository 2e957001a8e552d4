// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "mahlwerk/campaign/run.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::campaign {

/// Told after every stretch of time: seconds simulated and collisions since the last call, and the
/// worst relative residual of a collision's energy balance. Returns false to end the replicate
/// early.
using Told = std::function<bool(double simulated, double collisions, double residual)>;

/// One replicate of a case: settles, then counts, stretch by stretch. `keeper` gets every counted
/// record.
results::Replicate replicate(const cases::Case& what, int index, const Told& told,
                             std::unique_ptr<scene::Observer> keeper = nullptr);

/// The engine of one replicate at its start.
std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index);

}  // namespace mahlwerk::campaign
