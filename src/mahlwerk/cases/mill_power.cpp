// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/mill_power.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double pi = std::numbers::pi, gravity = 9.81, tonne = 1000, kilowatt = 1000;

/// [m] Length of a drum or of a slice of one; 0 for other shapes.
double drum_length(const geometry::AnyShape& shape) {
  return std::visit(
      [](const auto& s) -> double {
        if constexpr (requires { s.diameter, s.length; })
          return s.length;
        else if constexpr (requires { s.diameter, s.height, s.rotor_speed; })
          return 0;
        else if constexpr (requires { s.diameter, s.height; })
          return s.height;
        else
          return 0;
      },
      shape);
}

/// A share as "73.4 %".
std::string percent_text(double share) {
  return fmt::format("{:.4g} %", 100 * share);
}

}  // namespace

bool FormulaRange::has(const MillNumbers& m) const {
  constexpr double rounding = 1e-9;  // of a speed or filling that a case gives as a limit
  const auto within = [](double x, double least, double most) {
    return x >= least - rounding && x <= most + rounding;
  };
  return within(m.speed, least_speed, most_speed) && within(m.filling, least_filling, most_filling);
}

double bond_power(const MillNumbers& m, double mass) {
  const double cascade = 1 - 0.1 / math::pow(2, 9 - 10 * m.speed);
  return kilowatt * mass / tonne * 4.879 * math::pow(m.diameter, 0.3) * (3.2 - 3 * m.filling) *
         m.speed * cascade;
}

double hogg_fuerstenau_power(const MillNumbers& m, double lift_angle) {
  constexpr double in_ft = 1 / 0.3048;
  return kilowatt * 0.238 * math::pow(in_ft * m.diameter, 2.5) * in_ft * m.length * m.speed *
         (m.density / tonne) * m.filling * (1 - 1.065 * m.filling) * math::sin(lift_angle);
}

MorrellCharge morrell_charge(const MillNumbers& m) {
  const double j = m.filling, phi = m.speed, rm = 0.5 * m.diameter;
  const double turns = phi * std::sqrt(2 * gravity / m.diameter) / (2 * pi);  // per second
  const double critical = std::max(phi, 0.35 * (3.364 - j));
  MorrellCharge c;
  c.toe = 2.5307 * (1.2796 - j) * (1 - math::exp(-19.42 * (critical - phi))) + 0.5 * pi;
  c.shoulder = 0.5 * pi - (c.toe - 0.5 * pi) * (0.3386 + 0.1041 * phi + (1.54 - 2.5673 * phi) * j);
  const double arc = 2 * pi + c.shoulder - c.toe, lift = math::sin(c.shoulder) - math::sin(c.toe);
  const double mean_radius = 0.5 * rm * (1 + std::sqrt(std::max(0.0, 1 - 2 * pi * j / arc)));
  const double in_charge = arc / (2 * pi * 0.5 * turns);
  const double in_flight = std::sqrt(std::max(0.0, 2 * mean_radius * lift / gravity));
  const double share = in_charge / (in_flight + in_charge);
  const double ri = rm * std::sqrt(std::max(0.0, 1 - 2 * pi * share * j / arc));
  const double z = math::pow(1 - j, 0.4532), effective = rm - z * ri;
  c.inner_radius = ri;
  c.power = pi * gravity * m.length * turns * m.density * rm / (3 * effective) *
                (2 * rm * rm * rm - 3 * z * rm * rm * ri + ri * ri * ri * (3 * z - 2)) * lift +
            m.length * m.density * math::pow(turns * rm * pi / effective, 3) *
                (math::pow(effective, 4) - math::pow(ri, 4) * math::pow(z - 1, 4));
  return c;
}

double morrell_no_load_power(const MillNumbers& m) {
  return kilowatt * 1.68 * math::pow(m.diameter, 2.05) * math::pow(m.speed * m.length, 0.82);
}

std::optional<MillNumbers> mill_numbers(const Case& c) {
  const kinematics::Tumbling* drum = drum_motion(c);
  const std::vector<BallSet> balls = sets_at_start(c);
  if (drum == nullptr || drum->speed == 0 || !(c.gravity > 0) || balls_mass(balls) == 0)
    return std::nullopt;
  MillNumbers m;
  m.diameter = 2 * geometry::radius_about_axis(*c.jar.shape);
  m.length = drum_length(*c.jar.shape);
  m.speed = std::abs(drum->speed) / std::sqrt(2 * across_axis(c.gravity_vector()) / m.diameter);
  m.filling = bulk_filling(balls, c.jar);
  m.density = bulk_density(balls);
  if (!(m.length > 0) || !std::isfinite(m.speed) || !(m.filling > 0) || m.filling > 0.6)
    return std::nullopt;
  return m;
}

bool may_hold(const FormulaRange& range, const Case& c) {
  std::optional<MillNumbers> mill = mill_numbers(c);
  if (mill && speed_varies(c)) mill->speed = range.least_speed;
  return mill && range.has(*mill);
}

Notices mill_power_notices(const Case& c, std::optional<double> rate) {
  std::optional<MillNumbers> mill = mill_numbers(c);
  if (!mill) return {};
  mill->speed *= rate.value_or(1);
  std::string missing;
  for (const FormulaRange& range : formula_ranges)
    if (!range.has(*mill))
      missing += fmt::format(
          "{}{} ({}) is given for a speed of {:.0f} to {:.0f} % and a filling of "
          "{:.0f} to {:.0f} %",
          missing.empty() ? "" : ", ", range.name, range.quantity, 100 * range.least_speed,
          100 * range.most_speed, 100 * range.least_filling, 100 * range.most_filling);
  if (missing.empty()) return {};
  return {
      note("formula-out-of-range",
           fmt::format("Formulas of mill power that do not hold for this mill have no value. It "
                       "turns at {} of the critical speed of its shell{}, and its charge fills {} "
                       "of it in bulk; {}.",
                       percent_text(mill->speed),
                       rate || !speed_varies(c) ? ""
                       : c.drive                ? " without load"
                                                : " at full speed",
                       percent_text(mill->filling), missing))};
}

}  // namespace mahlwerk::cases
