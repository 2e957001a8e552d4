// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/event/engines.hpp"
#include "mahlwerk/event/one_ball.hpp"

namespace mahlwerk::event {

template <class S>
std::unique_ptr<scene::Engine> one_ball_in(const S& shape, const scene::Chamber& chamber,
                                           const scene::Ball& ball, const Rules& rules,
                                           double start) {
  return std::visit(
      [&](const auto& motion) -> std::unique_ptr<scene::Engine> {
        using M = std::decay_t<decltype(motion)>;
        return std::make_unique<OneBall<S, M>>(Jar<S, M>(shape, motion, chamber), ball, rules,
                                               start);
      },
      chamber.motion);
}

template <class S>
std::unique_ptr<const Enclosure> enclosure_of(const S& shape, const scene::Chamber& chamber) {
  return std::visit(
      [&](const auto& motion) -> std::unique_ptr<const Enclosure> {
        using M = std::decay_t<decltype(motion)>;
        return std::make_unique<Enclosed<S, M>>(Jar<S, M>(shape, motion, chamber));
      },
      chamber.motion);
}

}  // namespace mahlwerk::event
