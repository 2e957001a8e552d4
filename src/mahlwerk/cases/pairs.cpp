// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/powder/wear.hpp"

namespace mahlwerk::cases {
namespace {

int kinds(const Case& c) {
  return static_cast<int>(c.balls.size());
}
int faces(const Case& c) {
  return geometry::faces(*c.jar.shape);
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
  const std::vector<std::string> faces = face_names(*c.jar.shape);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (name == "jar" || name == "jar." + faces[i] || (!name.empty() && name == c.jar.material))
      found.faces.push_back(static_cast<int>(i));
  return found;
}

std::vector<std::string> pair_selector_names(const Case& c) {
  std::vector<std::string> names{"balls"};
  const auto also = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (std::size_t i = 0; i < c.balls.size(); ++i) also(set_name(c, i));
  const std::vector<std::string> faces = face_names(*c.jar.shape);
  if (!faces.empty()) also("jar");
  for (const std::string& face : faces) also("jar." + face);
  for (const BallSet& set : c.balls) also(set.material);
  if (!faces.empty()) also(c.jar.material);
  return names;
}

contact::BounceTable bounce_table(const Case& c) {
  contact::BounceTable table(kinds(c), faces(c), c.contact.rule);
  for (const PairRule& pair : c.contact.pairs)
    for_each_pair(
        pair, c, [&](int i, int j) { table.set_balls(i, j, pair.rule); },
        [&](int i, int face) { table.set_wall(i, face, pair.rule); });
  return table;
}

contact::PairTable pair_table(const Case& c) {
  contact::PairTable table(kinds(c), faces(c), contact_pair(c.contact));
  for (const PairRule& rule : c.contact.pairs)
    for_each_pair(
        rule, c, [&](int i, int j) { table.set_balls(i, j, contact_pair(rule)); },
        [&](int i, int face) { table.set_wall(i, face, contact_pair(rule)); });
  const auto body = [&](int kind) {
    const BallSet& set = c.balls[static_cast<std::size_t>(kind)];
    return Body{set.elastic, set.substance};
  };
  const Body jar{c.jar.elastic, c.jar.substance};
  for (int i = 0; i < kinds(c); ++i) {
    for (int j = i; j < kinds(c); ++j)
      table.set_balls(i, j,
                      with_material(table.balls(i, j), body(i), body(j), c.contact.softening));
    for (int face = 0; face < faces(c); ++face)
      table.set_wall(i, face,
                     with_material(table.wall(i, face), body(i), jar, c.contact.softening));
  }
  return table;
}

}  // namespace mahlwerk::cases
