// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engine.hpp"

#include "mahlwerk/event/engines.hpp"

namespace mahlwerk::event {

std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start) {
  return std::visit(
      [&](const auto& shape) { return one_ball_in(shape, chamber, ball, rules, start); },
      chamber.shape);
}

}  // namespace mahlwerk::event
