// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Error of a collision by the time step: every law, e from 0.1 to 1, from sticking to gross slip,
// compared with the same collision in a thousand steps.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

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
constexpr int phases = 8;  // of the touch within a step

scene::Ball steel(double along, double towards) {
  return {0.005, 7850, {}, {along, 0, -towards}, {}};
}

/// A pair of laws and the restitution, with what all laws need.
contact::Pair pair_with(double e, double mu, double nu = 0.3) {
  contact::Pair pair = pair_of({210e9, nu}, {210e9, nu}, e, mu);
  pair.surface_energy = 0.05;  // for laws with adhesion
  pair.cohesion = 1e6;
  pair.surface_tension = 0.07;
  pair.hardness = 2e9;  // yields at 0.06 m/s, for laws with yield
  return pair;
}

/// Time step over contact time, as the engine chooses it: `steps` in a collision, a fifth of the
/// time in which a damper stops a ball.
double chosen_share(const contact::AnyLaw& law, const contact::Pair& pair, double steps) {
  const soft::TimeSteps times =
      soft::time_steps({steel(0, 1)}, law, contact::PairTable(1, 6, pair), 1);
  return std::min(1 / steps, times.dashpot / 5 / times.contact);
}

/// Largest errors over slopes, in steps of `share` of the contact time.
soft::StepError largest_error(const contact::AnyLaw& law, const contact::Pair& pair, double share) {
  soft::StepError worst;
  const auto raise = [](double& most, double off) { most = max_or_nan(most, std::abs(off)); };
  for (const double slope : slopes) {
    const scene::Ball ball = steel(slope * pair.friction, 1);
    const double vt = ball.velocity.x;
    const double rolls =
        std::min(5.0 / 7 * vt, 2.5 * pair.friction * (1 + pair.restitution)) / ball.radius;
    const scene::Ball exact = impact({ball}, pair, of_law(law), 1e-3).after[0];
    double rebound = 0, tangential = 0, spin = 0;
    for (int k = 0; k < phases; ++k) {
      const scene::Ball found =
          impact({ball}, pair, of_law(law), share, (k + 0.5) / phases).after[0];
      const double off[] = {(found.velocity.z - exact.velocity.z) / std::max(exact.velocity.z, 0.1),
                            (found.velocity.x - exact.velocity.x) / vt,
                            (found.spin.y - exact.spin.y) / rolls};
      rebound += off[0] / phases, tangential += off[1] / phases, spin += off[2] / phases;
      for (const double one : off) raise(worst.single, one);
    }
    raise(worst.rebound, rebound), raise(worst.tangential, tangential), raise(worst.spin, spin);
  }
  return worst;
}

std::string row_of(const soft::StepError& error) {
  return fmt::format(
      "rebound {:5.2f} %, speed across {:5.2f} %, spin {:5.2f} %; a single one {:5.2f} %",
      100 * error.rebound, 100 * error.tangential, 100 * error.spin, 100 * error.single);
}

/// What is told of a step holds.
void expect_told(const soft::StepError& found, const soft::StepError& told,
                 const std::string& what) {
  std::printf("    %-36s %s\n", what.c_str(), row_of(found).c_str());
  EXPECT_LE(found.rebound, told.rebound) << what;
  EXPECT_LE(found.tangential, told.tangential) << what;
  EXPECT_LE(found.spin, told.spin) << what;
  EXPECT_LE(found.single, told.single) << what;
}

TEST(TimeStep, chosen_by_an_error_leaves_no_larger_one_and_says_how_large) {
  for (contact::AnyLaw law : contact::all_laws()) {
    // A slow rebound must pass the bridge within the time that impact() simulates.
    if (auto* wet = std::get_if<contact::Capillary>(&law)) wet->bridge_ratio = 1e-7;
    for (const double e : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0})
      for (const double error : {0.005, 0.01}) {
        const contact::Pair pair = pair_with(e, 0.4);
        const double share = chosen_share(law, pair, soft::steps_per_collision(law, e, error));
        const soft::StepError found = largest_error(law, pair, share),
                              told = soft::step_error(law, e, 1 / share);
        const std::string what =
            fmt::format("{}, e {}, {:.0f} steps", contact::name_of(law), e, 1 / share);
        expect_told(found, told, what);
        EXPECT_LE(found.largest_mean(), error) << what;
        if (e < 0.1) continue;
        EXPECT_LE(told.largest_mean(), 0.005 + 2 * found.largest_mean())
            << what << ": told far more than there is";
      }
  }
}

TEST(TimeStep, what_is_told_of_it_holds_for_any_poisson_ratio) {
  for (const contact::AnyLaw& law : std::vector<contact::AnyLaw>{HertzMindlin{}, HertzTsuji{}})
    for (const double e : {0.2, 0.6, 0.7, 0.8, 0.95})
      for (const double nu : {0.0, 0.2, 0.25, 0.45}) {
        const contact::Pair pair = pair_with(e, 0.4, nu);
        const double share = chosen_share(law, pair, soft::steps_per_collision(law, e, 0.005));
        expect_told(largest_error(law, pair, share), soft::step_error(law, e, 1 / share),
                    fmt::format("{}, e {}, nu {}", contact::name_of(law), e, nu));
      }
}

TEST(TimeStep, errors_of_single_collisions_fall_with_it_and_undamped_with_its_square) {
  for (const double e : {0.3, 0.6, 0.9, 1.0}) {
    const contact::Pair pair = pair_with(e, 0.3);
    const double share = chosen_share(HertzTsuji{}, pair, 50);
    const soft::StepError first = largest_error(HertzTsuji{}, pair, share);
    const soft::StepError last = largest_error(HertzTsuji{}, pair, share / 8);
    std::printf("    e %.1f: %s\n     an eighth: %s\n", e, row_of(first).c_str(),
                row_of(last).c_str());
    // Friction lets go between two steps, an error of order 1 with damping. Without damping the
    // ratio is 1/64. The phase within a step is random, which may hide a factor of 2.
    stays_below(fmt::format("e {}: an eighth of the step, largest error", e),
                last.single / first.single, e < 1 ? 1.0 / 8 : 1.0 / 32,
                e < 1 ? "order 1" : "order 2");
  }
}

/// A ball that lies on a floor and swings on its tangential spring, without loss.
TEST(TimeStep, tangential_spring_keeps_its_frequency_and_its_swing) {
  constexpr double swing = 1e-9, push = 1e4;         // [m/s], [m/s2]: friction never slides
  for (const double phase : {0.1, 0.2, 0.4, 0.6}) {  // w dt
    const contact::Pair pair = pair_with(1, 10);
    scene::Ball ball = steel(swing, 0);
    const contact::EffectivePair t = touching(pair, ball);
    const contact::LawCoefficients k = contact::LinearSpring{}.coefficients(t, 0);
    const double depth = t.mass * push / k[0];
    const double lever = 1 - depth / ball.radius;
    const double w = std::sqrt((1 + 2.5 * lever * lever) * k[2] / t.mass);
    constexpr double side = 1;
    ball.position.z = -0.5 * side + ball.radius - depth;
    const double step = phase / w;
    const auto engine = soft_engine(still_box(side, {0, 0, -push}), {ball},
                                    of_law(contact::LinearSpring{}), pair, step);
    Recorder none;
    // The slip is a cosine: its phase and size in the first fifty turns and in the next fifty.
    std::complex<double> halves[2];
    const int half = static_cast<int>(50 * 2 * std::numbers::pi / phase);
    for (int n = 1; n <= 2 * half; ++n) {
      engine->advance((n - 0.5) * step, none);
      const scene::Ball b = engine->balls()[0];
      halves[n > half] += (b.velocity.x - b.radius * b.spin.y) * std::polar(1.0, -n * phase);
    }
    const std::complex<double> ratio = halves[1] / halves[0];
    const std::string what = fmt::format(" in 50 turns at w dt = {}", phase);
    states("growth of the swing" + what, std::abs(ratio), 1, 5e-3,
           "a spring without loss (dem.37)");
    states("change of the phase [rad]" + what, std::arg(ratio), 0, 0.02, "frequency w (dem.37)");
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
