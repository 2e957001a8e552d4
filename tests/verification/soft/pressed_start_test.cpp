// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Balls that the start presses together, as a charge that came to rest before: their contacts store
// elastic energy from the start on.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::pressed_start_test {
namespace {

constexpr contact::ElasticConstants plastic{1e7, 0.3};
constexpr double r = 0.01, side = 1, depth = 0.1 * r;  // [m]
constexpr int layers = 6;

/// Balls in a column on the floor. Each touches the one below with the overlap `depth`.
std::vector<scene::Ball> column() {
  std::vector<scene::Ball> balls;
  for (int i = 0; i < layers; ++i)
    balls.push_back({r, 2500, {0, 0, -0.5 * side + r - depth + i * (2 * r - depth)}, {}, {}});
  return balls;
}

std::unique_ptr<scene::Engine> pressed(const contact::AnyLaw& law, std::size_t few) {
  const scene::Chamber box = still_box(side, {0, 0, -gravity});
  soft::Settings settings{of_law(law), 2e-6, false, few};
  settings.max_initial_overlap = 0.5;
  return soft::make_engine(box, column(), settings,
                           contact::PairTable(1, 6, pair_of(plastic, rigid, 0.5, 0.3)), 0);
}

TEST(PressedStart, stores_its_energy_from_the_start_on) {
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const std::string what = few == 0 ? ", many" : ", few";
    const contact::Pair pair = pair_of(plastic, rigid, 0.5, 0.3);
    const auto spring = [&](double radius) {
      return contact::hertz_energy(contact::hertz_stiffness({pair, radius, 1}), depth);
    };
    const double stored = spring(r) + (layers - 1) * spring(0.5 * r);
    const auto engine = pressed(contact::HertzMindlin{}, few);
    const scene::EnergyBalance start = engine->energy_balance();
    states("elastic energy at the start over Hertz's" + what, start.elastic / stored, 1, 1e-9,
           "(2/5) k d^(5/2) of each contact");
    states("residual at the start over it" + what, start.residual() / stored, 0, 1e-12,
           "the balance begins with it");
    Recorder none;
    engine->advance(0.02, none);
    const scene::EnergyBalance end = engine->energy_balance();
    EXPECT_GT(end.kinetic + end.potential - start.potential, 0.1 * stored) << "it pushes them up";
    stays_below("residual after 20 ms over it" + what, std::abs(end.residual()) / stored, 1e-4,
                "the balance closes");
  }
}

TEST(PressedStart, is_no_sign_of_an_unstable_run_under_any_law_that_presses) {
  contact::ThorntonNing yielding;
  yielding.yield_pressure = 1e6;  // [Pa], half of Hertz's at this overlap
  const contact::AnyLaw laws[] = {contact::HertzMindlin{}, contact::HertzTsuji{},
                                  contact::LinearSpring{}, contact::WaltonBraun{}, yielding};
  for (const contact::AnyLaw& law : laws)
    for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
      const auto engine = pressed(law, few);
      const double stored = engine->energy_balance().elastic;
      const std::string what{contact::name_of(law)};
      Recorder none;
      EXPECT_NO_THROW(engine->advance(0.02, none)) << what;
      stays_below(what + ": residual after 20 ms over the energy of the start",
                  std::abs(engine->energy_balance().residual()) / stored, 1e-4, "it closes");
    }
}

}  // namespace
}  // namespace mahlwerk::tests::pressed_start_test
