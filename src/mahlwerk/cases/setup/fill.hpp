// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::cases {

/// All balls of a case, set by set, at rest, positions in the jar's own axes. Sets that give places
/// stand there; the others are put around them at random places where they touch nothing: one after
/// the other where that works, the largest first; a denser charge is pushed apart from a random
/// start. Throws InputError "too-many-balls" where neither
/// does, Interrupted once `*stop` is set.
std::vector<scene::Ball> fill(const geometry::AnyShape& shape, const std::vector<BallSet>& sets,
                              Random& random, const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::cases
