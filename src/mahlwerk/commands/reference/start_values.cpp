// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/start_values.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

#include "mahlwerk/base/trig.hpp"

namespace mahlwerk::commands {

std::string_view start_jar(std::string_view mill_kind) {
  return mill_kind == "arc-shaker" ? "capsule" : "cylinder";
}

StartBalls start_balls(std::string_view jar_kind) {
  if (jar_kind == "periodic-cylinder" || jar_kind.ends_with("lifter-cylinder"))
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
    const SinCos angle = sin_cos(2 * std::numbers::pi * (static_cast<double>(i % rows) / rows));
    text += fmt::format("{:.6f},{:.9f},{:.9f},0\n", period * i / rows, radius * angle.cos,
                        radius * angle.sin);
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
        text.append("facet normal 0 0 0\nouter loop\n")
            .append(a)
            .append(second)
            .append(third)
            .append("endloop\nendfacet\n");
    }
  return text + "endsolid jar\n";
}

}  // namespace mahlwerk::commands
