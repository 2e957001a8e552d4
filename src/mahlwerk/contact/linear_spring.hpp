// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::contact {

/// A linear spring as stiff as the law was told, or one that stores as much energy as Hertz's at
/// the same overlap when bodies meet at a characteristic speed (dem.11) [N/m].
inline double spring_stiffness(const LawChoice& choice, const Touching& t) {
  if (choice.stiffness > 0) return choice.stiffness;
  const double d = hertz_overlap(t, choice.stiffness_speed);
  return 0.8 * hertz_stiffness(t) * std::sqrt(d);  // k d^2 / 2 = (2/5) k_Hertz d^2.5
}
/// Across the normal, so that both motions of a collision have one period (dem.12).
constexpr double spring_across = 2.0 / 7.0;

/// What laws with a linear spring have in common.
class Spring {
 public:
  static constexpr bool remembers = false;
  explicit Spring(const LawChoice& choice) : choice_(choice) {}

  double stiffness(const Touching& t) const { return spring_stiffness(choice_, t); }
  template <class V>
  [[gnu::always_inline]] static V abrupt(const V*) {
    return V{};
  }
  double reach(const Touching&) const { return 0; }
  double secant(const Touching&) const { return 1 / spring_across; }
  double largest_overlap(const Touching& t, double speed) const {
    return speed * std::sqrt(t.mass / stiffness(t));
  }
  double damper_time(const Touching&, double, double) const { return unbounded_time; }

 private:
  LawChoice choice_;
};

/// Linear spring and dashpot along and across the normal (Cundall and Strack 1979). The contact
/// ends when the overlap does; shortly before it the force pulls, which makes e exact.
struct LinearSpring : Spring {
  static constexpr LawName name = LawName::linear_spring;
  using Spring::Spring;

  double damping(double e) const { return -2 * damping_ratio(e); }
  LawNumbers numbers(const Touching& t, double damping) const {
    const double k = stiffness(t), c = damping * std::sqrt(t.mass * k);
    return {k, c, spring_across * k, spring_across * c};
  }
  void begin(const LawNumbers&, double*, double) const {}

  template <class V>
  [[gnu::always_inline]] static Push<V> push(const V* k, V*, V overlap, V rate) {
    const V force = k[0] * overlap + k[1] * rate;
    return {force, k[2], k[3], force};
  }

  double stored(const LawNumbers& k, const double*, double overlap) const {
    return overlap > 0 ? 0.5 * k[0] * overlap * overlap : 0;
  }
  double shortest_time(const Touching& t, double) const {
    return std::numbers::pi * std::sqrt(t.mass / stiffness(t));
  }
};

}  // namespace mahlwerk::contact
