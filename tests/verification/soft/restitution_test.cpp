// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A collision has the requested restitution, for every contact law and at every speed.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/soft/step_error.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::restitution_test {
namespace {

using contact::AdamsImpact;
using contact::HertzMindlin;
using contact::HertzTsuji;
using contact::Jkr;
using contact::LinearSpring;
using contact::WaltonBraun;

const scene::Ball steel_ball{0.0075, 7700, {}, {}, {}};
constexpr contact::ElasticConstants steel{200e9, 0.265};

/// Largest error over restitutions, speeds and phases of the touch within a step.
double worst_restitution(const contact::AnyLaw& law, double share) {
  double worst = 0;
  for (const double e : {0.1, 0.2, 0.35, 0.5, 0.7, 0.8, 0.9, 0.95})
    for (const double speed : {0.1, 5.0})
      for (const double phase : {0.0, 0.4, 0.8}) {
        scene::Ball ball = steel_ball;
        ball.velocity = {0, 0, -speed};
        const Impact found = impact({ball}, pair_of(steel, rigid, e), of_law(law), share, phase);
        worst = max_or_nan(worst, std::abs(found.restitution - e));
      }
  return worst;
}

TEST(Restitution, found_is_the_one_asked_for) {
  for (const contact::AnyLaw& law : contact::all_laws()) {
    // The force of these laws jumps at touch, or grows within a hundredth of the overlap.
    const bool jumps =
        std::holds_alternative<LinearSpring>(law) || std::holds_alternative<AdamsImpact>(law);
    stays_below("e of " + std::string(contact::name_of(law)) + ", off by" +
                    (jumps ? " (t_c/1000)" : " (t_c/200)"),
                worst_restitution(law, jumps ? 1e-3 : 5e-3), 1e-3,
                "e asked, 0.1 to 0.95, at 0.1 and 5 m/s");
  }
}

/// Two balls of Mhadhbi 2021, requested e = 0.35. The error of the paper's damper depends on its
/// damping depth.
TEST(AdamsImpact, with_the_damping_as_published_misses_e_as_it_must) {
  const double depths[] = {1e-6, 1e-5, 1e-4}, speeds[] = {0.5, 1, 5};
  const double expected[3][3] = {
      {0.403, 0.695, 0.993}, {0.395, 0.526, 0.980}, {0.388, 0.413, 0.825}};
  for (int v = 0; v < 3; ++v)
    for (int d = 0; d < 3; ++d) {
      AdamsImpact published;
      published.published_damping = true;
      published.damping_depth = depths[d];
      std::vector<scene::Ball> balls{steel_ball, steel_ball};
      balls[0].velocity = {speeds[v], 0, 0};
      // Even at 5 m/s, some thirty steps lie within the smallest damping depth.
      const Impact found = impact(balls, pair_of(steel, steel, 0.35), of_law(published), 2e-4);
      states("e at " + std::to_string(speeds[v]) + " m/s, d = 1e-" + std::to_string(6 - d) + " m",
             found.restitution, expected[v][d], 6e-4,  // 5e-4 from its three digits
             "own integration of Mhadhbi 2021 eqs. 17-23");
    }
}

/// The normal loss of a collision is (1 - e^2) of its normal energy.
TEST(Restitution, is_what_the_record_says_was_lost) {
  for (const contact::AnyLaw& law :
       std::vector<contact::AnyLaw>{HertzMindlin{}, HertzTsuji{}, AdamsImpact{}, WaltonBraun{}}) {
    scene::Ball ball = steel_ball;
    ball.velocity = {0, 0, -1};
    const Impact found = impact({ball}, pair_of(steel, rigid, 0.6), of_law(law), 5e-3);
    const std::string word(contact::name_of(law));
    states("loss of a collision over its energy, " + word,
           found.record.lost_normal / found.record.energy_normal(), 1 - 0.6 * 0.6, 2e-3,
           "1 - e^2, e to 1e-3");
    states("impulse over m v, " + word, found.record.impulse / (ball.mass() * 1), 1.6, 1e-3,
           "1 + e, e to 1e-3");
  }
}

/// Where in a step a weakly adhesive contact ends does not matter, in the pull-off neither.
TEST(Jkr, rebounds_alike_wherever_in_a_step_its_last_force_acts) {
  constexpr int phases = 24;
  double most = 0;
  for (const double e : {0.1125, 0.125, 0.1625, 0.2, 0.3, 0.5}) {
    contact::Pair pair = pair_of({210e9, 0}, {210e9, 0}, e, 0.4);
    pair.surface_energy = 0.05;
    const scene::Ball ball{0.005, 7850, {}, {0.1, 0, -1}, {}};
    const double exact = impact({ball}, pair, of_law(Jkr{}), 1e-3).restitution;
    const double told = soft::step_error(Jkr{}, e, 25).single;
    for (int k = 0; k < phases; ++k) {
      const Impact found = impact({ball}, pair, of_law(Jkr{}), 1.0 / 25, (k + 0.5) / phases);
      most = max_or_nan(most, std::abs(found.restitution / exact - 1) / told);
    }
  }
  stays_below("rebound of one collision, off by, over what is told", most, 1,
              "step_error of the law");
}

/// Elastic spheres with adhesion: the work of separation beyond touch is lost,
/// 7.09 (G^5 R*^4 / E*^2)^(1/3) with G = 2 gamma. At lower speeds the spheres stick (Thornton and
/// Ning 1998, three digits).
TEST(Jkr, spheres_rebound_as_their_adhesion_lets_them) {
  contact::Pair pair = pair_of({1e9, 0.3}, {1e9, 0.3}, 1);
  pair.surface_energy = 0.2;
  scene::Ball ball{0.001, 2500, {}, {}, {}};
  const double work =
      7.09 * std::cbrt(std::pow(0.4, 5) * std::pow(ball.radius, 4) / std::pow(pair.modulus, 2));
  const double sticking = std::sqrt(2 * work / ball.mass());
  for (const double faster : {0.95, 1.2, 2.0, 5.0}) {
    ball.velocity = {0, 0, -faster * sticking};
    const Impact found = impact({ball}, pair, of_law(Jkr{}), 1e-4);
    const std::string at = "at " + std::to_string(faster).substr(0, 4) + " of the sticking speed";
    if (faster < 1) {
      states("collisions ended, " + at, static_cast<double>(found.energy_balance.collisions), 0, 0,
             "Thornton and Ning 1998");
      continue;
    }
    const double e = std::sqrt(1 - 1 / (faster * faster));
    // 7.09 is known to 1e-3. The error of e is half of this over e (v/v_s)^2, plus 1e-3 for the
    // time steps.
    states("e, " + at, found.restitution, e, 1e-3 + 0.5e-3 / (e * faster * faster),
           "sqrt(1 - (v_s/v)^2), Thornton and Ning 1998");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::restitution_test
