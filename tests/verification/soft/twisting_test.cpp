// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Twisting friction (dem.42 to dem.44): a ball that is pressed on a floor by its weight spins about
// the normal.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::twisting_test {
namespace {

constexpr contact::ElasticConstants plastic{1e8, 0.3};
const scene::Ball big{0.01, 7850, {}, {}, {}};
constexpr double side = 1;

/// A ball at rest in its dent, at the spin `spin` [rad/s] about the normal.
struct Pressed {
  contact::Pair pair;
  double depth, radius, weight;  ///< [m], [m] of the contact area, [N]
  std::unique_ptr<scene::Engine> engine;

  Pressed(double e, double mu, double spin, std::size_t few)
      : pair(pair_of(plastic, rigid, e, mu)) {
    const contact::EffectivePair t = touching(pair, big);
    weight = t.mass * gravity;
    depth = std::pow(weight / contact::hertz_stiffness(t), 2.0 / 3);
    radius = std::sqrt(big.radius * depth);
    scene::Ball ball = big;
    ball.position.z = -0.5 * side + ball.radius - depth;
    ball.spin.z = spin;
    contact::ContactModel model = of_law(contact::HertzMindlin{});
    model.twisting = contact::Twisting::marshall;
    const scene::Chamber box = still_box(side, {0, 0, -gravity});
    const double step = 0.02 / std::sqrt(1.5 * gravity / depth);
    engine = soft::make_engine(box, {ball}, {model, step, false, few},
                               contact::PairTable(1, geometry::faces(*box.shape), pair), 0);
  }
  double stiffness() const {  ///< [N m] of the twisting spring
    return 0.5 * radius * radius * 8 * pair.shear_modulus * radius;
  }
  double spin_at(double time) const {
    Recorder none;
    engine->advance(time, none);
    return engine->balls()[0].spin.z;
  }
};

TEST(Twisting, slows_a_pressed_ball_by_two_thirds_of_mu_a_n) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const double mu = 0.3, start = 2;
    const Pressed on(0.5, mu, start, few);
    const double slowing = 2.0 / 3 * mu * on.radius * on.weight / big.inertia();
    const double time = 0.5 * start / slowing;
    const std::string what = few == 0 ? ", many" : ", few";
    // While its spring is wound the ball turns by the angle of the limit; the torque then is below
    // it, which leaves up to half of that angle times k_w/I of the spin.
    const double angle = slowing * big.inertia() / on.stiffness(), elapsed = angle / start;
    const double found = on.spin_at(time), reached = on.engine->energy_balance().time;
    states("spin after half the time to rest [rad/s]" + what, found, start - slowing * reached,
           slowing * elapsed + 1e-3 * start, "Coulomb over the contact area (dem.44)");
    const scene::EnergyBalance balance = on.engine->energy_balance();
    const double taken = 0.5 * big.inertia() * (start * start - found * found);
    const double dent =
        contact::hertz_energy(contact::hertz_stiffness(touching(on.pair, big)), on.depth);
    states("lost and stored over the energy of the spin" + what,
           (balance.lost() + balance.elastic - dent) / taken, 1, 2e-3, "energy");
    // When the ball stops its spring is wound to the limit, so that it swings back by at most the
    // spin that this energy gives.
    const double swing = slowing * std::sqrt(big.inertia() / on.stiffness());
    stays_below("spin after three times the time [rad/s]" + what, std::abs(on.spin_at(6 * time)),
                swing, "it stops but for the torsion spring");
  }
}

TEST(Twisting, a_ball_that_sticks_swings_at_the_frequency_of_the_spring) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const Pressed on(1, 10, 0.01, few);
    const double frequency = std::sqrt(on.stiffness() / big.inertia());  // [rad/s]
    const double half = std::numbers::pi / frequency;
    const std::string what = few == 0 ? ", many" : ", few";
    states("spin after half a period over that at the start" + what, on.spin_at(half) / 0.01, -1,
           1e-3, "torsion spring (dem.43)");
    states("spin after a period over that at the start" + what, on.spin_at(2 * half) / 0.01, 1,
           2e-3, "torsion spring (dem.43)");
  }
}

TEST(Twisting, none_leaves_the_spin_about_the_normal) {
  const contact::Pair pair = pair_of(plastic, rigid, 0.5, 0.3);
  scene::Ball ball = big;
  ball.position.z = -0.5 * side + ball.radius;
  ball.spin.z = 2;
  const auto engine =
      soft_engine(still_box(side, {0, 0, -gravity}), {ball},
                  of_law(contact::HertzMindlin{}, contact::Rolling::cdt), pair, 1e-5);
  Recorder none;
  engine->advance(0.05, none);
  states("spin [rad/s]", engine->balls()[0].spin.z, 2, 1e-12, "no torque along the normal");
}

}  // namespace
}  // namespace mahlwerk::tests::twisting_test
