// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The first three of the eight tests of Chung and Ooi (2011): collisions along the normal.
#include <gtest/gtest.h>

#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::chung_ooi_test {
namespace {

using contact::HertzMindlin;
constexpr double share = 1.0 / 200;  // time step over contact time

/// Largest overlap [m], force [N] and duration [s] of an elastic collision, by hand from Hertz.
struct Hertz {
  double overlap, force, time;
};

void states_hertz(const std::string& what, const Impact& found, const contact::Pair& pair,
                  const Hertz& expected) {
  const contact::HertzMindlin law;
  const auto coefficients =
      law.coefficients(touching(pair, found.before), law.damping(pair.restitution));
  double memory[contact::law_history_size] = {};
  const double force =
      contact::HertzMindlin::evaluate<double>(coefficients.data(), memory, found.deepest, 0).force;
  const std::string source = "Hertz; Chung and Ooi 2011";
  states(what + ", deepest overlap [m]", found.deepest, expected.overlap, 1e-3 * expected.overlap,
         source);
  states(what + ", largest force [N]", force, expected.force, 1e-3 * expected.force, source);
  states(what + ", duration [s]", found.duration, expected.time, 1e-3 * expected.time, source);
  states(what + ", e", found.restitution, 1, 1e-3, source);
}

TEST(ChungOoi, test_1_two_equal_spheres_along_the_normal) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of, double density,
                      const Hertz& expected) {
    std::vector<scene::Ball> balls(2, {0.01, density, {}, {}, {}});
    balls[0].velocity = {10, 0, 0};
    balls[1].velocity = {-10, 0, 0};
    const contact::Pair pair = pair_of(of, of, 1, 0.35);
    states_hertz(what, impact(balls, pair, of_law(HertzMindlin{}), share), pair, expected);
  };
  run("glass", {48e9, 0.20}, 2800, {2.7411e-4, 1.06969e4, 4.0339e-5});
  run("limestone", {20e9, 0.25}, 2500, {3.6830e-4, 7.1082e3, 5.4201e-5});
}

TEST(ChungOoi, test_2_a_sphere_on_a_rigid_plane) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of, double density,
                      const Hertz& expected) {
    const contact::Pair pair = pair_of(of, rigid, 1);
    const Impact found =
        impact({{0.1, density, {}, {0, 0, -0.2}, {}}}, pair, of_law(HertzMindlin{}), share);
    states_hertz(what, found, pair, expected);
  };
  run("aluminium alloy", {70e9, 0.30}, 2699, {4.9717e-5, 1.13699e4, 7.3166e-4});
  run("magnesium alloy", {40e9, 0.35}, 1800, {5.2123e-5, 7.2327e3, 7.6707e-4});
}

TEST(ChungOoi, test_3_damped_along_the_normal) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of, double density,
                      const Hertz& elastic) {
    for (const double e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      const contact::Pair pair = pair_of(of, rigid, e);
      const Impact found =
          impact({{0.0025, density, {}, {0, 0, -3.9}, {}}}, pair, of_law(HertzMindlin{}), share);
      if (e == 1) states_hertz(what, found, pair, elastic);
      states(what + ", e", found.restitution, e, 1e-3, "e asked; Chung and Ooi 2011");
    }
  };
  run("aluminium oxide", {380e9, 0.23}, 4000, {8.0888e-6, 615.35, 6.1045e-6});
  run("cast iron", {100e9, 0.25}, 7000, {1.71887e-5, 506.76, 1.29721e-5});
}

}  // namespace
}  // namespace mahlwerk::tests::chung_ooi_test
