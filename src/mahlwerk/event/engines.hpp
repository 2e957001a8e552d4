// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The engine for one shape and every motion; each shape is compiled in a file of its own, side by
/// side.
template <class S>
std::unique_ptr<scene::Engine> one_ball_in(const S& shape, const scene::Chamber& chamber,
                                           const scene::Ball& ball, const Rules& rules,
                                           double start);

}  // namespace mahlwerk::event
