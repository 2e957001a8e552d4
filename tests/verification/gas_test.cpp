// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Kinetic theory of hard spheres: equation of state, mean free time, Maxwell's distribution,
// equipartition, Haff's law. Balls of diameter and mass 1 in a periodic box.
#include <array>

#include "many_balls.hpp"
#include "statement.hpp"

namespace mahlwerk::gas_test {
namespace {

using namespace tests;
constexpr double pi = std::numbers::pi;

/// Contact value of the pair distribution, Carnahan and Starling 1969.
double contact_value(double packing) {
  return (1 - packing / 2) / std::pow(1 - packing, 3);
}

struct Impulses final : scene::Observer {
  std::int64_t count = 0;
  double sum = 0;
  void collisions(std::span<const scene::Collision> finished) override {
    count += std::ssize(finished);
    for (const scene::Collision& c : finished) sum += c.impulse;
  }
};

struct Temperatures {
  double translation = 0, rotation = 0;  // m<v^2>/3 and I<w^2>/3
};
Temperatures temperatures(const std::vector<scene::Ball>& balls) {
  Temperatures t;
  for (const scene::Ball& b : balls) {
    const double n = static_cast<double>(balls.size());
    t.translation += b.mass() * squared(b.velocity) / 3 / n;
    t.rotation += b.inertia() * squared(b.spin) / 3 / n;
  }
  return t;
}

void check_equation_of_state(double packing) {
  constexpr int n = 10, count = n * n * n;
  const auto engine = gas(lattice(n, packing), side_of(n, packing), {1, 1, INFINITY});
  Impulses seen;
  const double rate = 4 * count / (pi / 6 / packing * count) * contact_value(packing) *
                      std::sqrt(pi / 3);  // Enskog's rate, per ball
  const double settle = 100 / rate, time = 1000 / rate;
  engine->advance(settle, seen);
  seen = {};
  engine->advance(settle + time, seen);
  const double found = 1 + seen.sum / (2 * time * engine->energy_balance().kinetic);
  const double expected =
      (1 + packing + packing * packing - std::pow(packing, 3)) / std::pow(1 - packing, 3);
  states("compressibility Z = P V/(N k T)", found, expected, 0.01 * expected,
         "Carnahan and Starling 1969; issue: 1 %");
  states("collisions of a ball per time", 2.0 * static_cast<double>(seen.count) / count / time,
         rate, 0.01 * rate, "Enskog with Carnahan-Starling's contact value");
}

TEST(Gas, pressure_and_mean_free_time_at_packing_0_20) {
  check_equation_of_state(0.20);
}
TEST(Gas, pressure_and_mean_free_time_at_packing_0_49) {
  check_equation_of_state(0.49);
}

TEST(Gas, speeds_are_maxwells) {
  constexpr int n = 12, looks = 60;
  const auto engine = gas(lattice(n, 0.2), side_of(n, 0.2), {1, 1, INFINITY});
  Counter counter;
  engine->advance(10, counter);
  double speed = 0, square = 0, fourth = 0;
  std::array<double, 3> parts{};
  for (int i = 1; i <= looks; ++i) {
    engine->advance(10 + i, counter);
    for (const scene::Ball& b : engine->balls()) {
      const double v2 = squared(b.velocity);
      speed += std::sqrt(v2);
      square += v2;
      fourth += v2 * v2;
      parts[0] += b.velocity.x * b.velocity.x;
      parts[1] += b.velocity.y * b.velocity.y;
      parts[2] += b.velocity.z * b.velocity.z;
    }
  }
  const double samples = looks * n * n * n, temperature = square / samples / 3;
  // Standard errors for n independent velocities, from the moments of Maxwell's distribution: mean
  // speed 0.67/sqrt(n) (0.42 of it), kurtosis 1.22/sqrt(n) (0.73 of it), share of an axis
  // 0.385/sqrt(n). The tolerance is three standard errors, doubled because the samples are not
  // quite independent.
  const double error = 1 / std::sqrt(samples);
  states("mean speed", speed / samples, std::sqrt(8 * temperature / pi), 6 * 0.42 * error,
         "Maxwell: sqrt(8 T/(pi m))");
  states("kurtosis <v^4>/<v^2>^2", fourth * samples / (square * square), 5.0 / 3, 6 * 1.22 * error,
         "Maxwell: 5/3");
  for (const double part : parts)
    states("share of the energy along an axis", part / square, 1.0 / 3, 6 * 0.385 * error,
           "isotropy");
}

TEST(Gas, perfectly_rough_spheres_share_energy_equally) {
  constexpr int n = 10;
  const auto engine =
      gas(lattice(n, 0.2, false), side_of(n, 0.2), {1, -1, INFINITY});  // no spin yet
  Counter counter;
  const double energy = engine->energy_balance().kinetic;
  engine->advance(20, counter);
  double ratio = 0;
  constexpr int looks = 200;
  for (int i = 1; i <= looks; ++i) {
    engine->advance(20 + 0.5 * i, counter);
    const Temperatures t = temperatures(engine->balls());
    ratio += t.rotation / t.translation / looks;
  }
  // The ratio in one sample scatters by sqrt(2 x 2/(3 x 1000)) = 3.7 %. A third of the 200 samples
  // are independent.
  states("T_rot / T_tr", ratio, 1, 3 * 0.037 / std::sqrt(200.0 / 3),
         "equipartition, e = 1, beta = 1");
  states("energy", engine->energy_balance().kinetic / energy, 1, 1e-10,
         "rough and elastic: conserved");
}

TEST(Gas, smooth_cooling_follows_haff) {
  constexpr int n = 20;
  constexpr double packing = 0.05, e = 0.9;
  const auto engine = gas(lattice(n, packing), side_of(n, packing), {1, 1, INFINITY});
  Counter counter;
  engine->advance(30, counter);  // elastic first, so that the lattice dissolves
  std::vector<scene::Ball> balls = engine->balls();
  const double start = temperatures(balls).translation;
  const auto cooling = gas(balls, side_of(n, packing), {e, 1, INFINITY});
  const double rate = 4 * (6 * packing / pi) * contact_value(packing) * std::sqrt(pi * start);
  const double tau = 6 / ((1 - e * e) * rate);
  for (const double times : {0.25, 0.5, 1.0, 2.0}) {
    cooling->advance(times * tau, counter);
    const double expected = start / std::pow(1 + times, 2);
    // The deviation from Maxwell's distribution slows cooling by some per mill at e = 0.9 (van
    // Noije and Ernst 1998: a_2 = -0.012, rate x (1 + 3/16 a_2)). The count scatters by 1 % at the
    // end.
    states("T after " + std::to_string(times) + " tau", temperatures(cooling->balls()).translation,
           expected, 0.02 * expected, "Haff 1983, Enskog rate");
  }
}

TEST(Gas, rough_cooling_follows_its_two_temperatures) {
  constexpr int n = 20;
  constexpr double packing = 0.05, e = 0.9, beta = 0, q = 0.4, eta = q * (1 + beta) / (2 * (1 + q));
  const auto engine = gas(lattice(n, packing), side_of(n, packing), {1, -1, INFINITY});
  Counter counter;
  engine->advance(60, counter);
  std::vector<scene::Ball> balls = engine->balls();
  Temperatures t = temperatures(balls);
  const auto cooling = gas(balls, side_of(n, packing), {e, -beta, INFINITY});
  const auto rates = [&](const Temperatures& now) -> Temperatures {
    const double w =
        4 * (6 * packing / pi) * contact_value(packing) * std::sqrt(pi * now.translation);
    const double a = (1 - e * e) / 4 + eta * (1 - eta), b = eta * eta / q,
                 c = eta / q * (1 - eta / q);
    return {-4.0 / 3 * w * (a * now.translation - b * now.rotation),
            4.0 / 3 * w * (b * now.translation - c * now.rotation)};
  };
  constexpr double step = 1e-3;
  double time = 0;
  for (const double until : {2.0, 5.0, 10.0}) {
    for (; time < until - step / 2; time += step) {  // midpoint rule: far more accurate than needed
      const Temperatures k = rates(t);
      const Temperatures l =
          rates({t.translation + step / 2 * k.translation, t.rotation + step / 2 * k.rotation});
      t = {t.translation + step * l.translation, t.rotation + step * l.rotation};
    }
    cooling->advance(until, counter);
    const Temperatures found = temperatures(cooling->balls());
    // The mean-field equations neglect correlations of velocity and spin and deviations from
    // Maxwell's distribution: some per cent (Brilliantov et al. 2007).
    states("T_tr at " + std::to_string(until), found.translation, t.translation,
           0.04 * t.translation, "Huthmann and Zippelius 1997, mean field");
    states("T_rot at " + std::to_string(until), found.rotation, t.rotation, 0.06 * t.rotation,
           "Huthmann and Zippelius 1997, mean field");
  }
}

}  // namespace
}  // namespace mahlwerk::gas_test
