// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engine.hpp"

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/event/engines.hpp"
#include "mahlwerk/event/many_balls.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::event {
namespace {

template <class S>
InputError not_exact() {
  return InputError(Fault{"jar",
                          "the event engine does not take a jar of kind " + std::string(S::name),
                          "write engine = \"soft\"", "jar-needs-soft"});
}

}  // namespace

std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (!geometry::has_exact_touches<S>)
          throw not_exact<S>();
        else if constexpr (S::faces > 0)
          return one_ball_in(shape, chamber, ball, rules, start);
        else
          return many_balls(chamber, {ball}, rules, {1, 0, rules.bounce}, start);
      },
      *chamber.shape);
}

std::unique_ptr<scene::Engine> many_balls(const scene::Chamber& chamber,
                                          const std::vector<scene::Ball>& balls, const Rules& rules,
                                          const contact::BounceTable& bounces, double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (!geometry::has_exact_touches<S>)
          throw not_exact<S>();
        else
          return std::make_unique<ManyBalls>(moving_wall_of(shape, chamber), balls, rules, bounces,
                                             start);
      },
      *chamber.shape);
}

}  // namespace mahlwerk::event
