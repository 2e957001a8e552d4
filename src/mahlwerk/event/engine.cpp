// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engine.hpp"

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/event/engines.hpp"
#include "mahlwerk/event/many_balls.hpp"

namespace mahlwerk::event {
namespace {

/// Exact times of touch need a formula.
template <class S>
constexpr bool is_mesh = std::is_same_v<S, geometry::Mesh>;

InputError no_mesh() {
  return InputError(
      Fault{"jar", "the event engine takes no mesh", "write engine = \"soft\"", "mesh-needs-soft"});
}

}  // namespace

std::unique_ptr<scene::Engine> one_ball(const scene::Chamber& chamber, const scene::Ball& ball,
                                        const Rules& rules, double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (is_mesh<S>)
          throw no_mesh();
        else if constexpr (S::faces > 0)
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
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (is_mesh<S>)
          throw no_mesh();
        else
          return std::make_unique<ManyBalls>(enclosure_of(shape, chamber), balls, rules, bounces,
                                             start);
      },
      chamber.shape);
}

}  // namespace mahlwerk::event
