// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "crowd_files.hpp"

#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;
constexpr double pi = std::numbers::pi;

kinematics::FrameMotion frame_motion_of(const CrowdCase& c) {
  return kinematics::frame_motion(*c.mill.motion, 0);
}

/// Null for a drum.
const kinematics::Planetary* planetary(const CrowdCase& c) {
  return kinematics::as<kinematics::Planetary>(*c.mill.motion);
}

void write_state(const fs::path& file, const CrowdCase& c, const std::vector<scene::Ball>& balls) {
  const auto frame = frame_motion_of(c);
  // The box is just large enough for the jar during the measurement: the other codes divide all of
  // it into bins.
  const Vec3 axis = c.mill.mount * Vec3{0, 0, 1};
  const double spare = 0.006, across = c.radius + spare, along = c.height / 2 + spare;
  const auto extent = [&](double a) { return std::abs(a) > 0.5 ? along : across; };
  fmt::ostream out = fmt::output_file(file.string());
  out.print("state\n\n{} atoms\n2 atom types\n\n", balls.size());
  for (const auto& [name, centre, a] : {std::tuple{"x", frame.centre.x, axis.x},
                                        {"y", frame.centre.y, axis.y},
                                        {"z", frame.centre.z, axis.z}})
    out.print("{1} {2} {0}lo {0}hi\n", name, centre - extent(a), centre + extent(a));
  out.print("\nAtoms\n\n");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    const Vec3 x = b.position + frame.centre;
    out.print("{} {} {:.12g} {:.12g} {:.15g} {:.15g} {:.15g}\n", i + 1, b.kind + 1, 2 * b.radius,
              b.density, x.x, x.y, x.z);
  }
  out.print("\nVelocities\n\n");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    const Vec3 v = b.velocity + frame.velocity;
    out.print("{} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", i + 1, v.x, v.y, v.z,
              b.spin.x, b.spin.y, b.spin.z);
  }
}

/// Speeds [rad/s] of the disc, 0 for a drum, and of the jar about its own axis; radius [m] of the
/// orbit.
struct Speeds {
  double disc, spin, orbit;
};

Speeds speeds_of(const CrowdCase& c) {
  if (const auto* p = planetary(c)) return {p->speed, p->jar_spin(), p->orbit_radius};
  return {0, kinematics::as<kinematics::Tumbling>(*c.mill.motion)->speed, 0};
}

void write_numbers(const fs::path& file, const CrowdCase& c) {
  const Speeds s = speeds_of(c);
  const std::pair<const char*, double> numbers[] = {
      {"step_time", c.step},
      {"youngs_modulus", c.youngs_modulus},
      {"skin", c.skin},
      {"margin", c.margin},
      {"rolling_stiffness", c.rolling_stiffness},
      {"bending_stiffness", c.bending_stiffness},
      {"disc", s.disc},
      {"spin", s.spin},
      {"orbit", s.orbit},
  };
  fmt::ostream out = fmt::output_file(file.string());
  for (const auto& [name, value] : numbers) out.print("variable {} equal {}\n", name, value);
  out.print("variable search string {}\nvariable split string \"{}\"\n", c.search, c.processors);
}

void write_region(const fs::path& file, const CrowdCase& c) {
  const Speeds s = speeds_of(c);
  const double half = c.height / 2, turn = s.spin * c.step, disc_turn = s.disc * c.step;
  fmt::ostream out = fmt::output_file(file.string());
  out.print("variable turned equal {}*step\n", turn);
  if (s.disc == 0) {
    out.print("region jar cylinder x 0 0 {} {} {} side in rotate v_turned 0 0 0 1 0 0\n", c.radius,
              -half, half);
    return;
  }
  out.print("variable dx equal {0}*cos({1}*step)-{0}\nvariable dy equal {0}*sin({1}*step)\n",
            s.orbit, disc_turn);
  out.print(
      "region jar cylinder z {0} 0 {1} {2} {3} side in move v_dx v_dy NULL rotate v_turned {0} 0 0 "
      "0 0 1\n",
      s.orbit, c.radius, -half, half);
}

/// Two rotations move a jar on a disc: one with the disc, then one about its own axis.
void write_motion(const fs::path& file, const CrowdCase& c) {
  const Speeds s = speeds_of(c);
  fmt::ostream out = fmt::output_file(file.string());
  const auto turning = [&](const char* name, double origin, const char* axis, double speed) {
    out.print("fix {} all move/mesh mesh jar rotate origin {} 0. 0. axis {} period {}\n", name,
              origin, axis, 2 * pi / speed);
  };
  if (s.disc == 0) return turning("turned", 0, "1. 0. 0.", s.spin);
  turning("carried", 0, "0. 0. 1.", s.disc);
  turning("turned", s.orbit, "0. 0. -1.", s.disc - s.spin);
}

void write_mesh(const fs::path& file, const CrowdCase& c) {
  constexpr int sides = 72;
  const double h = c.height, radius = c.radius / std::cos(pi / sides);
  const Vec3 centre = frame_motion_of(c).centre;
  const auto corner = [&](int k, double z) {
    const double angle = 2 * pi * k / sides;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  fmt::ostream out = fmt::output_file(file.string());
  const auto write = [&](const std::array<Vec3, 3>& triangle) {
    out.print("facet normal 0 0 0\n outer loop\n");  // the reader computes the normal
    for (const Vec3& one : triangle) {
      const Vec3 p = c.mill.mount * one + centre;
      out.print("  vertex {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
    }
    out.print(" endloop\nendfacet\n");
  };
  out.print("solid jar\n");
  for (int k = 0; k < sides; ++k) {
    for (const double z : {-h / 2, 0.0}) {  // two rows: long triangles are searched more slowly
      const double top = z + h / 2;
      write({corner(k, z), corner(k + 1, z), corner(k + 1, top)});
      write({corner(k, z), corner(k + 1, top), corner(k, top)});
    }
    for (const double z : {-h / 2, h / 2}) write({Vec3{0, 0, z}, corner(k, z), corner(k + 1, z)});
  }
  out.print("endsolid jar\n");
}

}  // namespace

void write_crowd(const fs::path& folder, const CrowdCase& c,
                 const std::vector<scene::Ball>& balls) {
  write_state(folder / "state.data", c, balls);
  write_numbers(folder / "case.in", c);
  write_region(folder / "jar.in", c);
  write_motion(folder / "mesh.in", c);
  write_mesh(folder / "jar.stl", c);
}

}  // namespace mahlwerk::bench
