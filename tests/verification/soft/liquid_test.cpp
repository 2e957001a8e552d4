// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A liquid in the soft engine: lubrication between bodies that approach, and drag and pressure on
// balls in a jar full of liquid (docs/theory/liquid.md).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "crowd.hpp"
#include "isas.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::liquid_test {
namespace {

using contact::HertzMindlin;
using contact::Liquid;

constexpr double dry_restitution = 0.8;
contact::Pair dry_pair() {
  return pair_of({1e9, 0.3}, {1e9, 0.3}, dry_restitution);
}

Liquid oil_film() {
  Liquid liquid;
  liquid.viscosity = 0.1;
  liquid.film = 50e-6;
  liquid.roughness = 2e-6;
  return liquid;
}
Liquid full_of(double viscosity, double density) {
  Liquid liquid;
  liquid.viscosity = viscosity;
  liquid.density = density;
  liquid.flooded = true;
  return liquid;
}

std::unique_ptr<scene::Engine> engine_of(const scene::Chamber& chamber,
                                         const std::vector<scene::Ball>& balls,
                                         const contact::Pair& pair, double step,
                                         const std::optional<Liquid>& liquid, std::size_t few = 32,
                                         int threads = 1, bool hop = false) {
  soft::Settings settings{of_law(HertzMindlin{}, contact::Rolling::cdt), step, hop, few};
  settings.threads = threads;
  settings.liquid = liquid;
  return soft::make_engine(chamber, balls, settings,
                           contact::PairTable(1, geometry::faces(*chamber.shape), pair), 0.37);
}

/// Two balls of 10 and 6 mm, or a ball at the floor, that approach at `speed`.
struct Approach {
  scene::Chamber box = still_box(0.1);
  std::vector<scene::Ball> balls;
  contact::EffectivePair pair;
  double gap(const std::vector<scene::Ball>& b) const {
    return b.size() == 1 ? b[0].position.z + 0.05 - b[0].radius
                         : norm(b[1].position - b[0].position) - b[0].radius - b[1].radius;
  }
  double closing(const std::vector<scene::Ball>& b) const {
    return b.size() == 1 ? -b[0].velocity.z : b[0].velocity.x - b[1].velocity.x;
  }
};
Approach approach(bool wall, double speed, double gap) {
  Approach a;
  const scene::Ball ball{0.005, 7850, {}, {}, {}}, small{0.003, 7850, {}, {}, {}};
  if (wall) {
    a.balls = {ball};
    a.balls[0].position = {0, 0, -0.05 + ball.radius + gap};
    a.balls[0].velocity = {0, 0, -speed};
  } else {
    a.balls = {ball, small};
    a.balls[0].velocity = {0.7 * speed, 0, 0};
    a.balls[1].position = {ball.radius + small.radius + gap, 0, 0};
    a.balls[1].velocity = {-0.3 * speed, 0, 0};
  }
  a.pair = touching(dry_pair(), a.balls);
  return a;
}

/// Error [m/s] of the speed at touch: the force of a step takes the speed as constant, but it
/// changes by (k/m) dh/h. Summed over the way: (k/m)^2 dt / (2 h_r), at touch; at a separation h
/// likewise. Half of a step's impulse comes at its middle: another (k/m) (v dt / h)^2 / 8.
double error_of_speed(double k_over_m, double step, double separation, double speed) {
  const double share = speed * step / separation;
  return k_over_m * k_over_m * step / (2 * separation) + k_over_m * share * share / 8;
}

TEST(Lubrication, slows_two_bodies_down_as_reynolds_says) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true})
    for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
      const double v0 = 0.3, step = 1e-7, h0 = 2 * liquid.film;
      const Approach a = approach(wall, v0, h0);
      const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid, few);
      const double k_over_m = liquid.resistance(a.pair.radius) / a.pair.mass;
      Recorder recorder;
      double worst = 0, allowed = 0, lowest = v0;
      for (double t = step; a.gap(engine->balls()) > 0; t += step) {
        engine->advance(t, recorder);
        const auto now = engine->balls();
        const double h = a.gap(now) + liquid.roughness;
        // The first step in the film and the last one before touch cover the rest of the way.
        const double way = 2 * v0 * step;
        if (h >= h0 - way || a.gap(now) <= way) continue;
        const double expected = v0 - k_over_m * math::log(h0 / h);
        const double bound = error_of_speed(k_over_m, step, h, v0) + 1e-12;
        if (std::abs(a.closing(now) - expected) > worst) {
          worst = std::abs(a.closing(now) - expected);
          allowed = bound;
        }
        EXPECT_LE(std::abs(a.closing(now) - expected), bound) << h;
        lowest = a.closing(now);
      }
      const std::string name =
          fmt::format("{}, {}", wall ? "ball and wall" : "two balls", few ? "few" : "many");
      stays_below(name + ": speed off v0 - (k/m*) ln(h0/h) [m/s]", worst, allowed,
                  "(liq.3), error of the steps");
      EXPECT_LT(lowest, 0.9 * v0) << "the liquid hardly acts: the test shows nothing";
    }
}

/// A collision in a film. Returns rebound over approach.
double wet_restitution(const Approach& a, const Liquid& liquid, double step, bool& touched) {
  const double speed = a.closing(a.balls);
  const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid);
  Recorder recorder;
  double t = 0;
  while (t < 0.5) {
    engine->advance(t += 100 * step, recorder);
    if (!recorder.all.empty() && a.gap(engine->balls()) > 2 * liquid.film) break;
  }
  touched = !recorder.all.empty();
  const scene::EnergyBalance e = engine->energy_balance();
  EXPECT_LT(std::abs(e.residual()), 1e-4 * e.initial_energy);
  return -a.closing(engine->balls()) / speed;
}

TEST(Lubrication, gives_the_restitution_of_the_stokes_number) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true})
    for (const double ratio : {1.1, 1.5, 3.0, 10.0, 100.0}) {  // St over its critical value
      const contact::EffectivePair pair = approach(wall, 1, 1e-3).pair;
      const double critical = liquid.critical_speed(pair.radius, pair.mass);
      const double speed = ratio * critical;
      const double step = contact::hertz_time(pair, speed) / 400;
      bool touched = false;
      const double found = wet_restitution(approach(wall, speed, 2.3e-4), liquid, step, touched);
      EXPECT_TRUE(touched);
      // The dry collision itself, at the speed of touch, by the same steps.
      Liquid nothing = liquid;
      nothing.viscosity = 1e-12;
      const double dry =
          wet_restitution(approach(wall, speed - critical, 2.3e-4), nothing, step, touched);
      const double k_over_m = liquid.resistance(pair.radius) / pair.mass;
      const double tolerance =
          error_of_speed(k_over_m, step, liquid.roughness, speed - critical) / speed + 1e-3 / ratio;
      states(fmt::format("{}, St = {} St_c: e", wall ? "wall" : "balls", ratio), found,
             dry * (1 - 1 / ratio), tolerance, "e_dry (1 - St_c/St), Davis et al. 1986 (liq.4)");
    }
}

TEST(Lubrication, stops_bodies_below_the_critical_stokes_number) {
  const Liquid liquid = oil_film();
  for (const bool wall : {false, true}) {
    Approach a = approach(wall, 1, 2e-4);
    const double k_over_m = liquid.resistance(a.pair.radius) / a.pair.mass;
    const double speed = 0.7 * liquid.critical_speed(a.pair.radius, a.pair.mass);
    a = approach(wall, speed, 2e-4);
    const double step = 0.2 * liquid.roughness / k_over_m;  // (liq.9)
    const auto engine = engine_of(a.box, a.balls, dry_pair(), step, liquid);
    Recorder recorder;
    engine->advance(0.05, recorder);
    EXPECT_TRUE(recorder.all.empty());
    const double h = 2 * liquid.film * math::exp(-speed / k_over_m);
    // An error of the speed dv shifts the end by h dv / (k/m).
    const double tolerance = h * error_of_speed(k_over_m, step, h, speed) / k_over_m;
    states("separation at the end [m]", a.gap(engine->balls()) + liquid.roughness, h, tolerance,
           "(liq.3) at v = 0");
  }
}

TEST(Lubrication, that_resists_the_rebound_acts_twice) {
  Liquid liquid = oil_film();
  liquid.resists_rebound = true;
  const double ratio = 4;
  const contact::EffectivePair pair = approach(true, 1, 1e-3).pair;
  const double critical = liquid.critical_speed(pair.radius, pair.mass), speed = ratio * critical;
  const double step = contact::hertz_time(pair, speed) / 400;
  bool touched = false;
  const double found = wet_restitution(approach(true, speed, 2.3e-4), liquid, step, touched);
  const double k_over_m = liquid.resistance(pair.radius) / pair.mass;
  states("e, film that resists the rebound", found, dry_restitution * (1 - 1 / ratio) - 1 / ratio,
         2 * error_of_speed(k_over_m, step, liquid.roughness, speed) / speed + 1e-3,
         "(liq.3), approach and rebound");
}

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
      Archive out;
      before->serialize(out);
      Archive in(out.bytes());
      after->serialize(in);
      in.finish();
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
