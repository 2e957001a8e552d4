// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/jar_terms.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <utility>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::lammps {
namespace {

std::string text(double value) {
  return fmt::format("{:.15g}", value);
}

/// The axes of the laboratory along which the jar's own axes lie: z upright, or along x.
struct Mounting {
  bool lying;
  char axis() const { return lying ? 'x' : 'z'; }
  /// The centre of a circle across the jar's axis, as LAMMPS orders it.
  static std::string on_axis() { return "0 0"; }
  std::string along(double z) const {
    return lying ? fmt::format("{} 0 0", text(z)) : fmt::format("0 0 {}", text(z));
  }
};

std::string cylinder(const std::string& id, const Mounting& m, double diameter, double height,
                     const std::string& more) {
  return fmt::format("region {} cylinder {} {} {} {} {} side in{}\n", id, m.axis(), m.on_axis(),
                     text(0.5 * diameter), text(-0.5 * height), text(0.5 * height), more);
}

std::string sphere(const std::string& id, const Mounting& m, double z, double diameter,
                   const std::string& more) {
  return fmt::format("region {} sphere {} {} side in{}\n", id, m.along(z), text(0.5 * diameter),
                     more);
}

/// The region of the jar; `more` are its keywords of motion.
std::string region(const geometry::AnyShape& shape, const Mounting& m, const std::string& more) {
  if (const auto* c = geometry::as<geometry::Cylinder>(shape))
    return cylinder("jar", m, c->diameter, c->height, more);
  if (const auto* c = geometry::as<geometry::Sphere>(shape))
    return sphere("jar", m, 0, c->diameter, more);
  if (const auto* c = geometry::as<geometry::Box>(shape)) {
    const std::array<double, 3> size = m.lying ? std::array{c->height, c->depth, c->width}
                                               : std::array{c->width, c->depth, c->height};
    std::string ends;
    for (const double side : size) ends += fmt::format(" {} {}", text(-side / 2), text(side / 2));
    return fmt::format("region jar block{} side in{}\n", ends, more);
  }
  const auto& c = *geometry::as<geometry::Capsule>(shape);
  return cylinder("side", m, c.diameter, c.height, "") +
         sphere("bottom", m, -0.5 * c.height, c.diameter, "") +
         sphere("top", m, 0.5 * c.height, c.diameter, "") +
         fmt::format("region jar union 3 side bottom top side in{}\n", more);
}

/// Formulas of time: the angle of the jar about `axis`, and the force by mass along x, y, z.
struct Motion {
  std::string angle, axis, angular_speed;
  std::array<std::string, 3> force;
};

Motion motion_of(const kinematics::AnyMotion& motion) {
  const auto turning = [](double w) { return fmt::format("{}*v_time", text(w)); };
  const auto circle = [&](double w, double radius) {
    const std::string size = text(w * w * radius);
    return std::array<std::string, 3>{fmt::format("{}*cos({})", size, turning(w)),
                                      fmt::format("{}*sin({})", size, turning(w)), ""};
  };
  if (const auto* m = kinematics::as<kinematics::Planetary>(motion))
    return {turning(m->jar_spin()), "0 0 1", text(m->jar_spin()),
            circle(m->speed, m->orbit_radius)};
  if (const auto* m = kinematics::as<kinematics::Circular>(motion))
    return {"", "", "", circle(m->speed, m->radius)};
  if (const auto* m = kinematics::as<kinematics::Tumbling>(motion))
    return {turning(m->speed), "1 0 0", text(m->speed), {}};
  if (const auto* m = kinematics::as<kinematics::Vibration>(motion)) {
    const double w = 2 * std::numbers::pi * m->frequency;
    const Vec3 size = w * w * m->amplitude * m->line();
    Motion made;
    const std::array<double, 3> parts{size.x, size.y, size.z};
    for (std::size_t i = 0; i < 3; ++i)
      if (parts[i] != 0) made.force[i] = fmt::format("{}*sin({})", text(parts[i]), turning(w));
    return made;
  }
  return {};
}

}  // namespace

bool is_lying(const scene::Chamber& chamber) {
  return dot(chamber.mount * Vec3{0, 0, 1}, Vec3{1, 0, 0}) > 0.5;
}

bool has_region(const geometry::AnyShape& shape) {
  return geometry::as<geometry::Cylinder>(shape) || geometry::as<geometry::Sphere>(shape) ||
         geometry::as<geometry::Box>(shape) || geometry::as<geometry::Capsule>(shape);
}
std::string known_regions() {
  return "cylinder, capsule, sphere and box";
}

bool has_body_force(const kinematics::AnyMotion& motion) {
  return kinematics::as<kinematics::Still>(motion) ||
         kinematics::as<kinematics::Vibration>(motion) ||
         kinematics::as<kinematics::Planetary>(motion) ||
         kinematics::as<kinematics::Tumbling>(motion) ||
         kinematics::as<kinematics::Circular>(motion);
}
std::string known_motions() {
  return "still, vibration, planetary, tumbling and circular";
}

std::string jar_commands(const scene::Chamber& chamber, double time_step) {
  const Motion motion = motion_of(*chamber.motion);
  const Mounting mounting{is_lying(chamber)};
  std::string commands = fmt::format("variable time equal step*{}\n", text(time_step)), turns;
  if (!motion.angle.empty()) {
    commands += fmt::format("variable angle equal {}\n", motion.angle);
    turns = fmt::format(" rotate v_angle 0 0 0 {}", motion.axis);
  }
  commands += region(*chamber.shape, mounting, turns);
  const std::array<std::string, 3> axes{"1 0 0", "0 1 0", "0 0 1"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (motion.force[i].empty()) continue;
    const char name = "xyz"[i];
    commands +=
        fmt::format("variable force_{} equal {}\nfix force_{} all gravity v_force_{} vector {}\n",
                    name, motion.force[i], name, name, axes[i]);
  }
  const Vec3& g = chamber.gravity;
  if (norm(g) > 0)
    commands += fmt::format("fix gravity all gravity {} vector {} {} {}\n", text(norm(g)),
                            text(g.x), text(g.y), text(g.z));
  return commands;
}

namespace {

/// The jar's own coordinates of a ball, as formulas.
std::array<std::string, 3> own_coordinates(const scene::Chamber& chamber) {
  const Motion motion = motion_of(*chamber.motion);
  const bool lying = is_lying(chamber);
  std::array<std::string, 3> at{"x", "y", "z"};
  const bool sphere = geometry::as<geometry::Sphere>(*chamber.shape) != nullptr;
  const bool along = motion.axis == (lying ? "1 0 0" : "0 0 1");
  if (!motion.axis.empty() && !sphere && !(along && geometry::axisymmetric(*chamber.shape))) {
    const std::size_t a = motion.axis.starts_with('1') ? 1 : 0, b = a + 1;  // the axes across
    const char first = "xyz"[a], second = "xyz"[b];
    at[a] = fmt::format("({0}*cos(v_angle)+{1}*sin(v_angle))", first, second);
    at[b] = fmt::format("({1}*cos(v_angle)-{0}*sin(v_angle))", first, second);
  }
  if (lying) return {"(-" + at[2] + ")", at[1], at[0]};
  return at;
}

}  // namespace

std::string touch_formula(const scene::Chamber& chamber) {
  const auto [x, y, z] = own_coordinates(chamber);
  const auto beyond = [&](const std::string& squares, double diameter) {
    return fmt::format("({0}>({1}-c_radius)*({1}-c_radius))", squares, text(0.5 * diameter));
  };
  const std::string across = fmt::format("{0}*{0}+{1}*{1}", x, y);
  const geometry::AnyShape& shape = *chamber.shape;
  std::vector<std::string> faces;
  const auto add_planes = [&](const std::string& at, double width) {
    faces.push_back(fmt::format("({}<c_radius-{})", at, text(0.5 * width)));
    faces.push_back(fmt::format("({}>{}-c_radius)", at, text(0.5 * width)));
  };
  if (const auto* s = geometry::as<geometry::Cylinder>(shape)) {
    add_planes(z, s->height);
    faces.push_back(beyond(across, s->diameter));
  } else if (const auto* b = geometry::as<geometry::Box>(shape)) {
    add_planes(x, b->width);
    add_planes(y, b->depth);
    add_planes(z, b->height);
  } else if (const auto* c = geometry::as<geometry::Capsule>(shape)) {
    const std::string above = fmt::format("(abs({0})-{1})", z, text(0.5 * c->height));
    faces.push_back(beyond(fmt::format("{0}+({1}>0)*{1}*{1}", across, above), c->diameter));
  } else {
    faces.push_back(beyond(fmt::format("{0}+{1}*{1}", across, z),
                           geometry::as<geometry::Sphere>(shape)->diameter));
  }
  std::string formula;
  for (std::size_t k = 0; k < faces.size(); ++k)
    formula += fmt::format("{}{}*{}", k > 0 ? "+" : "", 1 << k, faces[k]);
  return formula;
}

std::string power_commands(const scene::Chamber& chamber) {
  const Motion motion = motion_of(*chamber.motion);
  std::string commands, wall = "0", force = "0";
  const std::array<double, 3> gravity{chamber.gravity.x, chamber.gravity.y, chamber.gravity.z};
  const auto field = [&](std::size_t i) {  // gravity and body force along an axis, by mass
    const std::string own = motion.force[i].empty() ? "" : fmt::format("+v_force_{}", "xyz"[i]);
    return fmt::format("({}{})", text(gravity[i]), own);
  };
  if (!motion.axis.empty()) {
    const bool along_x = motion.axis.starts_with('1');
    const std::size_t a = along_x ? 1 : 0, b = a + 1;  // the axes across
    commands = fmt::format(
        "compute torque all property/atom tq{2}\n"
        "variable moment atom {0}*f{1}-{1}*f{0}+c_torque\ncompute moment all reduce sum v_moment\n",
        "xyz"[a], "xyz"[b], along_x ? 'x' : 'z');
    wall = fmt::format("{0}*(c_moment-mass(all)*(xcm(all,{1})*{4}-xcm(all,{2})*{3}))",
                       motion.angular_speed, "xyz"[a], "xyz"[b], field(a), field(b));
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (!motion.force[i].empty()) force += fmt::format("+v_force_{0}*vcm(all,{0})", "xyz"[i]);
  return commands +
         fmt::format("variable wall_power equal {}\nvariable body_power equal mass(all)*({})\n",
                     wall, force);
}

}  // namespace mahlwerk::lammps
