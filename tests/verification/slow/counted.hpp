// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <stdexcept>
#include <variant>
#include <vector>

#include "mahlwerk/event/engines_impl.hpp"
#include "mahlwerk/event/many_balls.hpp"

namespace mahlwerk::tests {

struct Hang final : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Any motion, that counts how often it is asked where the jar is: every look of the search asks,
/// so a run that hangs is found out.
struct Counted {
  kinematics::AnyMotion motion;
  std::shared_ptr<std::int64_t> left = std::make_shared<std::int64_t>(1'000'000);

  static constexpr std::string_view name = "counted", about = "any motion, counted";
  static constexpr Vec3 jar_axis = kinematics::upright;

  template <class Question>
  auto ask(Question question) const {
    return std::visit(question, motion);
  }
  kinematics::Ride ride(double t) const {
    if (--*left < 0) throw Hang("too many looks");
    return ask([t](const auto& m) { return m.ride(t); });
  }
  Rotation turn(double t) const {
    return ask([t](const auto& m) -> Rotation { return m.turn(t); });
  }
  Vec3 spin(double t) const {
    return ask([t](const auto& m) -> Vec3 { return m.spin(t); });
  }
  Vec3 spin_rate(double t) const {
    return ask([t](const auto& m) -> Vec3 { return m.spin_rate(t); });
  }
  kinematics::Bounds bounds() const {
    return ask([](const auto& m) { return m.bounds(); });
  }
  double period() const {
    return ask([](const auto& m) { return m.period(); });
  }
  Vec3 fixed_axis() const {
    return ask([](const auto& m) -> Vec3 { return m.fixed_axis(); });
  }
};

/// An engine in `chamber` whose motion is counted: for one ball, or for any number.
inline std::unique_ptr<scene::Engine> counted_engine(const scene::Chamber& chamber,
                                                     const Counted& motion,
                                                     const std::vector<scene::Ball>& balls,
                                                     const event::Rules& rules, bool one_ball,
                                                     double start) {
  return std::visit(
      [&]<class S>(const S& shape) -> std::unique_ptr<scene::Engine> {
        if constexpr (!geometry::has_exact_touches<S>) {
          return nullptr;  // the event engine does not take it
        } else {
          const event::Jar<S, Counted> jar(shape, motion, chamber);
          if constexpr (S::faces > 0)
            if (one_ball)
              return std::make_unique<event::OneBall<S, Counted>>(jar, balls.front(), rules, start);
          return std::make_unique<event::ManyBalls>(
              std::make_unique<event::Enclosed<S, Counted>>(jar), balls, rules,
              contact::BounceTable(1, S::faces, rules.bounce), start);
        }
      },
      chamber.shape);
}

}  // namespace mahlwerk::tests
