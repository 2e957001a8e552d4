// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/powder/models.hpp"
#include "statement.hpp"

namespace mahlwerk::powder::capture_test {
namespace {

using tests::states;

/// Two 15 mm balls of Mhadhbi 2021, and a grain of its powder with an arbitrary strength.
const Nip nip{0.00375, 200e9 / (2 * (1 - 0.265 * 0.265))};
const Grain grain{40e-6, 4930, 1000};

/// Hertz's depth [m] at which the spring 4/3 E* R*^(1/2) x^(3/2) stores this energy, by bisection
/// of its integral, which is summed up in steps.
double hertz_depth(const Nip& n, double energy) {
  const auto stored = [&](double depth) {
    constexpr int steps = 200000;  // midpoint rule of x^1.5: relative error 1e-11
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += std::pow(depth * (i + 0.5) / steps, 1.5) * depth / steps;
    return 4.0 / 3 * n.modulus * std::sqrt(n.radius) * sum;
  };
  double low = 0, high = n.radius;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (stored(middle) < energy ? low : high) = middle;
  }
  return low;
}

TEST(Capture, radius_of_a_bed_that_does_not_yield_is_hertzs_radius_of_contact) {
  for (const double energy : {1e-6, 1e-3, 1.0}) {
    const double expected = std::sqrt(nip.radius * hertz_depth(nip, energy));
    states("capture radius at " + std::to_string(energy) + " J", capture_radius(nip, energy, 0),
           expected, 1e-9 * expected, "a^2 = R* x, x from the spring's work; physics 4.1");
  }
}

TEST(Capture, spot_of_a_bed_is_where_a_ball_is_no_higher_than_the_bed) {
  // A sphere of radius K_g is pressed into a plane by D: at the edge of the spot its surface is at
  // the height D.
  for (const double depth : {1e-6, 1e-4, 3e-3}) {
    const double r = capture_radius(nip, 0, depth);
    states("height of the ball at the edge",
           nip.radius - std::sqrt(nip.radius * nip.radius - r * r), depth, 1e-12,
           "geometry; tolerance: rounding of differences of 4 mm");
  }
  states("a bed deeper than the ball's radius", capture_radius(nip, 0, 1), nip.radius, 1e-18,
         "no more than the ball");
}

TEST(Capture, number_of_grains_goes_over_into_one_without_a_jump) {
  states("just below", grains_in_bed(0.5 * (1 - 1e-12), 1), 1, 0, "(cap.5)");
  states("just above", grains_in_bed(0.5 * (1 + 1e-12), 1), 1, 1e-11, "(cap.5)");
  states("many grains, share of the area", grains_in_bed(1e4, 1) / 4e8, 0.75, 1e-8,
         "(cap.5); hexagonal packing would be 0.907");
}

TEST(Capture, deformation_has_the_limits_of_mhadhbis_equation_16) {
  states("at endless energy", bed_deformation(1e30), 0.362, 1e-15, "Mhadhbi 2021 eq. 16");
  const double little = 1e-12;
  const double expected = 0.362 * 0.152 * std::pow(little, 0.413);
  states("at little energy", bed_deformation(little), expected, expected * 1e-6,
         "first term of the series; the next is 8e-7 of it");
  EXPECT_EQ(bed_deformation(0), 0);
}

TEST(Capture, barrios_bed_yields_by_the_energy_that_its_own_mass_gets) {
  for (const double size : {1e-6, 40e-6, 1e-3, 6e-3})
    for (const double strength : {1.0, 1e3, 1e6})
      for (double energy = 1e-9; energy < 10; energy *= 10) {
        const Grain g{size, 4930, strength};
        const Capture c = Barrios{strength}.capture(nip, energy, g);
        const double by_mass = energy / (c.grains * g.mass());
        const double radius =
            capture_radius(nip, energy, size * bed_deformation(by_mass / strength));
        // The root is found to 1e-13 in the deformation; the chord's slope is K_g/chord.
        const double slope =
            size * nip.radius / std::max(c.radius - contact_radius(nip, energy), 1e-9);
        EXPECT_NEAR(c.radius, radius, 1e-11 * radius + 1e-12 * slope)
            << size << " m, " << strength << " J/kg, " << energy << " J";
        EXPECT_EQ(c.probability, 1);
        EXPECT_GE(c.grains, 1);
      }
}

TEST(Capture, strength_of_the_grains_moves_the_catch_between_two_bounds_only) {
  const double energy = 0.01;
  const double least = grains_in_bed(contact_radius(nip, energy), grain.size);
  const double most = grains_in_bed(capture_radius(nip, energy, 0.362 * grain.size), grain.size);
  double last = most * (1 + 1e-12);
  for (double strength = 1e-6; strength < 1e12; strength *= 10) {
    const double found =
        Barrios{strength}.capture(nip, energy, {grain.size, grain.density, strength}).grains;
    EXPECT_LE(found, last);
    EXPECT_GE(found, least * (1 - 1e-12));
    last = found;
  }
}

TEST(Capture, mass_below_one_grain_is_a_grain_now_and_then) {
  const double mass = 0.25 * grain.mass();
  const Capture some = FixedMass{mass}.capture(nip, 1e-3, grain);
  states("chance", some.probability, 0.25, 1e-15, "mass over that of a grain");
  states("grains", some.grains, 1, 0, "whole ones");
  states("mean mass", some.mean_mass(grain), mass, 1e-15 * mass, "kept");
  const Capture layer = TrappedVolume{1e-4, 0.6}.capture(nip, 1e-3, grain);
  const double a = contact_radius(nip, 1e-3);
  const double expected = 0.6 * 4930 * std::numbers::pi * a * a * 1e-4;
  states("trapped volume", layer.mean_mass(grain), expected, 1e-14 * expected,
         "pi a^2 h_0; physics 4.2");
  const Capture coat = SurfaceLayer{0.3}.capture(nip, 1e-3, grain);
  states("surface layer", coat.mean_mass(grain), 0.6 * std::numbers::pi * a * a,
         1e-14 * coat.mean_mass(grain), "2 sigma pi R_h^2; physics 4.2");
}

}  // namespace
}  // namespace mahlwerk::powder::capture_test
