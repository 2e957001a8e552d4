// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "peers_case.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <string_view>
#include <utility>

#include "mahlwerk/base/random.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// From the jar frame to the laboratory frame at time 0.
constexpr Vec3 to_laboratory{planetary_case.mill.orbit_radius, 0, planetary_case.vial.height / 2};

using Triangle = std::array<Vec3, 3>;

void write(fmt::ostream& out, const Triangle& triangle) {
  out.print("facet normal 0 0 0\n outer loop\n");  // the reader computes the normal
  for (const Vec3& corner : triangle) {
    const Vec3 p = corner + to_laboratory;
    out.print("  vertex {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  }
  out.print(" endloop\nendfacet\n");
}

}  // namespace

Start start(int replicate) {
  // The least gap is 0.59 mm, so balls moved by 0.1 mm each touch nothing.
  constexpr std::array places{
      Vec3{0.009, 0, -0.00774},           Vec3{-0.0045, 0.007794, -0.00774},
      Vec3{-0.0045, -0.007794, -0.00774}, Vec3{0.0085, 0, 0.00796},
      Vec3{-0.0085, 0, 0.00796},
  };
  constexpr double farthest = 1e-4;  // [m]
  Random random(1, static_cast<std::uint32_t>(replicate));
  Start balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double angle = random.uniform(0, 2 * pi), distance = random.uniform(0, farthest);
    const Vec3 aside = distance * Vec3{std::cos(angle), std::sin(angle), 0};
    balls[i] = planetary_case.ball(replicate == 0 ? places[i] : places[i] + aside);
  }
  return balls;
}

void write_case(const std::filesystem::path& file, const Start& start) {
  constexpr const PlanetaryCase& c = planetary_case;
  const std::pair<std::string_view, double> numbers[] = {
      {"disc", c.mill.speed},
      {"spin", c.mill.jar_spin()},
      {"orbit", c.mill.orbit_radius},
      {"radius", c.vial.diameter / 2},
      {"height", c.vial.height},
      {"diameter", c.diameter},
      {"density", c.density},
      {"youngs_modulus", c.youngs_modulus},
      {"poissons_ratio", c.poissons_ratio},
      {"restitution", c.restitution},
      {"friction", c.friction},
      {"rolling_friction", c.rolling_friction},
      {"gravity", c.gravity},
  };
  fmt::ostream out = fmt::output_file(file.string());
  for (const auto& [name, value] : numbers) out.print("variable {} equal {}\n", name, value);
  out.print("variable step_time equal {}\n", c.step);
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 p = start[i].position + to_laboratory;
    out.print("variable x{0} equal {1:.12f}\nvariable y{0} equal {2:.12f}\n", i + 1, p.x, p.y);
    out.print("variable z{} equal {:.12f}\n", i + 1, p.z);
  }
}

void write_vial(const std::filesystem::path& file, int sides) {
  const double h = planetary_case.vial.height;
  const double radius = planetary_case.vial.diameter / (1 + std::cos(pi / sides));
  const auto corner = [&](int k, double z) {
    const double angle = 2 * pi * k / sides;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  fmt::ostream out = fmt::output_file(file.string());
  out.print("solid vial\n");
  for (int k = 0; k < sides; ++k) {
    for (const double z : {-h / 2, 0.0}) {  // two rows: long triangles are searched more slowly
      const double top = z + h / 2;
      write(out, {corner(k, z), corner(k + 1, z), corner(k + 1, top)});
      write(out, {corner(k, z), corner(k + 1, top), corner(k, top)});
    }
    for (const double z : {-h / 2, h / 2})
      write(out, {Vec3{0, 0, z}, corner(k, z), corner(k + 1, z)});
  }
  out.print("endsolid vial\n");
}

}  // namespace mahlwerk::bench
