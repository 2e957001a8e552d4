// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engine.hpp"

#include "mahlwerk/event/engines.hpp"
#include "mahlwerk/event/many_balls.hpp"

namespace mahlwerk::event {

std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (S::faces > 0)
          return one_ball_in(shape, chamber, ball, rules, start);
        else
          return many_balls(chamber, {ball}, rules, {1, 0, rules.bounce}, start);
      },
      chamber.shape);
}

std::unique_ptr<scene::Engine> many_balls(const scene::Chamber& chamber,
                                          const std::vector<scene::Ball>& balls, const Rules& rules,
                                          const contact::BounceTable& bounces, double start) {
  return std::visit(
      [&](const auto& shape) -> std::unique_ptr<scene::Engine> {
        return std::make_unique<ManyBalls>(enclosure_of(shape, chamber), balls, rules, bounces,
                                           start);
      },
      chamber.shape);
}

}  // namespace mahlwerk::event
