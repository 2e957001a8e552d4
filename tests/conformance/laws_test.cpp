// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every contact law in the register meets the requirements of contact/law.hpp: head-on collisions
// of two bodies, integrated without any engine.
#include "mahlwerk/contact/laws.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "register_types.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::laws_test {
namespace {

using contact::EffectivePair;
using contact::LawCoefficients;

/// Steps of one shortest_time. Over a step without history RK4 is Simpson's rule. Over the first
/// step its error is 0.073 c h^(5/4) of the impulse of a damper c x^(1/4), the least smooth force
/// near touch. In units of a collision, x'' = -x^1.5 - c x^(1/4) x', the duration is 3, h is 3/4000
/// and c is at most 2 for e >= 0.05: the error is 1.8e-5 of the impact speed, and no more over all
/// later steps.
constexpr int steps_per_collision = 4000;
constexpr double integration = 4e-5;
/// The laws that solve for their damping (contact/damping.cpp) use steps of 2e-3: 6e-5 by the same
/// estimate.
constexpr double solving = 6e-5;

enum class Adhesion { none, some };

EffectivePair bodies(double restitution, Adhesion adhesion) {
  contact::Pair pair;
  pair.modulus = 1e8;
  pair.shear_modulus = 3e7;
  pair.restitution = restitution;
  if (adhesion == Adhesion::some) {
    pair.surface_energy = 0.5;
    pair.cohesion = 2e5;
    pair.surface_tension = 0.07;
  }
  return {pair, 0.005, 0.002};
}

/// A head-on collision of two bodies under a contact law, from touch on.
template <class L>
class HeadOn {
 public:
  struct State {
    double overlap, rate;
  };
  struct ProgramResult {
    double rebound = 0;  ///< [m/s]
    double duration = 0, deepest = 0;
    double unloading = 0;   ///< [s] from the deepest overlap until the spring force vanishes
    bool parted = false;    ///< false: the bodies stick
    double dissipated = 0;  ///< [J] by damper, plastic deformation and separation (dem.39)
  };

  HeadOn(const L& law, const EffectivePair& t, double speed)
      : law_(law),
        t_(t),
        speed_(speed),
        reach_(law.pull_off_distance(t)),
        step_(law.shortest_time(t, speed) / steps_per_collision),
        k_(law.coefficients(t, law.damping(t.pair.restitution))) {
    law.begin(k_, memory_, speed);
  }

  /// Integrates for at most `most` times shortest_time. Bodies that are still in contact then
  /// stick.
  ProgramResult run(int most) {
    ProgramResult e;
    State now{0, speed_};
    for (int i = 0; i < most * steps_per_collision; ++i) {
      const State next = after(now, step_);
      if (next.rate < 0 && next.overlap <= -reach_) {
        e.dissipated += plastic() + law_.elastic_energy(k_, memory_, -reach_);
        return parted(now, e);
      }
      const double power = damper_power(now);
      now = next;
      push(memory_, now);
      e.dissipated += 0.5 * step_ * (power + damper_power(now));
      e.duration += step_;
      if (now.rate < 0 && spring(now) > 0) e.unloading += step_;
      e.deepest = max_or_nan(e.deepest, now.overlap);
    }
    return e;
  }

 private:
  double push(double* memory, const State& s) const {
    return L::template evaluate<double>(k_.data(), memory, std::max(s.overlap, -reach_), s.rate)
        .force;
  }
  double damper_power(const State& s) const {
    double memory[contact::law_history_size];
    std::ranges::copy(memory_, memory);
    return s.rate *
           L::template evaluate<double>(k_.data(), memory, std::max(s.overlap, -reach_), s.rate)
               .damper;
  }
  double plastic() const {
    if constexpr (requires { L::plastic_energy(k_.data(), memory_); })
      return L::plastic_energy(k_.data(), memory_);
    else
      return 0;
  }
  double spring(const State& s) const {
    double memory[contact::law_history_size];
    std::ranges::copy(memory_, memory);
    return push(memory, {s.overlap, 0});
  }
  /// One Runge-Kutta step. The history variables change with whole steps only.
  State after(const State& s, double h) const {
    const auto slope = [&](const State& at) {
      double memory[contact::law_history_size];
      std::ranges::copy(memory_, memory);
      return State{at.rate, -push(memory, at) / t_.mass};
    };
    const auto ahead = [](const State& from, double by, const State& d) {
      return State{from.overlap + by * d.overlap, from.rate + by * d.rate};
    };
    const State a = slope(s), b = slope(ahead(s, h / 2, a)), c = slope(ahead(s, h / 2, b)),
                d = slope(ahead(s, h, c));
    return {s.overlap + h / 6 * (a.overlap + 2 * b.overlap + 2 * c.overlap + d.overlap),
            s.rate + h / 6 * (a.rate + 2 * b.rate + 2 * c.rate + d.rate)};
  }
  /// Finds the fraction of the last step at which the contact ends, by bisection.
  ProgramResult parted(const State& now, ProgramResult e) const {
    double low = 0, high = step_;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (after(now, middle).overlap > -reach_ ? low : high) = middle;
    }
    e.rebound = -after(now, low).rate;
    e.duration += low;
    e.parted = true;
    return e;
  }

  L law_;
  EffectivePair t_;
  double speed_, reach_, step_;
  LawCoefficients k_;
  double memory_[contact::law_history_size] = {};
};

constexpr std::array restitutions{0.05, 0.3, 0.5, 0.9, 1.0};
constexpr std::array speeds{0.01, 1.0, 10.0};

template <class L>
class Laws : public ::testing::Test {
 protected:
  const L law{};

  /// Calls `look` for every collision with its bodies, its speed and its result.
  template <class Look>
  void collide(Adhesion adhesion, const Look& look) const {
    if (adhesion == Adhesion::some && contact::adhesion_of<L>().empty()) return;
    // At e = 0.05 walton-braun takes 130 times the shortest_time of the stiffest branch to unload.
    const int most = adhesion == Adhesion::some ? 20 : 200;
    for (const double e : restitutions)
      for (const double speed : speeds) {
        const EffectivePair t = bodies(e, adhesion);
        look(t, speed, HeadOn<L>(law, t, speed).run(most));
      }
  }
  std::string named(const char* what) const { return fmt::format("{}: {}", L::name, what); }
};
TYPED_TEST_SUITE(Laws, TypesOf<contact::AnyLaw::Models>::type, NameOfModel);

TYPED_TEST(Laws, restitution_is_the_one_asked_for_at_every_speed) {
  double worst = 0;
  this->collide(Adhesion::none, [&](const EffectivePair& t, double speed, const auto& end) {
    EXPECT_TRUE(end.parted);
    worst = max_or_nan(worst, std::abs(end.rebound / speed - t.pair.restitution));
  });
  stays_below(this->named("restitution off by"), worst, integration + solving, "e asked");
}

TYPED_TEST(Laws, collisions_make_no_energy) {
  double most = 0;
  for (const Adhesion adhesion : {Adhesion::none, Adhesion::some})
    this->collide(adhesion, [&](const EffectivePair&, double speed, const auto& end) {
      most = max_or_nan(most, end.rebound / speed);
    });
  stays_below(this->named("speed after over speed before"), most, 1 + integration,
              "conservation of energy");
}

/// What damper, plastic loop and separation dissipate is what the collision loses; with e = 1 and
/// without adhesion it is exactly 0.
TYPED_TEST(Laws, dissipate_what_a_collision_loses) {
  double worst = 0, elastic = 0;
  for (const Adhesion adhesion : {Adhesion::none, Adhesion::some})
    this->collide(adhesion, [&](const EffectivePair& t, double speed, const auto& end) {
      if (!end.parted) return;
      const double before = 0.5 * t.mass * speed * speed,
                   taken = before - 0.5 * t.mass * end.rebound * end.rebound;
      worst = max_or_nan(worst, std::abs(end.dissipated - taken) / before);
      if (t.pair.restitution == 1 && adhesion == Adhesion::none)
        elastic = max_or_nan(elastic, std::abs(end.dissipated) / before);
    });
  // The trapezoidal rule and the bound of the rebound: twice the error of the speed, and the power
  // of the damper in the first and the last step, h^(5/4) of the whole.
  stays_below(this->named("dissipated less the energy taken, relative"), worst,
              4 * integration + std::pow(1.0 / steps_per_collision, 1.25) * 10, "energy");
  stays_below(this->named("dissipated at e = 1, relative"), elastic, 2 * solving, "no damper");
}

TYPED_TEST(Laws, shortest_time_is_no_longer_than_any_collision) {
  double longest = 0;
  for (const Adhesion adhesion : {Adhesion::none, Adhesion::some})
    this->collide(adhesion, [&](const EffectivePair& t, double speed, const auto& end) {
      longest = max_or_nan(longest, this->law.shortest_time(t, speed) / end.duration);
    });
  stays_below(this->named("shortest_time over duration"), longest, 1 + integration, "law.hpp");
}

/// Unloading is the fastest part of a collision if loading and unloading differ.
TYPED_TEST(Laws, shortest_time_is_no_longer_than_twice_the_unloading) {
  double longest = 0;
  this->collide(Adhesion::none, [&](const EffectivePair& t, double speed, const auto& end) {
    longest = max_or_nan(longest, this->law.shortest_time(t, speed) / (2 * end.unloading));
  });
  // Both ends of the unloading are known to one step of the integration, which is 1/4000 of
  // shortest_time.
  stays_below(this->named("shortest_time over twice the unloading"), longest,
              1 + 4.0 / steps_per_collision, "law.hpp");
}

TYPED_TEST(Laws, largest_overlap_is_no_less_than_that_of_any_collision) {
  double deepest = 0;
  for (const Adhesion adhesion : {Adhesion::none, Adhesion::some})
    this->collide(adhesion, [&](const EffectivePair& t, double speed, const auto& end) {
      deepest = max_or_nan(deepest, end.deepest / this->law.largest_overlap(t, speed));
    });
  stays_below(this->named("overlap over largest_overlap"), deepest, 1 + integration, "law.hpp");
}

/// Contact forces at an overlap that is reached by slow loading.
template <class L>
class Loaded {
 public:
  Loaded(const L& law, const EffectivePair& t, double speed)
      : k_(law.coefficients(t, law.damping(t.pair.restitution))) {
    law.begin(k_, memory_, speed);
  }
  contact::LawForce<double> at(double overlap, double rate = 0) {
    return L::template evaluate<double>(k_.data(), memory_, overlap, rate);
  }
  double stored(const L& law, double overlap) const {
    return law.elastic_energy(k_, memory_, overlap);
  }

 private:
  LawCoefficients k_;
  double memory_[contact::law_history_size] = {};
};

/// Normal and tangential damping coefficients [N s/m], and spring stiffness [N/m].
struct Slopes {
  double along, across, spring;
};
template <class L>
Slopes slopes(Loaded<L>& contact, double overlap, double speed) {
  // At a small rate the force of a loaded contact stays above 0 for laws that never pull.
  const double rate = 1e-6 * speed, step = 1e-6 * overlap;
  const double below = contact.at(overlap - step).force, here = contact.at(overlap).force;
  return {(contact.at(overlap, rate).force - here) / rate, contact.at(overlap, rate).damping,
          (here - below) / step};
}

/// If damper_time is finite, the damper alone stops the bodies in no shorter time, normally or
/// tangentially (2/7 of the mass). If it is infinite, the damper is at most critical:
/// c^2 <= 4 m dF/dx.
TYPED_TEST(Laws, damper_time_is_no_longer_than_the_damper_takes_alone) {
  double quickest = 0, damped = 0;
  for (const double e : {0.01, 0.05, 0.3, 0.5, 0.9, 1.0})
    for (const double speed : speeds) {
      const EffectivePair t = bodies(e, Adhesion::none);
      const double told = this->law.damper_time(t, this->law.damping(e), speed);
      const double deepest = this->law.largest_overlap(t, speed);
      Loaded<TypeParam> contact(this->law, t, speed);
      for (int i = 1; i <= 100; ++i) {
        const Slopes s = slopes(contact, 0.01 * i * deepest, speed);
        if (std::isinf(told))
          damped = max_or_nan(damped, s.along * s.along / (4 * t.mass * s.spring));
        else
          quickest =
              std::max({quickest, told * s.along / t.mass, told * s.across / (2.0 / 7.0 * t.mass)});
      }
    }
  // Rates and overlaps differ by 1e-6: slopes have an error of 1e-6, and of 1e-16/1e-6 by rounding.
  stays_below(this->named("damper_time over that of the damper"), quickest, 1 + 1e-5, "law.hpp");
  stays_below(this->named("damper over a critical one, squared"), damped, 1 + 1e-5, "law.hpp");
}

TYPED_TEST(Laws, stored_energy_is_the_work_the_force_gives_back) {
  constexpr int parts = 20'000;
  for (const Adhesion adhesion : {Adhesion::none, Adhesion::some})
    for (const double e : {0.3, 1.0}) {
      if (adhesion == Adhesion::some && contact::adhesion_of<TypeParam>().empty()) continue;
      const EffectivePair t = bodies(e, adhesion);
      const double deepest = this->law.largest_overlap(t, 1);
      Loaded<TypeParam> contact(this->law, t, 1);
      contact.at(deepest);
      double work = 0;
      for (int i = parts; i-- > 0;)
        work += contact.at(deepest * (i + 0.5) / parts).force * deepest / parts;
      const double stored = contact.stored(this->law, deepest) - contact.stored(this->law, 0);
      // The midpoint rule has an error of h^2 (F'(end) - F'(0))/24, 4e-10 of Hertz's work, and at
      // the end of walton-braun's unloading branch of h^2 F'/8, which at e = 0.3 is 8e-9 of its
      // work.
      states(fmt::format("{}, e {}{}: stored over work", TypeParam::name, e,
                         adhesion == Adhesion::some ? ", adhesion" : ""),
             stored / work, 1, 1e-7, "integral of F");
    }
}

TYPED_TEST(Laws, secant_is_the_stiffness_along_over_that_across) {
  const EffectivePair t = bodies(1, Adhesion::none);
  Loaded<TypeParam> contact(this->law, t, 1);
  for (const double share : {0.1, 0.5, 1.0}) {
    const double overlap = share * this->law.largest_overlap(t, 1);
    const auto push = contact.at(overlap);
    // JKR's law solves for the contact radius to about 1e-9.
    states(this->named("secant of the spring"), push.force / overlap / push.stiffness,
           this->law.stiffness_ratio(t), 1e-8 * this->law.stiffness_ratio(t), "law.hpp");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::laws_test
