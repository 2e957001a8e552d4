// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/flash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "statement.hpp"

namespace mahlwerk::powder::flash_test {
namespace {

using tests::states;

const double pi = std::numbers::pi;

/// A 10 mm steel ball on a flat steel wall.
FlashPair steel_ball() {
  const double b = effusivity(30, 7730, 460);
  return {0.005, 7730 * pi / 6 * 1e-6, 105e9 / 0.91, b, b};
}
double energy(const FlashPair& p, double speed) {
  return 0.5 * p.mass * speed * speed;
}

/// A Hertzian collision integrated in small steps: its maximum depth and its duration.
struct Collision {
  double depth = 0, time = 0;
};
Collision collide(const FlashPair& p, double speed) {
  const double stiff = 4.0 / 3 * p.modulus * std::sqrt(p.radius) / p.mass, dt = 1e-9;
  double x = 0, v = speed, half = 0;
  Collision c;
  while (x >= 0) {  // velocity Verlet
    c.depth = std::max(c.depth, x);
    half = v - 0.5 * dt * stiff * std::pow(x, 1.5);
    x += dt * half;
    v = half - 0.5 * dt * stiff * std::pow(std::max(x, 0.0), 1.5);
    c.time += dt;
  }
  return c;
}

/// A medium next to the plane where heat is released.
struct Medium {
  double conductivity, volumetric;  // [W/(m K)], [J/(m3 K)]
  double diffusivity() const { return conductivity / volumetric; }
  double effusivity() const { return std::sqrt(conductivity * volumetric); }
};

/// Temperature rise [K] after `time` of the plane between two half-spaces where `flux` [W/m2] is
/// released. Solves the heat equation by finite volumes, explicit in time, with `fine` cells per
/// diffusion length.
double plane(const Medium& one, const Medium& other, double flux, double time, int fine) {
  constexpr int lengths = 8;
  const int n = lengths * fine;
  const double dx1 = std::sqrt(one.diffusivity() * time) / fine;
  const double dx2 = std::sqrt(other.diffusivity() * time) / fine;
  std::vector<double> t1(n + 1), t2(n + 1);  // from the plane outwards; [0] is the plane in both
  const int steps = 4 * fine * fine;         // a quarter of dx^2/diffusivity
  const double dt = time / steps, middle = 0.5 * (one.volumetric * dx1 + other.volumetric * dx2);
  const auto inside = [&](std::vector<double>& t) {
    double last = t[0];
    for (int i = 1; i < n; ++i) {
      const double now = t[i];
      t[i] += 0.25 * (last - 2 * now + t[i + 1]);
      last = now;
    }
  };
  for (int step = 0; step < steps; ++step) {
    const double out1 = one.conductivity * (t1[0] - t1[1]) / dx1;
    const double out2 = other.conductivity * (t2[0] - t2[1]) / dx2;
    inside(t1);
    inside(t2);
    t1[0] = t2[0] = t1[0] + dt / middle * (flux - out1 - out2);
  }
  return t1[0];
}

TEST(Flash, hertz_by_its_formulas_is_hertz_followed_in_steps) {
  const FlashPair p = steel_ball();
  for (const double speed : {0.5, 3.0}) {
    const Collision c = collide(p, speed);
    const double area = pi * p.radius * c.depth, flux = 1 / (area * c.time);
    const double wanted = 2 * flux * std::sqrt(c.time / pi) / (2 * p.effusivity);
    states("rise over loss, over that of a followed collision",
           flash_factor(energy(p, speed), p) / wanted, 1, 0.5e-9 / c.time,
           "half a step of 1e-9 s, by which the end of contact is known");
  }
}

TEST(Flash, of_a_steel_ball_by_hand) {
  // 18.213 mJ at 3 m/s: depth 28.10 um, contact area 0.4414 mm2, duration 27.57 us.
  const FlashPair p = steel_ball();
  states("effusivity of 1.4034", p.effusivity, 10'328, 1, "sqrt(30 * 7730 * 460)");
  const double lost = 0.36 * energy(p, 3);  // restitution 0.8
  states("flash of an impact at 3 m/s that loses 36 % [K]", lost * flash_factor(energy(p, 3), p),
         0.36 * 0.018213 / (4.414e-7 * std::sqrt(pi * 27.57e-6) * 10'328), 0.05,
         "E/(area sqrt(pi t) b), four digits");
}

TEST(Flash, grows_as_hertz_says) {
  const FlashPair p = steel_ball();
  const double e = energy(p, 1);
  const auto exponent = [](double a, double b) { return std::log(b / a) / std::log(2.0); };
  states("exponent of the energy, at a given loss",
         exponent(flash_factor(e, p), flash_factor(2 * e, p)), -0.35, 1e-12, "-2/5 + 1/20");
  const auto with = [&](double FlashPair::*what) {
    FlashPair q = p;
    q.*what *= 2;
    return exponent(flash_factor(e, p), flash_factor(e, q));
  };
  states("of the radius", with(&FlashPair::radius), -0.8 + 0.1, 1e-12,
         "area R^(4/5), time R^(-1/5)");
  states("of the modulus", with(&FlashPair::modulus), 0.6, 1e-12, "area and time E^(-2/5)");
  states("of the mass", with(&FlashPair::mass), -0.25, 1e-12, "time m^(1/2)");
}

TEST(Flash, of_one_insulating_body_is_twice_that_of_two_alike) {
  FlashPair p = steel_ball();
  const double both = flash_factor(1e-3, p);
  p.other_effusivity = 1e-9 * p.effusivity;
  states("rise over that of two alike", flash_factor(1e-3, p) / both, 2, 3e-9, "all into one body");
  const double one = flash_factor(1e-3, p);
  p.other_effusivity = 1e9 * p.effusivity;
  states("rise beside a perfect conductor, over that", flash_factor(1e-3, p) / one, 0, 2e-9,
         "none");
}

TEST(Flash, is_nothing_where_nothing_was_pressed) {
  EXPECT_EQ(flash_factor(0, steel_ball()), 0);
}

TEST(Flash, is_what_the_heat_equation_says_of_two_half_spaces) {
  const Medium steel{30, 7730 * 460}, zirconia{2.5, 6000 * 450};
  FlashPair p = steel_ball();
  p.other_effusivity = zirconia.effusivity();
  const Collision c = collide(p, 3);
  const double flux = 1 / (pi * p.radius * c.depth * c.time);
  const double wanted = plane(steel, zirconia, flux, c.time, 40);
  const double coarse = plane(steel, zirconia, flux, c.time, 20);
  states("rise over loss, over that of the heat equation", flash_factor(energy(p, 3), p) / wanted,
         1, 2e-5 + std::abs(wanted - coarse) / wanted,
         "finite volumes; error below the change from a grid twice as coarse");
}

TEST(Flash, follows_the_root_of_time_on_a_half_space) {
  const Medium steel{30, 7730 * 460}, insulator{1e-9, 1};
  for (const double time : {1e-6, 1e-4, 1e-2}) {
    const double found = plane(steel, insulator, 1e6, time, 40);
    states("surface at " + std::to_string(time) + " s over 2 q sqrt(t/pi)/b",
           found * steel.effusivity() / (2e6 * std::sqrt(time / pi)), 1, 1.0 / 1600,
           "(dx/length)^2 of the grid");
  }
}

TEST(SoftenedDuration, of_an_impact_is_that_with_the_given_moduli) {
  const FlashPair hard = steel_ball();
  for (const double softening : {0.5, 0.12, 0.02, 1e-3}) {
    FlashPair soft = hard;
    soft.modulus *= softening;
    const double factor = softened_duration(softening);
    for (const double lasts : {1.0, 1.3, 1.9}) {  // times Hertz's time: dampers prolong an impact
      const double run = lasts * hertz_time(energy(hard, 2), soft);
      states("duration over Hertz's time",
             unsoftened_duration(run / hertz_time(energy(hard, 2), hard), factor), lasts,
             1e-12 * lasts, "t ~ E*^(-2/5), hea.11");
    }
    const double rest = 1e4;  // a ball that lies still, in Hertz's times
    states("duration of a long contact", unsoftened_duration(rest, factor), rest,
           impact_phase / factor, "only its impact is shorter");
  }
  for (const double lasts : {0.3, 1.0, 3.7, 1e5})
    EXPECT_EQ(unsoftened_duration(lasts, 1), std::max(1.0, lasts)) << "same bits unsoftened";
}

}  // namespace
}  // namespace mahlwerk::powder::flash_test
