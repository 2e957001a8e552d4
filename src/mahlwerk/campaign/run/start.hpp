// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::campaign {

/// Makes the engine of a case for a jar on a mill, and balls in it.
using EngineMaker = std::function<std::unique_ptr<scene::Engine>(const scene::Chamber&,
                                                                 const std::vector<scene::Ball>&)>;

/// The balls of a replicate when its mill starts: the starting balls, after run.settle_at_rest [s]
/// in the jar at rest. Throws Interrupted once `*stop` is set.
std::vector<scene::Ball> balls_at_start(const cases::Case& mill_case, const scene::Chamber& mill,
                                        int replicate, const EngineMaker& make,
                                        const std::atomic<bool>* stop = nullptr);

/// The balls in the axes of the jar's carrier, as run.start_from reads them. `balls` are those of
/// the jar frame at `time` [s] of the mill.
std::vector<scene::Ball> seen_from_carrier(const cases::Case& mill_case,
                                           std::vector<scene::Ball> balls, double time);

}  // namespace mahlwerk::campaign
