// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/powder/wear.hpp"

namespace mahlwerk::cases {
namespace {

int kinds(const Case& c) {
  return static_cast<int>(c.balls.size());
}

/// Calls `balls` for every two ball sets, and `wall` for every set and face, that a rule selects.
template <class Balls, class Wall>
void for_each_pair(const PairRule& pair, const Case& c, Balls balls, Wall wall) {
  const PairSelector a = pair_selector(pair.between[0], c), b = pair_selector(pair.between[1], c);
  for (const int i : a.kinds) {
    for (const int j : b.kinds) balls(i, j);
    for (const int face : b.faces) wall(i, face);
  }
  for (const int j : b.kinds)
    for (const int face : a.faces) wall(j, face);
}

/// Pair parameters from [contact] or one of its pairs; with_material() adds moduli and hardness.
template <class Owner>
contact::Pair contact_pair(const Owner& owner) {
  return {.modulus = 0,
          .shear_modulus = 0,
          .restitution = owner.rule.restitution.value(),
          .friction = owner.rule.friction,
          .rolling_friction = owner.rolling_friction,
          .surface_energy = owner.surface_energy,
          .cohesion = owner.cohesion,
          .surface_tension = owner.surface_tension};
}

/// A body of a pair.
struct Body {
  contact::ElasticConstants elastic;
  Substance substance;
};

contact::Pair with_material(contact::Pair pair, Body one, Body other, double softening) {
  contact::ElasticConstants a = one.elastic, b = other.elastic;
  a.youngs_modulus *= softening;
  b.youngs_modulus *= softening;
  pair.softening = softening;
  pair.hardness = powder::hardness(std::min(one.substance.hardness, other.substance.hardness));
  pair.modulus = contact::effective_modulus(a, b);
  pair.shear_modulus = contact::effective_shear_modulus(a, b);
  return pair;
}

/// Calls `f` for every ball set with every face of a part.
template <class F>
void for_each_part_face(const Case& c, const F& f) {
  int face = jar_faces(c);
  for (const int part : parts_of_faces(c)) {
    for (int kind = 0; kind < kinds(c); ++kind)
      f(kind, face, c.machine_parts[static_cast<std::size_t>(part)]);
    ++face;
  }
}

contact::BounceRule with_own_values(contact::BounceRule rule, const MachinePart& part) {
  if (part.restitution) rule.restitution = *part.restitution;
  if (part.friction) rule.friction = *part.friction;
  return rule;
}

}  // namespace

std::string set_name(const Case& c, std::size_t kind) {
  return c.balls[kind].grains ? "powder" : fmt::format("balls.{}", kind + 1);
}

PairSelector pair_selector(std::string_view name, const Case& c) {
  PairSelector found;
  for (std::size_t i = 0; i < c.balls.size(); ++i)
    if ((name == "balls" && !c.balls[i].grains) || name == set_name(c, i) ||
        (!name.empty() && name == c.balls[i].material))
      found.kinds.push_back(static_cast<int>(i));
  const std::vector<std::string> faces = wall_face_names(c);
  const std::vector<int> parts = parts_of_faces(c);
  const std::size_t of_jar = faces.size() - parts.size();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool jar = i < of_jar;
    const std::string& material =
        jar ? c.jar.material
            : c.machine_parts[static_cast<std::size_t>(parts[i - of_jar])].material;
    if (name == (jar ? "jar" : "parts") || name == faces[i] || (!name.empty() && name == material))
      found.faces.push_back(static_cast<int>(i));
  }
  return found;
}

std::vector<std::string> pair_selector_names(const Case& c) {
  std::vector<std::string> names{"balls"};
  const auto also = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (std::size_t i = 0; i < c.balls.size(); ++i) also(set_name(c, i));
  const bool walls = jar_faces(c) > 0;
  if (walls) also("jar");
  if (!c.machine_parts.empty()) also("parts");
  for (const std::string& face : wall_face_names(c)) also(face);
  for (const BallSet& set : c.balls) also(set.material);
  if (walls) also(c.jar.material);
  for (const MachinePart& part : c.machine_parts) also(part.material);
  return names;
}

contact::BounceTable bounce_table(const Case& c) {
  contact::BounceTable table(kinds(c), wall_faces(c), c.contact.rule);
  for_each_part_face(c, [&](int kind, int face, const MachinePart& part) {
    table.set_wall(kind, face, with_own_values(c.contact.rule, part));
  });
  for (const PairRule& pair : c.contact.pairs)
    for_each_pair(
        pair, c, [&](int i, int j) { table.set_balls(i, j, pair.rule); },
        [&](int i, int face) { table.set_wall(i, face, pair.rule); });
  return table;
}

contact::PairTable pair_table(const Case& c) {
  contact::PairTable table(kinds(c), wall_faces(c), contact_pair(c.contact));
  for_each_part_face(c, [&](int kind, int face, const MachinePart& part) {
    Contact own = c.contact;
    own.rule = with_own_values(own.rule, part);
    table.set_wall(kind, face, contact_pair(own));
  });
  for (const PairRule& rule : c.contact.pairs)
    for_each_pair(
        rule, c, [&](int i, int j) { table.set_balls(i, j, contact_pair(rule)); },
        [&](int i, int face) { table.set_wall(i, face, contact_pair(rule)); });
  const auto body = [&](int kind) {
    const BallSet& set = c.balls[static_cast<std::size_t>(kind)];
    return Body{set.elastic, set.substance};
  };
  const int of_jar = jar_faces(c);
  const std::vector<int> parts = parts_of_faces(c);
  const auto wall = [&](int face) {
    if (face < of_jar) return Body{c.jar.elastic, c.jar.substance};
    const auto part = static_cast<std::size_t>(parts[static_cast<std::size_t>(face - of_jar)]);
    return Body{c.machine_parts[part].elastic, c.machine_parts[part].substance};
  };
  for (int i = 0; i < kinds(c); ++i) {
    for (int j = i; j < kinds(c); ++j)
      table.set_balls(i, j,
                      with_material(table.balls(i, j), body(i), body(j), c.contact.softening));
    for (int face = 0; face < wall_faces(c); ++face)
      table.set_wall(i, face,
                     with_material(table.wall(i, face), body(i), wall(face), c.contact.softening));
  }
  return table;
}

}  // namespace mahlwerk::cases
