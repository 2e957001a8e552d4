// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The last five of the eight tests of Chung and Ooi (2011): collisions with slip and spin. Gross
// slip has closed forms for a ball of constant radius. The contact point of the engine lies one
// overlap deeper. Its lever, and with it the gained spin, is smaller by the fraction `shorter` at
// most.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::chung_ooi_oblique_test {
namespace {

using contact::HertzMindlin;
using contact::HertzTsuji;
constexpr double share = 1.0 / 400;  // time step over contact time
const std::string source = "gross slip, rigid; Chung and Ooi 2011";

double shorter(const Impact& found) {
  return found.energy_balance.deepest_overlap;
}
/// Lever over radius, with the mean overlap weighted by the force: 0.81756 of the deepest overlap
/// in an elastic Hertz collision, B(7/5, 1/2) / B(1, 1/2).
double mean_lever(const Impact& found) {
  return 1 - 0.81756 * found.energy_balance.deepest_overlap;
}

struct Oblique {
  Impact impact;
  double kept;     ///< [1] v_t' / v_t
  double spin;     ///< [rad/s] after
  double rebound;  ///< [rad] of the contact point, from the normal
};

Oblique slide(const contact::ElasticConstants& of, double density, double radius,
              const Vec3& velocity, double e, double mu, const contact::AnyLaw& law,
              double steps = share) {
  Oblique o{
      impact({{radius, density, {}, velocity, {}}}, pair_of(of, rigid, e, mu), of_law(law), steps),
      0, 0, 0};
  const scene::Ball& after = o.impact.after[0];
  o.kept = after.velocity.x / velocity.x;
  o.spin = after.spin.y;
  o.rebound = std::atan2(after.velocity.x - radius * after.spin.y, after.velocity.z);
  return o;
}

Vec3 at_angle(double speed, double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return {speed * std::sin(a), 0, -speed * std::cos(a)};
}

/// A ball on a plane: speeds towards and along it [m/s], spin [rad/s].
struct Plane {
  double u = 0, v = 0, w = 0;
};
/// Independent integration of the same collision, in its plane and in far smaller steps. With
/// `as_in_sheet`, as in the reference sheet below: the lever is the whole radius, and at the
/// friction limit the spring is set to the remainder of the limit force after the dashpot force,
/// even where the dashpot acts with the spring and the spring is wound backwards. Otherwise as in
/// the engine: neither.
Plane apart(double density, const contact::Pair& pair, double r, Plane p, bool as_in_sheet) {
  const double m = scene::Ball{r, density, {}, {}, {}}.mass(), turn = 0.4 * m * r * r;
  const double b = contact::damping_ratio(pair.restitution), k = -2 * std::sqrt(5.0 / 6.0) * b;
  const double dt = 1e-5 * contact::hertz_time({pair, r, m}, p.u);
  double spring = 0;
  for (double depth = p.u * dt; depth > 0; depth += p.u * dt) {
    const double a = std::sqrt(r * depth), lever = as_in_sheet ? r : r - depth,
                 slip = p.v - lever * p.w;
    const double along = 2 * pair.modulus * a, across = 8 * pair.shear_modulus * a;
    const double push = 4.0 / 3.0 * pair.modulus * a * depth + k * std::sqrt(along * m) * p.u;
    const double dashpot = k * std::sqrt(across * m) * slip, most = pair.friction * std::abs(push);
    spring += slip * dt;
    double rub = -across * spring - dashpot;
    if (std::abs(rub) > most) {
      rub = std::copysign(most, rub);
      const double held =
          (most + std::max(0.0, -std::copysign(dashpot, dashpot * spring))) / across;
      spring = as_in_sheet ? -(rub + dashpot) / across : std::clamp(spring, -held, held);
    }
    p.u -= push / m * dt;
    p.v += rub / m * dt;
    p.w -= rub * lever / turn * dt;
  }
  return {-p.u, p.v, p.w};
}
Oblique apart(double density, const contact::Pair& pair, double r, const Vec3& start,
              bool as_in_sheet) {
  const Plane p = apart(density, pair, r, Plane{-start.z, start.x, 0}, as_in_sheet);
  return {{}, p.v / start.x, p.w, std::atan2(p.v - r * p.w, p.u)};
}

/// Below 30 degrees the history of the tangential spring determines the result.
TEST(ChungOoi, test_4_oblique_at_constant_speed_as_integrated_apart) {
  const double mu = 0.092, degree = std::numbers::pi / 180;
  const contact::ElasticConstants oxide{380e9, 0.23};
  const contact::Pair pair = pair_of(oxide, rigid, 0.98, mu);
  struct Row {
    double angle, kept, spin, rebound;
  };
  for (const Row& row :
       {Row{5, 0.9476, 17.8, 4.17}, Row{10, 0.7024, 201.6, -0.43}, Row{20, 0.6225, 503.6, -6.81},
        Row{30, 0.6845, 615.2, -3.51}, Row{40, 0.7829, 544.2, 11.62}, Row{60, 0.8948, 355.2, 48.16},
        Row{80, 0.9679, 123.4, 78.98}}) {
    const Vec3 v = at_angle(3.9, row.angle);
    const std::string at = " at " + std::to_string(static_cast<int>(row.angle)) + " deg";
    const Oblique sheet = apart(4000, pair, 0.0025, v, true);
    const std::string of_sheet = "reference sheet, its steps coarser than here";
    states("sheet: e_t" + at, sheet.kept, row.kept, 4e-4, of_sheet);
    states("sheet: spin after [rad/s]" + at, sheet.spin, row.spin, 0.3, of_sheet);
    states("sheet: rebound [deg]" + at, sheet.rebound / degree, row.rebound, 0.02, of_sheet);
    const Oblique own = apart(4000, pair, 0.0025, v, false);
    const Oblique o = slide(oxide, 4000, 0.0025, v, 0.98, mu, HertzMindlin{}, 1.0 / 4000);
    const std::string here = "integrated apart, the engine's lever and spring";
    states("e_t" + at, o.kept, own.kept, 1e-3, here);
    states("spin after [rad/s]" + at, o.spin, own.spin, 1e-3 * 2.5 * norm(v) / 0.0025, here);
    states("rebound [deg]" + at, o.rebound / degree, own.rebound / degree, 0.06, here);
  }
}

TEST(ChungOoi, test_4_oblique_beyond_onset_slips_as_in_closed_form) {
  const double e = 0.98, mu = 0.092, radius = 0.0025, speed = 3.9, beta = contact::damping_ratio(e);
  const auto run = [&](const std::string& what, const contact::ElasticConstants& of, double density,
                       const contact::AnyLaw& law, double tail) {
    for (const double angle : {35.0, 45.0, 60.0, 75.0, 85.0}) {
      const Vec3 v = at_angle(speed, angle);
      const Oblique o = slide(of, density, radius, v, e, mu, law);
      const std::string at = what + " at " + std::to_string(static_cast<int>(angle)) + " deg";
      const double slope = std::tan(angle * std::numbers::pi / 180), total = 1 + e + tail;
      const double lost = mu * total / slope, gained = 2.5 * mu * total * -v.z / radius;
      states("e_t, " + at, o.kept, 1 - lost, 1e-4 * lost, source);
      states("spin after [rad/s], " + at, o.spin, gained, (1e-4 + shorter(o.impact)) * gained,
             source);
    }
  };
  run("oxide, tsuji", {380e9, 0.23}, 4000, HertzTsuji{}, 0);
  run("alloy, tsuji", {70e9, 0.33}, 2700, HertzTsuji{}, 0);
  // At its end a damped contact pulls. Its friction is as large as for a push of the same size. For
  // x'' = -x^1.5 - c x^0.25 x' the impulse of this tail is 2/5 c^2, c = sqrt(5) beta. It counts
  // twice against the normal impulse.
  run("oxide, mindlin", {380e9, 0.23}, 4000, HertzMindlin{}, 4 * beta * beta);
}

TEST(ChungOoi, test_5_oblique_at_constant_normal_speed) {
  const double mu = 0.3, radius = 0.01, vn = 5;
  const auto run = [&](const std::string& what, const contact::ElasticConstants& of,
                       double density) {
    for (const double vt : {12.0, 15.0, 18.0, 21.0}) {  // gross slip from vt = 7 mu vn = 10.5 on
      const Oblique o = slide(of, density, radius, {vt, 0, -vn}, 1, mu, HertzMindlin{});
      const scene::Ball& after = o.impact.after[0];
      const double psi1 = vt / vn / mu, lever = mean_lever(o.impact);
      const std::string at = what + ", v_t " + std::to_string(static_cast<int>(vt)) + " m/s";
      states("psi2 - psi1, " + at, std::tan(o.rebound) / mu - psi1, -2 - 5 * lever, 7e-3,
             "-7, lever R less the mean overlap; Chung and Ooi 2011");
      states("spin R/(mu v_n), " + at, after.spin.y * radius / (mu * vn), 5 * lever, 5e-3,
             "5, lever R less the mean overlap; Chung and Ooi 2011");
    }
  };
  run("steel", {208e9, 0.30}, 7850);
  run("polyethylene", {1e9, 0.40}, 1400);
}

/// Collisions in which the contact sticks for a part of the time, compared with the independent
/// integration, at the usual step and at an eighth of it. Runs use the usual step: 1 %.
void states_stuck(const std::string& what, const contact::ElasticConstants& of, double density,
                  double r, double e, double mu, const Plane& start) {
  const contact::Pair pair = pair_of(of, rigid, e, mu);
  const Plane own = apart(density, pair, r, start, false);
  for (const double steps : {50.0, 400.0}) {
    const Impact found = impact({{r, density, {}, {start.v, 0, -start.u}, {0, start.w, 0}}}, pair,
                                of_law(HertzMindlin{}), 1 / steps);
    const scene::Ball& after = found.after[0];
    const double tolerance = steps > 50 ? 1e-3 : 1e-2;
    const double slip = std::abs(start.v - r * start.w);  // all that friction can change
    const std::string at = what + fmt::format(", {} steps", steps);
    const std::string here = "integrated apart; of the slip before";
    states("speed along the plane, " + at, after.velocity.x / slip, own.v / slip, tolerance / 3.5,
           here);
    states("R w, " + at, r * after.spin.y / slip, r * own.w / slip, tolerance * 2.5 / 3.5, here);
  }
}

TEST(ChungOoi, test_5_where_the_contact_sticks_as_integrated_apart) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of,
                      double density) {
    for (const double vt : {0.1, 1.0, 2.0, 4.0, 6.0, 8.0, 10.0})
      states_stuck(fmt::format("{}, v_t {} m/s", what, vt), of, density, 0.01, 1, 0.3, {5, vt, 0});
  };
  run("steel", {208e9, 0.30}, 7850);
  run("polyethylene", {1e9, 0.40}, 1400);
}

TEST(ChungOoi, test_6_where_the_contact_sticks_as_integrated_apart) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of,
                      double density) {
    for (const double w : {0.175, 1.0, 2.0, 3.0, 4.0, 5.0})
      states_stuck(fmt::format("{}, {} rad/s", what, w), of, density, 0.1, 0.5, 0.4, {0.2, 0, w});
  };
  run("alloy", {70e9, 0.33}, 2700);
  run("nylon", {2.5e9, 0.40}, 1000);
}

const contact::ElasticConstants alloy{70e9, 0.33}, nylon{2.5e9, 0.40}, copper{120e9, 0.35};
constexpr double e = 0.5, mu = 0.4, radius = 0.1, vn = 0.2;
constexpr double slipped = mu * (1 + e) * vn;  // [m/s] gain of a ball in gross slip

void states_spun(const std::string& what, const Impact& found, double w, double gained) {
  const scene::Ball& after = found.after[0];
  const double turned = 2.5 * slipped / radius;
  states("speed gained [m/s], " + what, gained, slipped, 1e-3 * slipped, source);
  states("spin lost [rad/s], " + what, w - std::abs(after.spin.y), turned,
         (1e-3 + shorter(found)) * turned, source);
  const double left = radius * w - 3.5 * slipped;
  states("slip after [m/s], " + what, radius * std::abs(after.spin.y) - gained, left,
         (1e-3 + shorter(found)) * 3.5 * slipped, source);
}

TEST(ChungOoi, test_6_a_spinning_sphere_falls_onto_a_plane) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of,
                      double density) {
    for (const double w : {6.0, 12.0, 21.0}) {  // gross slip from 7/2 slipped / R = 4.2 rad/s on
      const Impact found = impact({{radius, density, {}, {0, 0, -vn}, {0, w, 0}}},
                                  pair_of(of, rigid, e, mu), of_law(HertzTsuji{}), share);
      states_spun(what + ", " + std::to_string(static_cast<int>(w)) + " rad/s", found, w,
                  found.after[0].velocity.x);
    }
  };
  run("alloy", alloy, 2700);
  run("nylon", nylon, 1000);
}

TEST(ChungOoi, test_7_two_equal_spinning_spheres) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of,
                      double density) {
    for (const double w : {6.0, 21.0}) {
      std::vector<scene::Ball> balls(2, {radius, density, {}, {vn, 0, 0}, {0, w, 0}});
      balls[1].velocity = -balls[0].velocity;
      const Impact found = impact(balls, pair_of(of, of, e, mu), of_law(HertzTsuji{}), share);
      const std::string at = what + ", " + std::to_string(static_cast<int>(w)) + " rad/s";
      states_spun(at, found, w, found.after[0].velocity.z);
      stays_below("speeds are opposite [m/s], " + at,
                  norm(found.after[0].velocity + found.after[1].velocity), 1e-14, "symmetry");
      // Balls with opposite spins roll like gears, without friction.
      balls[1].spin = -balls[0].spin;
      const Impact gears = impact(balls, pair_of(of, of, e, mu), of_law(HertzTsuji{}), share);
      stays_below("spin changed by gears [rad/s], " + at, norm(gears.after[0].spin - balls[0].spin),
                  1e-12, "symmetry");
    }
  };
  run("alloy", alloy, 2700);
  run("copper", copper, 8900);
}

TEST(ChungOoi, test_8_a_spinning_sphere_falls_onto_a_far_heavier_one) {
  const auto run = [](const std::string& what, const contact::ElasticConstants& of,
                      double density) {
    for (const double w : {6.0, 21.0}) {
      const std::vector<scene::Ball> balls{{radius, density, {}, {vn, 0, 0}, {0, w, 0}},
                                           {5 * radius, 1000 * density, {}, {}, {}}};
      const Impact found = impact(balls, pair_of(of, of, e, mu), of_law(HertzTsuji{}), share);
      states_spun(what + ", " + std::to_string(static_cast<int>(w)) + " rad/s", found, w,
                  found.after[0].velocity.z);
    }
  };
  run("alloy", alloy, 2700);
  run("nylon", nylon, 1000);
}

}  // namespace
}  // namespace mahlwerk::tests::chung_ooi_oblique_test
