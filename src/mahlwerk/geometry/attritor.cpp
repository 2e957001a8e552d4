// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/attritor.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::geometry {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

Vec3 Attritor::normal_rate(int face, const Vec3& p, const Vec3& v) const {
  if (face < first_rotor_face) return vessel().normal_rate(face, p, v);
  Vec3 e, u = v;
  if (face == first_rotor_face) {
    if (p.z < shaft_clearance - 0.5 * height) return {};  // flat end with a sharp rim
    e = {p.x, p.y, 0}, u.z = 0;
  } else {
    e = from_core(face, p);
    if (e.x == 0) u.x = 0;  // no curvature along the arm's axis
    if (e.y == 0) u.y = 0;
  }
  return squared(e) > 0 ? -rate_about_core(e, u) : Vec3{};
}

/// The vessel less the shaft and the parts of the arms outside the shaft (geo.16).
double Attritor::volume() const {
  const double shaft = 0.5 * shaft_diameter, arm = 0.5 * arm_diameter;
  const double whole = pi * arm * arm * (arm_span - arm_diameter) + 4 * pi / 3 * arm * arm * arm;
  // Two cylinders that cross at right angles, by Gauss-Chebyshev quadrature: the integral over y of
  // 4 sqrt(shaft^2 - y^2) sqrt(arm^2 - y^2) from -arm to arm.
  constexpr int nodes = 64;
  double crossing = 0;
  for (int k = 1; k <= nodes; ++k) {
    const double angle = k * pi / (nodes + 1), y = arm * math::cos(angle), s = math::sin(angle);
    crossing += pi / (nodes + 1) * s * s * arm * arm * 4 * std::sqrt(shaft * shaft - y * y);
  }
  return vessel().volume() - pi * shaft * shaft * (height - shaft_clearance) -
         arms * (whole - crossing);
}

/// Centre and radius of the largest ball that fits at any angle of the stirrer: beside the stirrer,
/// below it, or above its arms.
std::pair<Vec3, double> Attritor::largest_ball() const {
  const double beside = 0.25 * (diameter - 2 * rotor_reach());
  const double lowest = std::min(shaft_clearance, arm_clearance - 0.5 * arm_diameter);
  const double above = height - arm_clearance - (arms - 1) * arm_spacing - 0.5 * arm_diameter;
  const double room = 0.25 * (diameter - shaft_diameter);
  const double below = 0.5 * std::min(lowest, diameter), over = std::min(0.5 * above, room);
  const double half = 0.5 * height;
  std::pair<Vec3, double> best{{0, 0, below - half}, below};
  if (over > best.second) best = {{0.25 * (diameter + shaft_diameter), 0, half - over}, over};
  const double side = std::min(beside, half);
  if (side > best.second) best = {{0.5 * diameter - side, 0, 0}, side};
  return best;
}

std::string Attritor::flaw() const {
  const double top = arm_clearance + (arms - 1) * arm_spacing + 0.5 * arm_diameter;
  if (arms != std::floor(arms)) return "arms must be a whole number";
  if (arm_span >= diameter) return "the arms are longer than the vessel is wide";
  if (arm_span <= shaft_diameter + arm_diameter) return "the arms do not stand out of the shaft";
  if (arm_diameter >= shaft_diameter) return "the arms are thicker than the shaft they go through";
  if (arm_clearance <= 0.5 * arm_diameter) return "the lowest arm touches the bottom";
  if (shaft_clearance > arm_clearance - 0.5 * arm_diameter)
    return "the shaft ends above the lowest arm";
  if (arms > 1 && arm_spacing <= arm_diameter) return "the arms touch each other";
  if (top >= height) return "the arms reach above the vessel";
  return "";
}

}  // namespace mahlwerk::geometry
