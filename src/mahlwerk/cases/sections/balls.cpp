// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

std::int64_t nearest_count(Section& in, const Node& at, std::string_view key, double share) {
  if (std::isnan(share)) return 0;  // reported where it comes from
  const double n = std::max(1.0, std::round(share));
  if (n > static_cast<double>(most_balls)) {
    in.fault(at, fmt::format("{} = \"{}\" makes more than {} balls", key, at.text, most_balls),
             "give fewer or larger balls", "out-of-range");
    return 0;
  }
  const auto count = static_cast<std::int64_t>(n);
  in.note("count", std::to_string(count), &at, fmt::format("nearest to {} = \"{}\"", key, at.text));
  return count;
}

/// One ball's place; nothing after a fault.
std::optional<Vec3> read_place(Section& in, const Node& row, std::size_t number) {
  if (row.kind != Node::Kind::list || row.items.size() != 3) {
    in.fault(row, fmt::format("ball {} of `positions` must have three coordinates", number),
             "write x, y, z in the jar's own axes: [\"9 mm\", \"0 mm\", \"-7.74 mm\"]",
             "wrong-type");
    return std::nullopt;
  }
  const Wanted coordinate("positions", "m", any_number, "places of centres, from the jar's centre");
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = in.quantity(row.items[i], coordinate);
  const Vec3 place{at[0], at[1], at[2]};
  return std::isnan(place.x + place.y + place.z) ? std::nullopt : std::optional(place);
}

/// Where the balls of a set start; none after a fault.
std::vector<Vec3> read_places(Section& in, const Node& at) {
  std::vector<Vec3> places;
  bool sound = at.kind == Node::Kind::list && !at.items.empty();
  if (!sound)
    in.fault(at, "`positions` must be a list of places",
             "write positions = [[\"9 mm\", \"0 mm\", \"-7.74 mm\"]]", "wrong-type");
  for (const Node& row : at.items) {
    const auto place = read_place(in, row, places.size() + 1);
    sound = sound && place;
    places.push_back(place.value_or(Vec3{}));
  }
  if (!sound) return {};
  in.note("positions", places_text(places), &at);
  in.note("count", std::to_string(places.size()), &at, "one for each of `positions`");
  return places;
}

/// By number, by mass, by the balls' share of the jar's volume, or by the places they start at.
std::int64_t read_count(Section& in, BallSet& set, const Jar& jar) {
  const std::string_view key = in.one_of({"count", "mass", "filling", "positions"});
  if (key == "positions") {
    set.positions = read_places(in, *in.find(key));
    return static_cast<std::int64_t>(set.positions.size());
  }
  if (key == "count") return in.whole("count", most_balls).value_or(0);
  if (key.empty()) {
    in.note_default("count", "1", "one ball");
    return 1;
  }
  const Node& at = *in.find(key);
  if (key == "mass") {
    const double mass = in.quantity(at, {"mass", "kg", positive, "mass of all balls of this set"});
    return nearest_count(in, at, key, mass / set.mass());
  }
  const Range share{.least = 0, .most = 1, .without_least = true};
  const double filling =
      in.quantity(at, {"filling", "", share, "volume of the balls over volume of the jar"});
  return nearest_count(in, at, key, filling * jar_volume(jar) / ball_volume(set));
}

/// [m] of the ball of mean volume, which classes do not change.
double mean_diameter(Distribution of) {
  of.classes = std::max<std::int64_t>(of.classes, 1);
  return mean_volume_diameter(size_shares(of));
}

BallSet read_set(const Node& table, std::size_t number, const Jar& jar, const Catalogue& catalogue,
                 Findings& findings) {
  BallSet set;
  Section in(&table, fmt::format("balls.{}", number), findings);
  if (const Node* model = in.find("model")) {
    in.text("model");
    if (const auto entry = look_up(catalogue, "media", *model, findings)) in.lend(*entry);
  }
  const Wanted diameter(ball_fields()[0]), density(ball_fields()[1]);
  const bool sound = read_distribution(in, set.distribution);
  const bool equal = set.distribution.law == Distribution::Law::equal;
  set.diameter = equal ? in.value(diameter) : sound ? mean_diameter(set.distribution) : unread;
  const auto given = read_density(in, density, set.material, catalogue);
  if (!given)
    in.missing("density", density.about,
               set.material.empty()
                   ? "write density = \"7850 kg/m3\", or material with a name `mahlwerk list "
                     "materials` shows"
                   : fmt::format("the catalogue gives none for {}: write density = \"7850 kg/m3\"",
                                 set.material));
  set.density = given.value_or(unread);
  set.elastic = read_elastic(in, set.material, catalogue);
  set.substance = read_substance(in, set.material, catalogue);
  set.count = read_count(in, set, jar);
  if (!equal && sound && set.count > 0 && set.positions.empty()) {
    set.classes = read_classes(in, set.distribution, set.count);
    set.diameter = mean_volume_diameter(set.classes);
  }
  in.close();
  return set;
}

}  // namespace

double ball_volume(const BallSet& set) {
  return std::numbers::pi * set.diameter * set.diameter * set.diameter / 6;
}

double balls_mass(const std::vector<BallSet>& balls) {
  double mass = 0;
  for (const BallSet& set : balls)
    if (!set.grains) mass += static_cast<double>(set.count) * set.mass();
  return mass;
}

double balls_volume(const std::vector<BallSet>& balls) {
  double volume = 0;
  for (const BallSet& set : balls)
    if (!set.grains) volume += static_cast<double>(set.count) * ball_volume(set);
  return volume;
}

std::int64_t balls_count(const std::vector<BallSet>& balls) {
  std::int64_t count = 0;
  for (const BallSet& set : balls) count += set.count;
  return count;
}

double largest_ball(const std::vector<BallSet>& balls) {
  double diameter = 0;
  for (const BallSet& set : balls) {
    if (std::isnan(set.diameter)) return unread;
    for (const SizeClass& size : set.sizes()) diameter = std::max(diameter, size.diameter);
  }
  return diameter;
}

double smallest_ball(const std::vector<BallSet>& balls) {
  double diameter = std::numeric_limits<double>::infinity();
  for (const BallSet& set : balls) {
    if (set.grains) continue;
    for (const SizeClass& size : set.sizes()) diameter = std::min(diameter, size.diameter);
  }
  return diameter;
}

std::vector<BallSet> read_balls(const Node* list, const Jar& jar, const Catalogue& catalogue,
                                Findings& findings) {
  std::vector<BallSet> balls;
  bool tables = list != nullptr && list->kind == Node::Kind::list && !list->items.empty();
  if (tables)
    for (const Node& item : list->items) tables = tables && item.kind == Node::Kind::table;
  if (!tables) {
    const bool written = list != nullptr && list->kind != Node::Kind::other;
    findings.faults.push_back(
        {list ? list->where : "",
         written ? "`balls` must be a list of ball sets" : "there are no balls",
         "write [[balls]] with diameter, density and count", "missing-value"});
    return balls;
  }
  for (const Node& item : list->items)
    balls.push_back(read_set(item, balls.size() + 1, jar, catalogue, findings));
  return balls;
}

}  // namespace mahlwerk::cases
