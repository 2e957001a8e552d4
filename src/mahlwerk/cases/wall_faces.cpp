// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/wall_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {
namespace {

int faces_of(const MachinePart& part) {
  return std::visit([](const auto& s) { return static_cast<int>(s.faces); }, *part.body.solid);
}

}  // namespace

int jar_faces(const Case& c) {
  return geometry::faces(*c.jar.shape);
}
int wall_faces(const Case& c) {
  int all = jar_faces(c);
  for (const MachinePart& part : c.machine_parts) all += faces_of(part);
  return all;
}

std::vector<std::string> wall_face_names(const Case& c) {
  std::vector<std::string> names;
  for (const std::string& face : face_names(*c.jar.shape)) names.push_back("jar." + face);
  for (const int part : parts_of_faces(c))
    names.push_back("parts." + c.machine_parts[static_cast<std::size_t>(part)].name);
  return names;
}

std::vector<int> parts_of_faces(const Case& c) {
  std::vector<int> parts;
  for (std::size_t i = 0; i < c.machine_parts.size(); ++i)
    parts.insert(parts.end(), static_cast<std::size_t>(faces_of(c.machine_parts[i])),
                 static_cast<int>(i));
  return parts;
}

double part_speed(const Case& c) {
  const double reach = geometry::reach(*c.jar.shape);
  double most = 0;
  for (const MachinePart& part : c.machine_parts) {
    const kinematics::PartMotion& m = part.body.motion;
    const double own = std::visit([](const auto& s) { return s.reach(); }, *part.body.solid);
    const double lever = std::min(norm(part.body.position - m.pivot) + own, reach + norm(m.pivot));
    most = std::max(most, m.speed_bound() + m.spin_bound() * lever);
  }
  return most;
}

double part_period(const Case& c) {
  double longest = 0;
  for (const MachinePart& part : c.machine_parts)
    if (const double period = part.body.motion.period(); std::isfinite(period))
      longest = std::max(longest, period);
  return longest > 0 ? longest : kinematics::no_period;
}

std::string soft_only_wall(const Case& c) {
  if (!geometry::exact_touches(*c.jar.shape))
    return fmt::format("a jar of kind \"{}\"", geometry::name_of(*c.jar.shape));
  if (c.drive) return "a mill whose speed a motor and the charge decide ([drive])";
  return c.machine_parts.empty() ? "" : "parts in the jar ([[parts]])";
}

}  // namespace mahlwerk::cases
