// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Error of a collision at the default time step: every law, e from 0.1 to 1, from sticking to gross
// slip, compared with the same collision in steps forty times shorter.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/kernel/contact_transitions.hpp"
#include "mahlwerk/soft/step_error.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::step_test {
namespace {

using contact::HertzMindlin;
using contact::HertzTsuji;

/// v_t/(mu v_n) from sticking to gross slip, which begins at 7 for e = 1.
constexpr std::array slopes{0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.5, 3.5, 4.0, 5.0, 7.0, 12.0};
constexpr std::array phases{0.06, 0.31, 0.56, 0.81};  // of the touch within a step

scene::Ball steel(double along, double towards) {
  return {0.005, 7850, {}, {along, 0, -towards}, {}};
}

/// Time step over contact time, as the engine chooses it: a fiftieth of a collision, a fifth of the
/// time in which a damper stops a ball.
double usual_share(const contact::AnyLaw& law, const contact::Pair& pair, const scene::Ball& ball) {
  const soft::TimeSteps steps =
      soft::time_steps({ball}, law, contact::PairTable(1, 6, pair), -ball.velocity.z);
  return std::min(1.0 / 50, steps.dashpot / 5 / steps.contact);
}

/// Largest error over slopes and phases, with `shorter` times as many steps as usual. `nu` is
/// Poisson's ratio.
soft::StepError largest_error(const contact::AnyLaw& law, double e, double mu, double shorter = 1,
                              double nu = 0.3) {
  soft::StepError worst;
  for (const double slope : slopes) {
    contact::Pair pair = pair_of({210e9, nu}, {210e9, nu}, e, mu);
    pair.surface_energy = 0.05;  // for laws with adhesion
    pair.cohesion = 1e6;
    pair.surface_tension = 0.07;
    pair.hardness = 2e9;  // yields at 0.06 m/s, for laws with yield
    const scene::Ball ball = steel(slope * mu, 1);
    const double share = usual_share(law, pair, ball), vt = ball.velocity.x;
    const double rolls = std::min(5.0 / 7 * vt, 2.5 * mu * (1 + e)) / ball.radius;
    const scene::Ball exact = impact({ball}, pair, of_law(law), share / 40).after[0];
    for (const double phase : phases) {
      const scene::Ball found = impact({ball}, pair, of_law(law), share / shorter, phase).after[0];
      const auto raise = [](double& most, double off) { most = max_or_nan(most, std::abs(off)); };
      raise(worst.rebound, found.velocity.z / exact.velocity.z - 1);
      raise(worst.tangential, (found.velocity.x - exact.velocity.x) / vt);
      raise(worst.spin, (found.spin.y - exact.spin.y) / rolls);
    }
  }
  return worst;
}

std::string row_of(const soft::StepError& error) {
  return fmt::format("rebound {:5.2f} %, speed across {:5.2f} %, spin {:5.2f} %",
                     100 * error.rebound, 100 * error.tangential, 100 * error.spin);
}

TEST(TimeStep, usual_leaves_every_collision_off_by_a_hundredth_at_most_and_says_by_how_much) {
  for (contact::AnyLaw law : contact::all_laws()) {
    // A slow rebound must pass the bridge within the time that impact() simulates.
    if (auto* wet = std::get_if<contact::Capillary>(&law)) wet->bridge_ratio = 1e-7;
    for (const double e : {0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0}) {
      const soft::StepError found = largest_error(law, e, 0.4);
      const contact::Pair pair = pair_of({210e9, 0.3}, {210e9, 0.3}, e, 0.4);
      const double share = usual_share(law, pair, steel(1, 1));
      const soft::StepError told = soft::step_error(law, e, 1 / share);
      const std::string what = fmt::format("{}, e {}", contact::name_of(law), e);
      std::printf("    %-20s %s\n", what.c_str(), row_of(found).c_str());
      for (const auto& [off, said] :
           {std::pair(found.rebound, told.rebound), std::pair(found.tangential, told.tangential),
            std::pair(found.spin, told.spin)}) {
        EXPECT_LE(off, 0.01) << what;
        EXPECT_LE(off, said) << what << ": more than is told";
      }
      EXPECT_LE(told.rebound + told.spin, 0.01 + 2 * (found.rebound + found.spin))
          << what << ": told far more than there is";
    }
  }
}

TEST(TimeStep, what_is_told_of_the_usual_one_holds_for_any_poisson_ratio) {
  for (const contact::AnyLaw& law : std::vector<contact::AnyLaw>{HertzMindlin{}, HertzTsuji{}})
    for (const double e : {0.2, 0.7, 0.8})
      for (const double nu : {0.0, 0.2, 0.25, 0.45}) {
        const soft::StepError found = largest_error(law, e, 0.4, 1, nu);
        const contact::Pair pair = pair_of({210e9, nu}, {210e9, nu}, e, 0.4);
        const soft::StepError told =
            soft::step_error(law, e, 1 / usual_share(law, pair, steel(1, 1)));
        const std::string what = fmt::format("{}, e {}, nu {}", contact::name_of(law), e, nu);
        std::printf("    %-28s %s\n", what.c_str(), row_of(found).c_str());
        EXPECT_LE(found.rebound, told.rebound) << what;
        EXPECT_LE(found.tangential, told.tangential) << what;
        EXPECT_LE(found.spin, told.spin) << what;
      }
}

TEST(TimeStep, errors_fall_with_it_and_undamped_with_its_square) {
  for (const double e : {0.3, 0.6, 0.9, 1.0}) {
    const soft::StepError first = largest_error(HertzTsuji{}, e, 0.3);
    const soft::StepError last = largest_error(HertzTsuji{}, e, 0.3, 8);
    std::printf("    e %.1f: %s\n     an eighth: %s\n", e, row_of(first).c_str(),
                row_of(last).c_str());
    // Friction lets go between two steps, an error of order 1 with damping. Without damping the
    // ratio is 1/64. The phase within a step is random, which may hide a factor of 2.
    stays_below(fmt::format("e {}: an eighth of the step, error across", e),
                last.tangential / first.tangential, e < 1 ? 1.0 / 8 : 1.0 / 32,
                e < 1 ? "order 1" : "order 2");
  }
}

/// Zeta(-1/4, 1 + x) by the Euler-Maclaurin sum.
double hurwitz(double x) {
  constexpr int terms = 30;
  double sum = 0;
  for (int k = 1; k < terms; ++k) sum += std::pow(x + k, 0.25);
  const double end = x + terms;
  return sum - 0.8 * std::pow(end, 1.25) + 0.5 * std::pow(end, 0.25) +
         0.25 / 12 * std::pow(end, -0.75) - 0.25 * 0.75 * 1.75 / 720 * std::pow(end, -2.75);
}

TEST(TimeStep, the_first_push_counts_as_the_sum_of_euler_and_maclaurin_says) {
  for (int i = 0; i <= 10; ++i) {
    const double since = 0.1 * i;
    states(fmt::format("since {:.1f}", since), soft::fourth_root_weight(Register<2>{} + since)[0],
           -hurwitz(since), 1.2e-4, "-zeta(-1/4, 1 + x)");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::step_test
