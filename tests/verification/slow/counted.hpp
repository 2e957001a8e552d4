// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <variant>
#include <vector>

#include "mahlwerk/event/engines_impl.hpp"
#include "mahlwerk/event/many_balls.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::tests {

struct Hang final : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Any motion, with a limit on the number of evaluations of its frame motion. Every safe-time query
/// of the search evaluates it, so a run that hangs is detected.
struct Counted : kinematics::ChosenMotion {
  using ChosenMotion::ChosenMotion;
  std::shared_ptr<std::int64_t> left = std::make_shared<std::int64_t>(1'000'000);

  kinematics::FrameMotion frame_motion(double t) const {
    if (--*left < 0) throw Hang("too many looks");
    return ChosenMotion::frame_motion(t);
  }
};

/// An engine in `chamber` with the counted motion: for one ball, or for any number of balls.
inline std::unique_ptr<scene::Engine> counted_engine(const scene::Chamber& chamber,
                                                     const Counted& motion,
                                                     const std::vector<scene::Ball>& balls,
                                                     const event::Rules& rules, bool one_ball,
                                                     double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (!geometry::has_exact_touches<S>) {
          return nullptr;  // not supported by the event engine
        } else {
          const event::TypedChamber<S, Counted> jar(shape, motion, chamber);
          if constexpr (S::faces > 0)
            if (one_ball)
              return std::make_unique<event::OneBall<S, Counted>>(jar, balls.front(), rules, start);
          return std::make_unique<event::ManyBalls>(
              std::make_unique<event::ChamberWall<S, Counted>>(jar), balls, rules,
              contact::BounceTable(1, S::faces, rules.bounce), start);
        }
      },
      *chamber.shape);
}

}  // namespace mahlwerk::tests
