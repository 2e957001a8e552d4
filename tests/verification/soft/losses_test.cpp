// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the books call dissipated is what dampers and plastic loops take (dem.39): nothing without
// them, and never less than nothing. A ball without friction moves as a smooth one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "crowd.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::losses_test {
namespace {

constexpr contact::ElasticConstants steel{200e9, 0.3};
const std::vector<double> phases{0.03, 0.21, 0.37, 0.55, 0.79, 0.96};
const scene::Ball ball{0.004, 7850, {}, {0, 0, -1}, {}};

/// Calls `look` for a head-on collision under each law at several phases of a step.
template <class Look>
void each_collision(double e, double share, const Look& look) {
  for (const contact::AnyLaw& law : contact::all_laws())
    for (const double phase : phases)
      look(contact::name_of(law),
           impact({ball}, pair_of(steel, rigid, e), of_law(law), share, phase));
}

TEST(Losses, an_elastic_collision_dissipates_nothing_and_keeps_its_energy) {
  double most = 0, lost = 0;
  each_collision(1, 1.0 / 50, [&](std::string_view law, const Impact& hit) {
    SCOPED_TRACE(std::string(law));
    lost =
        max_or_nan(lost, std::abs(hit.record.lost_normal) + std::abs(hit.record.lost_tangential));
    most = max_or_nan(most, std::abs(hit.restitution * hit.restitution - 1));
    EXPECT_EQ(hit.energy_balance.collisions, 1);
  });
  states("lost [J]", lost, 0, 0, "neither damper nor plastic loop nor friction");
  // The weights of the first and the last force are those of the integral (dem.35). The next term
  // of the Euler-Maclaurin sum is F''' dt^4/720 at both ends, (pi/50)^4/720 of the impulse, 2e-8;
  // the laws that solve for their damper solve e = 1 to 6e-5 of the speed. SJKR takes the weight of
  // a force that grows in proportion to the overlap: for Hertz's it is off by up to 5 % of the
  // first force, (pi/50)^1.5 = 0.016 of the largest, which lasts 30 steps: 3e-5 at both ends, four
  // times that of the energy.
  stays_below("change of energy, relative", most, 2.4e-4, "elastic");
}

/// Expected: the energy that the ball has lost. The rates of (dem.39) are predicted to second
/// order.
TEST(Losses, are_the_energy_that_the_collision_takes) {
  for (const double e : {0.3, 0.6, 0.9}) {
    double usual = 0, fine = 0, least = INFINITY;
    const auto off = [&](const Impact& hit, double& most) {
      const double before = 0.5 * hit.record.mass * hit.record.approach * hit.record.approach;
      const double taken = 1 - hit.restitution * hit.restitution;
      most = max_or_nan(most, std::abs(hit.record.lost_normal / before - taken));
      least = std::min(least, hit.record.lost_normal);
    };
    each_collision(e, 1.0 / 50, [&](std::string_view, const Impact& hit) { off(hit, usual); });
    each_collision(e, 1.0 / 200, [&](std::string_view, const Impact& hit) { off(hit, fine); });
    const std::string at = fmt::format(", e = {}", e);
    // w dt = pi/50 for the frequency w of a contact; the predicted rate is off by (w dt)^2/2 of
    // its amplitude, 2e-3. A jump of the damper at touch adds as much.
    stays_below("lost less the energy taken, t_c/50, relative" + at, usual, 4e-3, "(pi/50)^2");
    stays_below("the same, t_c/200" + at, fine, 4e-3 / 10, "second order: a sixteenth");
    EXPECT_GE(least, 0) << at;
  }
}

/// Balls in a box at rest, without gravity.
std::vector<scene::Ball> gas(int count) {
  return lattice_of(count, 0.011, {0.005}, 4);
}

TEST(Losses, an_elastic_gas_loses_nothing) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{100}})
    for (const contact::AnyLaw& law :
         {contact::AnyLaw{contact::HertzMindlin{}}, contact::AnyLaw{contact::LinearSpring{}},
          contact::AnyLaw{contact::WaltonBraun{}}}) {
      const scene::Chamber box = still_box(0.06);
      const contact::Pair pair = pair_of(steel, steel, 1);
      std::vector<scene::Ball> balls = gas(30);
      for (scene::Ball& b : balls) b.spin = {};
      const double step = contact_time(of_law(law), touching(pair, balls[0]), 8) / 50;
      const auto engine =
          soft::make_engine(box, balls, {of_law(law), step, false, few},
                            contact::PairTable(1, geometry::faces(*box.shape), pair), 0);
      Recorder recorder;
      engine->advance(0.03, recorder);
      const scene::EnergyBalance found = engine->energy_balance();
      const std::string what =
          fmt::format("{}, {} balls", contact::name_of(law), few == 0 ? "many" : "few");
      EXPECT_GT(recorder.all.size(), 20U) << what;
      states("lost [J], " + what, found.lost(), 0, 0, "e = 1, mu = 0");
      // Each collision changes its energy by the error of an elastic one, some 1e-6, and collisions
      // of three bodies by more; ten times that.
      const double kept = (found.kinetic + found.elastic) / found.initial_energy;
      states("energy kept, " + what, kept, 1, 1e-4, "elastic");
    }
}

/// What contacts dissipate over a time is never negative, in records and in open contacts.
TEST(Losses, of_open_contacts_are_never_negative) {
  for (const World& w : worlds())
    for (const std::size_t few : {std::size_t{0}, std::size_t{1000}}) {
      SCOPED_TRACE(w.name);
      const auto engine = crowd(w, 1, few);
      Recorder before, after;
      engine->advance(0.012, before);
      engine->begin_counting();
      const scene::EnergyBalance start = engine->energy_balance();
      // The tangential sums of a contact keep what its spring stores, with the rounding of a sum.
      states(w.name + ": lost in open contacts when counting begins, over all lost",
             start.lost_open / start.lost(), 0, 1e-12, "its records start anew");
      engine->advance(0.02, after);
      const scene::EnergyBalance end = engine->energy_balance();
      double recorded = 0, least = 0;
      for (const scene::Collision& c : after.all) {
        recorded += c.lost();
        least = std::min(least, c.lost_normal);
      }
      const double lost = end.lost() - start.lost();
      states(w.name + ": records and open contacts over all lost",
             (recorded + end.lost_open) / lost, 1, 1e-9, "(obs.3)");
      EXPECT_GE(least, -1e-15 * lost);
      EXPECT_GE(end.lost_open, -1e-9 * lost);
    }
}

TEST(FrictionlessBall, falls_and_bounces_straight_under_every_law_and_rolling_rule) {
  for (const contact::AnyLaw& law : contact::all_laws())
    for (const contact::Rolling rule : {contact::Rolling::cdt, contact::Rolling::viscous,
                                        contact::Rolling::epsd, contact::Rolling::own_spin})
      for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
        contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.5);
        pair.rolling_friction = 0.01;
        const scene::Chamber box = still_box(0.03, {0, 0, -gravity});
        scene::Ball still = ball;
        still.velocity = {};
        const contact::ContactModel model = of_law(law, rule);
        const double step = contact_time(model, touching(pair, still), 1) / 50;
        const auto engine =
            soft::make_engine(box, {still}, {model, step, false, few},
                              contact::PairTable(1, geometry::faces(*box.shape), pair), 0);
        Recorder none;
        engine->advance(0.4, none);
        const scene::Ball found = engine->balls()[0];
        const std::string what =
            fmt::format("{}, {}", contact::name_of(law), contact::rule_of(rule).name);
        stays_below("moved to the side [m], " + what,
                    std::hypot(found.position.x, found.position.y), 1e-15, "no friction");
        stays_below("spin [rad/s], " + what, norm(found.spin), 1e-12, "no friction");
        EXPECT_LT(found.position.z, -0.01) << what;
      }
}

}  // namespace
}  // namespace mahlwerk::tests::losses_test
