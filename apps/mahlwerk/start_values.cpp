// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "start_values.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace mahlwerk::app {
namespace {

constexpr auto start_values = std::to_array<StartValue>({
    {"vibration", "frequency", "25 Hz"},
    {"vibration", "amplitude", "5 mm"},
    {"planetary", "orbit_radius", "100 mm"},
    {"planetary", "speed", "300 rpm"},
    {"planetary", "ratio", "1:-2"},
    {"tumbling", "speed", "70 %"},
    {"arc-shaker", "frequency", "25 Hz"},
    {"arc-shaker", "arm", "136 mm"},
    {"arc-shaker", "swing", "3.8 deg"},
    {"figure-eight", "frequency", "17.5 Hz"},
    {"figure-eight", "stroke_along", "30 mm"},
    {"figure-eight", "stroke_across", "12.5 mm"},
    {"circular", "radius", "15 mm"},
    {"circular", "speed", "1000 rpm"},
    {"sphere", "diameter", "40 mm"},
    {"capsule", "diameter", "20 mm"},
    {"capsule", "height", "25 mm"},
    {"cylinder", "diameter", "50 mm"},
    {"cylinder", "height", "50 mm"},
    {"rounded-cylinder", "diameter", "50 mm"},
    {"rounded-cylinder", "height", "50 mm"},
    {"rounded-cylinder", "fillet", "8 mm"},
    {"box", "width", "50 mm"},
    {"box", "depth", "50 mm"},
    {"box", "height", "50 mm"},
    {"periodic_box", "width", "50 mm"},
    {"periodic_box", "depth", "50 mm"},
    {"periodic_box", "height", "50 mm"},
    {"periodic_cylinder", "diameter", "200 mm"},
    {"periodic_cylinder", "length", "100 mm"},
    {"lifter_cylinder", "diameter", "200 mm"},
    {"lifter_cylinder", "height", "100 mm"},
    {"lifter_cylinder", "lifters", "8"},
    {"lifter_cylinder", "lifter_height", "10 mm"},
    {"lifter_cylinder", "lifter_width", "15 mm"},
    {"attritor", "diameter", "100 mm"},
    {"attritor", "height", "120 mm"},
    {"attritor", "shaft_diameter", "20 mm"},
    {"attritor", "shaft_clearance", "10 mm"},
    {"attritor", "arms", "4"},
    {"attritor", "arm_diameter", "8 mm"},
    {"attritor", "arm_span", "80 mm"},
    {"attritor", "arm_clearance", "20 mm"},
    {"attritor", "arm_spacing", "20 mm"},
    {"attritor", "rotor_speed", "300 rpm"},
    {"mesh", "unit", "mm"},
});

}  // namespace

std::string_view start_value(std::string_view kind, std::string_view key) {
  for (const StartValue& v : start_values)
    if (v.kind == kind && v.key == key) return v.value;
  return {};
}

std::string_view start_jar(std::string_view mill_kind) {
  return mill_kind == "arc-shaker" ? "capsule" : "cylinder";
}

StartBalls start_balls(std::string_view jar_kind) {
  if (jar_kind == "periodic_cylinder" || jar_kind == "lifter_cylinder")
    return {"20 mm", "filling", "15 %"};
  if (jar_kind == "attritor") return {"10 mm", "filling", "20 %"};
  return {"8 mm", "count", "10"};
}

// A circle of 20 mm in 0.1 s, without a turn of the jar.
std::string sample_motion() {
  constexpr int rows = 40;
  constexpr double radius = 0.02, period = 0.1;  // [m], [s]
  std::string text = "time_s,x_m,y_m,z_m\n";
  for (int i = 0; i <= rows; ++i) {
    const double turn = static_cast<double>(i % rows) / rows, angle = 2 * std::numbers::pi * turn;
    text += fmt::format("{:.6f},{:.9f},{:.9f},0\n", period * i / rows, radius * std::cos(angle),
                        radius * std::sin(angle));
  }
  return text;
}

// A cube of 50 mm as twelve triangles whose normals point outwards.
std::string sample_surface() {
  constexpr double half = 25;  // [mm]
  std::string text = "solid jar\n";
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-half, half}) {
      const auto corner = [&](double u, double v) {
        std::array<double, 3> p{};
        const auto at = [&](int i) -> double& { return p[static_cast<std::size_t>(i % 3)]; };
        at(axis) = side;
        at(axis + 1) = u;
        at(axis + 2) = v;
        return fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
      };
      const double w = side > 0 ? half : -half;  // reverses the order of the corners
      const std::string a = corner(-w, -half), b = corner(w, -half), c = corner(w, half),
                        d = corner(-w, half);
      for (const auto& [second, third] : {std::pair{b, c}, std::pair{c, d}})
        text += "facet normal 0 0 0\nouter loop\n" + a + second + third + "endloop\nendfacet\n";
    }
  return text + "endsolid jar\n";
}

}  // namespace mahlwerk::app
