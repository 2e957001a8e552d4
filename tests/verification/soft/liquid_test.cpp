// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A liquid in the soft engine: drag and pressure on balls in a jar full of liquid, energy and bits
// of whole runs (docs/theory/liquid.md). Lubrication is in lubrication_test.cpp.
#include "liquid.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "isas.hpp"
#include "same_bits.hpp"

namespace mahlwerk::tests::liquid_test {
namespace {

using namespace liquid;

/// Speed at which drag and buoyant weight balance, by bisection of the closed form.
double terminal_speed(const Liquid& liquid, const scene::Ball& ball) {
  const double weight = 4.0 / 3 * std::numbers::pi * ball.radius * ball.radius * ball.radius *
                        (ball.density - liquid.density) * gravity;
  double low = 0, high = 100;
  for (int i = 0; i < 200; ++i) {
    const double v = 0.5 * (low + high),
                 re = liquid.density * v * 2 * ball.radius / liquid.viscosity;
    const double coefficient =
        re < 1000 ? 24 / re * (1 + 0.15 * std::pow(re, 0.687)) : 0.44;  // of drag
    const double drag =
        0.5 * liquid.density * v * v * coefficient * std::numbers::pi * ball.radius * ball.radius;
    (drag < weight ? low : high) = v;
  }
  return 0.5 * (low + high);
}

TEST(Drag, gives_the_terminal_speed) {
  struct One {
    const char* name;
    double viscosity, radius, time;
  };
  for (const One& one :
       {One{"glycerol, Stokes", 1, 0.0005, 0.02}, One{"oil", 0.1, 0.001, 0.3},
        One{"water, Schiller-Naumann", 1e-3, 0.0005, 0.6}, One{"water, Newton", 1e-3, 0.002, 0.8}})
    for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
      const Liquid liquid = full_of(one.viscosity, 1000);
      const scene::Ball ball{one.radius, 7850, {0, 0, 0.9}, {}, {}};
      const auto engine =
          engine_of(still_box(4, {0, 0, -gravity}), {ball}, dry_pair(), 1e-5, liquid, few);
      Recorder recorder;
      engine->advance(one.time, recorder);
      const double expected = terminal_speed(liquid, ball);
      states(fmt::format("{}, {}: speed [m/s]", one.name, few ? "few" : "many"),
             -engine->balls()[0].velocity.z, expected, 1e-6 * expected,
             "Stokes; Schiller and Naumann 1933 (liq.6)");
      const scene::EnergyBalance e = engine->energy_balance();
      // The velocities have had half a kick of the last step, the work counts it whole.
      stays_below("energy balance", std::abs(e.residual()) / e.lost(), 1e-5 / one.time,
                  "(dem.32), half a step");
    }
}

/// A ball as dense as the liquid moves with it: pressure replaces its weight and the force that
/// keeps it on its circle.
TEST(Pressure, carries_a_ball_of_the_density_of_the_liquid) {
  const double step = 1e-5, omega = 12;
  const Liquid liquid = full_of(1e-3, 1000);
  const scene::Chamber drum{geometry::Cylinder{0.1, 0.1},
                            kinematics::Tumbling{omega},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -gravity}};
  const double r = 0.03, turn = 2 * std::numbers::pi / omega;
  const scene::Ball ball{0.003, 1000, {0, r, 0}, {0, 0, omega * r}, {omega, 0, 0}};
  for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
    const auto engine = engine_of(drum, {ball}, dry_pair(), step, liquid, few);
    Recorder recorder;
    const double time = std::round(turn / step) * step;
    engine->advance(time, recorder);
    const Vec3 x = engine->balls()[0].position;
    const double angle = omega * time;
    // Verlet on a circle: the phase is off by (w dt)^2 / 24 of the angle.
    const double tolerance = r * angle * omega * omega * step * step / 8 + 1e-12;
    stays_below("drum: off its circle after a turn [m]",
                norm(x - r * Vec3{0, math::cos(angle), math::sin(angle)}), tolerance,
                "rigid rotation (liq.7)");
    stays_below("spin against the liquid [rad/s]",
                norm(engine->balls()[0].spin - Vec3{omega, 0, 0}), 1e-9, "(liq.8)");
    const auto shaker =
        engine_of({geometry::Box{0.1, 0.1, 0.1}, shaken(20, 0.015), {}, {0, 0, -gravity}},
                  {{0.003, 1000, {0, 0, 0.01}, {}, {}}}, dry_pair(), step, liquid, few);
    const double shaken_time = 0.2;
    shaker->advance(shaken_time, recorder);
    // Drag acts at a velocity predicted from the force of the last step, so on a slip of
    // dt^2 A w^3 / 2. It leaves a drift of that over the drag's time and w.
    const double w = 2 * std::numbers::pi * 20;
    const double slip = 0.5 * step * step * 0.015 * w * w * w;
    const double drag_time = 2.0 / 9 * 0.003 * 0.003 * liquid.density / liquid.viscosity;
    stays_below("shaker: moved in the jar [m]",
                norm(shaker->balls()[0].position - Vec3{0, 0, 0.01}),
                slip / drag_time / w * shaken_time, "liquid at rest in the jar (liq.7)");
  }
}

TEST(Drag, slows_a_spin_down) {
  const Liquid liquid = full_of(1, 1000);
  const scene::Ball ball{0.001, 1000, {}, {}, {30, 0, 0}};
  const auto engine = engine_of(still_box(0.1), {ball}, dry_pair(), 1e-7, liquid);
  Recorder recorder;
  const double time = 1e-4, inertia = 0.4 * ball.mass() * ball.radius * ball.radius;
  engine->advance(time, recorder);
  const double rate = 8 * std::numbers::pi * 1e-9 / inertia;
  states("spin [rad/s]", engine->balls()[0].spin.x, 30 * math::exp(-rate * time),
         30 * rate * rate * 1e-14 * rate * time, "8 pi eta R^3 w, Kirchhoff (liq.8)");
}

struct Wet {
  std::string name;
  World world;
  Liquid liquid;
};
std::vector<Wet> wet_worlds() {
  std::vector<World> all = worlds();
  for (World& w : all) w.law = of_law(HertzMindlin{}, contact::Rolling::cdt);
  Liquid film = oil_film(), resisting = film, full = full_of(0.05, 900);
  film.viscosity = 1, film.film = 2e-4, resisting.resists_rebound = true;
  full.reach = 0.5;
  return {{"shaken, films", all[0], film},
          {"planetary, flooded", all[1], full},
          {"drum, films that resist", all[3], resisting},
          {"drum, flooded", all[3], full},
          {"open drum, films", all[5], film},
          {"periodic, films", all[6], film}};
}
std::unique_ptr<scene::Engine> wet(const Wet& w, int threads, std::size_t few, bool hop = false) {
  return engine_of(w.world.mill, w.world.balls, some_pair(), w.world.step, w.liquid, few, threads,
                   hop);
}

TEST(Liquid, closes_the_energy_balance_and_moves_few_as_many) {
  for (const Wet& w : wet_worlds()) {
    const auto few = wet(w, 1, 1000), many = wet(w, 1, 0);
    Wet aside = w;
    for (scene::Ball& b : aside.world.balls) b.position.x += 1e-13;
    const auto nudged = wet(aside, 1, 0);
    Recorder a, b, c;
    few->advance(0.012, a);
    many->advance(0.012, b);
    nudged->advance(0.012, c);
    double off = 0, grown = 0;
    for (std::size_t i = 0; i < w.world.balls.size(); ++i) {
      off = max_or_nan(off, norm(few->balls()[i].position - many->balls()[i].position));
      grown = max_or_nan(grown, norm(nudged->balls()[i].position - many->balls()[i].position));
    }
    stays_below(w.name + ": few and many apart [m]", off, std::max(1e-12, 10 * grown),
                "the same forces; grown from 1e-13 m");
    for (const auto& engine : {&few, &many}) {
      const scene::EnergyBalance e = (*engine)->energy_balance();
      stays_below(w.name + ": energy balance",
                  std::abs(e.residual()) / (std::abs(e.wall_work) + e.lost() + e.initial_energy),
                  1e-3, "(dem.32)");
      EXPECT_GT(e.lost_liquid, 1e-3 * e.lost()) << "the liquid hardly acts";
    }
  }
}

TEST(Liquid, has_the_same_bits_however_a_run_is_cut_stopped_and_compiled) {
  constexpr double time = 0.01;
  for (const Wet& w : wet_worlds())
    for (const std::size_t few : {std::size_t{0}, std::size_t{1000}}) {
      SCOPED_TRACE(w.name + (few ? ", few" : ", many"));
      const auto whole = wet(w, 1, few, true), pieces = wet(w, 2, few, true),
                 before = wet(w, 1, few, true), after = wet(w, 1, few, true);
      Recorder in_one, in_many, in_two;
      whole->advance(time, in_one);
      Random random(3, 0);
      std::vector<double> cuts{time};
      for (int i = 0; i < 50; ++i) cuts.push_back(random.uniform(0, time));
      std::ranges::sort(cuts);
      for (const double cut : cuts) pieces->advance(cut, in_many);
      expect_same(in_one, in_many);
      expect_same(*whole, *pieces);
      before->advance(0.00537, in_two);
      copy_state(*before, *after);
      after->advance(time, in_two);
      expect_same(*whole, *after);
      for (const Isa isa : supported_isas()) {
        const ChosenIsa chosen(isa);
        const auto narrow = wet(w, 1, few, true);
        Recorder by_narrow;
        narrow->advance(time, by_narrow);
        expect_same(*whole, *narrow);
      }
    }
}

TEST(Liquid, has_the_same_bits_by_threads_where_chunks_share_pairs) {
  const scene::Chamber drum{geometry::Cylinder{0.06, 0.06},
                            kinematics::Tumbling{10},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -gravity}};
  Liquid film = oil_film();
  film.film = 1e-4;
  const Wet w{"drum", {"drum", drum, lattice_of(4000, 0.0022, {0.001}, 0.2), {}, 2e-6}, film};
  const auto one = wet(w, 1, 0), three = wet(w, 3, 0);
  Recorder a, b;
  one->advance(0.004, a);
  three->advance(0.004, b);
  expect_same(a, b);
  expect_same(*one, *three);
  const scene::EnergyBalance e = one->energy_balance();
  stays_below("4000 balls: energy balance",
              std::abs(e.residual()) / (std::abs(e.wall_work) + e.lost() + e.initial_energy), 1e-3,
              "(dem.32)");
}

TEST(Liquid, allows_free_flight_skips_between_films) {
  const scene::Chamber shaker{geometry::Capsule{0.04, 0.02}, shaken(20, 0.015), {}, {}};
  const std::vector<scene::Ball> balls{{0.004, 7850, {-0.008, 0, 0}, {0.3, 0.1, 0}, {}},
                                       {0.003, 7850, {0.008, 0, 0}, {}, {}}};
  const auto skipping = engine_of(shaker, balls, dry_pair(), 1e-6, oil_film(), 32, 1, true),
             stepping = engine_of(shaker, balls, dry_pair(), 1e-6, oil_film(), 32, 1, false);
  Recorder a, b;
  skipping->advance(0.1, a);
  stepping->advance(0.1, b);
  EXPECT_LT(2 * skipping->energy_balance().time_steps, stepping->energy_balance().time_steps);
  ASSERT_GE(a.all.size(), 3U);
  // Steps follow the mill's oscillation to A (w dt)^2 = 2e-10 m, a skip is exact; each collision
  // multiplies the difference by at most about ten.
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(a.all[i].other, b.all[i].other);
    EXPECT_NEAR(a.all[i].approach, b.all[i].approach, 1e-4);
  }
  EXPECT_GT(stepping->energy_balance().lost_liquid, 0);
}

TEST(Liquid, gives_replicates_side_by_side_the_bits_of_each_alone) {
  const scene::Chamber shaker{
      geometry::Capsule{0.04, 0.02}, shaken(20, 0.015), {}, {0, 0, -gravity}};
  for (const Liquid& liquid : {oil_film(), full_of(0.01, 1000)}) {
    std::vector<std::unique_ptr<scene::Engine>> together, alone;
    std::vector<Recorder> seen(3), seen_alone(3);
    std::vector<scene::Engine*> engines;
    std::vector<scene::Observer*> observers;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto turn = static_cast<double>(k);
      std::vector<scene::Ball> balls{{0.004, 7850, {-0.008, 0, 0}, {0.3, 0.1 * turn, 0}, {}},
                                     {0.003, 7850, {0.008, 0, 0}, {0, 0, 0.2 * turn}, {}}};
      together.push_back(engine_of(shaker, balls, dry_pair(), 2e-6, liquid, 32, 1, true));
      alone.push_back(engine_of(shaker, balls, dry_pair(), 2e-6, liquid, 32, 1, true));
      engines.push_back(together.back().get());
      observers.push_back(&seen[k]);
    }
    for (const auto& failure : soft::advance_together(engines, 0.05, observers))
      EXPECT_EQ(failure, nullptr);
    for (std::size_t k = 0; k < 3; ++k) {
      alone[k]->advance(0.05, seen_alone[k]);
      expect_same(seen[k], seen_alone[k]);
      expect_same(*together[k], *alone[k]);
    }
  }
}

}  // namespace
}  // namespace mahlwerk::tests::liquid_test
