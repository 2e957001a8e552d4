// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/wall_faces.hpp"

#include <fmt/format.h>

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

std::string soft_only_wall(const Case& c) {
  if (!geometry::exact_touches(*c.jar.shape))
    return fmt::format("a jar of kind \"{}\"", geometry::name_of(*c.jar.shape));
  return c.machine_parts.empty() ? "" : "parts in the jar ([[parts]])";
}

}  // namespace mahlwerk::cases
