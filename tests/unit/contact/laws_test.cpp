// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Contact laws alone: forces at given overlaps, without any engine.
#include "mahlwerk/contact/laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "statement.hpp"

namespace mahlwerk::contact::laws_test {
namespace {

const double pi = std::numbers::pi;

EffectivePair some_contact() {
  Pair pair;
  pair.modulus = 1e8;
  pair.shear_modulus = 3e7;
  pair.restitution = 0.6;
  pair.surface_energy = 0.5;
  pair.cohesion = 2e5;
  return {pair, 0.005, 0.002};
}

template <class L>
double force(const LawCoefficients& k, double overlap, double rate = 0) {
  double memory[law_history_size] = {};
  return L::template evaluate<double>(k.data(), memory, overlap, rate).force;
}

TEST(Laws, effective_moduli_are_those_of_both_bodies) {
  const ElasticConstants steel{200e9, 0.265}, glass{48e9, 0.2}, rigid{INFINITY, 0.3};
  tests::states("E* of two alike, times 2 (1 - nu^2)/E",
                effective_modulus(steel, steel) * 2 * (1 - 0.265 * 0.265) / 200e9, 1, 1e-14,
                "dem.2");
  tests::states("across over along, 4 G*/E*, of bodies alike",
                4 * effective_shear_modulus(steel, steel) / effective_modulus(steel, steel),
                2 * (1 - 0.265) / (2 - 0.265), 1e-14, "2 (1 - nu)/(2 - nu), Mindlin 1949");
  EXPECT_EQ(effective_modulus(steel, glass), effective_modulus(glass, steel));
  EXPECT_EQ(effective_modulus(rigid, glass), 48e9 / (1 - 0.04));
}

TEST(Laws, hertz_gives_the_force_of_hertz) {
  const EffectivePair t = some_contact();
  const HertzMindlin law;
  const LawCoefficients k = law.coefficients(t, 0);
  for (const double d : {1e-7, 1e-5, 1e-3}) {
    const double wanted = 4.0 / 3 * 1e8 * std::sqrt(0.005) * std::pow(d, 1.5);
    tests::states("Hertz force [N]", force<HertzMindlin>(k, d), wanted, 1e-12 * wanted, "dem.5");
  }
}

TEST(Jkr, pulls_off_at_three_pi_gamma_r) {
  const EffectivePair t = some_contact();
  const Jkr law;
  const LawCoefficients k = law.coefficients(t, 0);
  const double wanted = -3 * pi * 0.5 * t.radius, reach = law.pull_off_distance(t);
  double least = 0, at = 0;
  for (int i = 0; i <= 20000; ++i) {  // separated slowly until pull-off
    const double overlap = reach * (1 - 1e-4 * i), f = force<Jkr>(k, overlap);
    if (f < least) least = f, at = overlap;
  }
  tests::states("pull-off force over 3 pi gamma R*", least / wanted, 1, 1e-6, "JKR 1971");
  tests::states("force at zero overlap over pull-off", force<Jkr>(k, 0) / wanted, 8.0 / 9, 1e-9,
                "JKR 1971");
  EXPECT_LT(at, 0) << "beyond touch";
}

TEST(Jkr, obeys_its_own_two_equations_at_every_radius_of_contact) {
  const EffectivePair t = some_contact();
  const double e = 1e8, r = t.radius, gamma = 0.5;
  const LawCoefficients k = Jkr().coefficients(t, 0);
  const double least = std::cbrt(pi * gamma * r * r / (4 * e));  // at pull-off, overlap controlled
  double worst = 0;
  for (double a = 1.01 * least; a < 30 * least; a *= 1.1) {
    const double overlap = a * a / r - 2 * std::sqrt(pi * gamma * a / e);
    const double wanted =
        4 * e * a * a * a / (3 * r) - 2 * pi * a * a * std::sqrt(4 * gamma * e / (pi * a));
    worst =
        tests::max_or_nan(worst, std::abs(force<Jkr>(k, overlap) - wanted) / (3 * pi * gamma * r));
  }
  tests::stays_below("JKR force over pull-off, off its equations by", worst, 1e-8, "JKR 1971");
}

TEST(Jkr, without_adhesion_is_hertz_mindlin) {
  EffectivePair t = some_contact();
  t.pair.surface_energy = 0;
  const Jkr law;
  const HertzMindlin plain;
  const double c = plain.damping(0.6);
  for (const double d : {1e-7, 1e-5, 1e-3})
    for (const double rate : {-0.5, 0.0, 1.0}) {
      const double wanted = force<HertzMindlin>(plain.coefficients(t, c), d, rate);
      EXPECT_NEAR(force<Jkr>(law.coefficients(t, c), d, rate), wanted,
                  1e-11 * std::abs(wanted) + 1e-13);
    }
}

TEST(Sjkr, pulls_by_the_area_of_contact) {
  const EffectivePair t = some_contact();
  const HertzMindlin plain;
  const LawCoefficients k = Sjkr().coefficients(t, 0);
  for (const double d : {1e-6, 1e-4}) {
    const double wanted = -2e5 * 2 * pi * d * 2 * t.radius;
    tests::states("SJKR cohesion [N]",
                  force<Sjkr>(k, d) - force<HertzMindlin>(plain.coefficients(t, 0), d), wanted,
                  1e-10 * std::abs(wanted), "energy density times 2 pi overlap 2 R*");
  }
}

TEST(WaltonBraun, loses_the_area_of_its_loop) {
  WaltonBraun law;
  law.stiffness = 1e5;
  const LawCoefficients k = law.coefficients(some_contact(), law.damping(0.6));
  double memory[law_history_size] = {};
  const double deepest = 1e-4, step = 1e-9;
  double in = 0, out = 0;
  const auto push = [&](double d) {
    return WaltonBraun::evaluate<double>(k.data(), memory, d, 0).force;
  };
  for (double d = step; d < deepest; d += step) in += push(d) * step;
  for (double d = deepest; d > 0; d -= step) out += push(d) * step;
  tests::states("work got back over work put in", out / in, 0.36, 1e-4, "e^2, e = sqrt(k1/k2)");
}

}  // namespace
}  // namespace mahlwerk::contact::laws_test
