// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"

namespace mahlwerk::cases {
namespace {

std::string set_name(std::size_t kind) {
  return fmt::format("balls.{}", kind + 1);
}

}  // namespace

std::vector<std::string> face_names(const geometry::AnyShape& shape) {
  return std::visit(
      [](const auto& s) {
        std::vector<std::string> names;
        for (int face = 0; face < s.faces; ++face) names.emplace_back(s.face_name(face));
        return names;
      },
      shape);
}

Party party(std::string_view name, const Case& c) {
  Party found;
  for (std::size_t i = 0; i < c.balls.size(); ++i)
    if (name == "balls" || name == set_name(i) || (!name.empty() && name == c.balls[i].material))
      found.kinds.push_back(static_cast<int>(i));
  const std::vector<std::string> faces = face_names(c.jar.shape);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (name == "jar" || name == "jar." + faces[i] || (!name.empty() && name == c.jar.material))
      found.faces.push_back(static_cast<int>(i));
  return found;
}

std::vector<std::string> party_names(const Case& c) {
  std::vector<std::string> names{"balls"};
  const auto also = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (std::size_t i = 0; i < c.balls.size(); ++i) also(set_name(i));
  const std::vector<std::string> faces = face_names(c.jar.shape);
  if (!faces.empty()) also("jar");
  for (const std::string& face : faces) also("jar." + face);
  for (const BallSet& set : c.balls) also(set.material);
  if (!faces.empty()) also(c.jar.material);
  return names;
}

contact::BounceTable bounce_table(const Case& c) {
  const int faces =
      std::visit([](const auto& s) { return static_cast<int>(s.faces); }, c.jar.shape);
  contact::BounceTable table(static_cast<int>(c.balls.size()), faces, c.contact.rule);
  for (const PairRule& pair : c.contact.pairs) {
    const Party a = party(pair.between[0], c), b = party(pair.between[1], c);
    for (const int i : a.kinds) {
      for (const int j : b.kinds) table.set_balls(i, j, pair.rule);
      for (const int face : b.faces) table.set_wall(i, face, pair.rule);
    }
    for (const int j : b.kinds)
      for (const int face : a.faces) table.set_wall(j, face, pair.rule);
  }
  return table;
}

}  // namespace mahlwerk::cases
