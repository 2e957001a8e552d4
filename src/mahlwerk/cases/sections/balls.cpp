// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

std::int64_t nearest_count(SectionReader& in, const Node& at, std::string_view key, double share) {
  if (std::isnan(share)) return 0;  // already reported
  const double n = std::max(1.0, std::round(share));
  if (n > static_cast<double>(max_balls)) {
    in.fault(at, fmt::format("{} = \"{}\" makes more than {} balls", key, at.text, max_balls),
             "give fewer or larger balls", "out-of-range");
    return 0;
  }
  const auto count = static_cast<std::int64_t>(n);
  in.record_origin("count", std::to_string(count), &at,
                   fmt::format("nearest to {} = \"{}\"", key, at.text));
  return count;
}

/// The position of one ball; no value after a fault.
std::optional<Vec3> read_position(SectionReader& in, const Node& row, std::size_t number) {
  if (row.kind != Node::Kind::list || row.items.size() != 3) {
    in.fault(row, fmt::format("ball {} of `positions` must have three coordinates", number),
             "write x, y, z in the jar's own axes: [\"9 mm\", \"0 mm\", \"-7.74 mm\"]",
             "wrong-type");
    return std::nullopt;
  }
  const NumberSpec coordinate("positions", "m", any_number,
                              "positions of ball centres, from the jar's centre");
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = in.quantity(row.items[i], coordinate);
  const Vec3 position{at[0], at[1], at[2]};
  return std::isnan(position.x + position.y + position.z) ? std::nullopt : std::optional(position);
}

std::string positions_text(const std::vector<Vec3>& positions) {
  std::string rows;
  for (const Vec3& p : positions)
    rows += fmt::format("{}[{}, {}, {}]", rows.empty() ? "" : ", ", in_quotes(show(p.x, "m")),
                        in_quotes(show(p.y, "m")), in_quotes(show(p.z, "m")));
  return "[" + rows + "]";
}

/// The initial positions of the balls of a set; none after a fault.
std::vector<Vec3> read_positions(SectionReader& in, const Node& at) {
  std::vector<Vec3> positions;
  bool sound = at.kind == Node::Kind::list && !at.items.empty();
  if (!sound)
    in.fault(at, "`positions` must be a list of positions",
             "write positions = [[\"9 mm\", \"0 mm\", \"-7.74 mm\"]]", "wrong-type");
  for (const Node& row : at.items) {
    const auto position = read_position(in, row, positions.size() + 1);
    sound = sound && position;
    positions.push_back(position.value_or(Vec3{}));
  }
  if (!sound) return {};
  in.record_origin("positions", positions_text(positions), &at);
  in.record_origin("count", std::to_string(positions.size()), &at, "one for each of `positions`");
  return positions;
}

constexpr NumberSpec mass_of_set("mass", "kg", positive, "mass of all balls of this set");
constexpr NumberSpec filling_of_set("filling", "", {.least = 0, .most = 1, .without_least = true},
                                    "volume of the balls over volume of the jar");

/// The number of balls, given directly, by mass, by filling of the jar, or by initial positions.
std::int64_t read_count(SectionReader& in, BallSet& set, const Jar& jar) {
  const std::string_view key = in.one_of({"count", "mass", "filling", "positions"});
  if (key == "positions") {
    set.positions = read_positions(in, *in.find(key));
    return static_cast<std::int64_t>(set.positions.size());
  }
  if (key == "count") return in.integer("count", max_balls).value_or(0);
  if (key.empty()) {
    in.record_default("count", "1", "one ball");
    return 1;
  }
  const Node& at = *in.find(key);
  if (key == "mass") {
    const double mass = in.quantity(at, mass_of_set);
    return nearest_count(in, at, key, mass / set.mass());
  }
  const double filling = in.quantity(at, filling_of_set);
  return nearest_count(in, at, key, filling * jar_volume(jar) / ball_volume(set));
}

/// [m] Diameter of the ball of mean volume; it does not depend on the number of classes.
double mean_diameter(Distribution of) {
  of.classes = std::max<std::int64_t>(of.classes, 1);
  return mean_volume_diameter(size_shares(of));
}

void describe_count(KeyVisitor& v, BallSet& set) {
  v.alternative({"model", "", any_number, "name of a ball set in the catalogue"});
  v.alternative(mass_of_set);
  v.alternative(filling_of_set);
  const std::vector<Vec3>& positions = set.positions;
  if (!positions.empty() || v.visits_all())
    v.custom(
        {"positions", "positions of ball centres, from the jar's centre",
         (positions.empty() || std::cmp_equal(positions.size(), set.count)) &&
             std::ranges::all_of(positions, [](const Vec3& p) { return std::isfinite(norm(p)); })},
        [&] { return positions_text(positions); });
  if (positions.empty() || v.visits_all())
    v.integer({"count", 1, max_balls, "number of balls"}, set.count);
}

/// False after a fault.
bool describe_sizes(KeyVisitor& v, BallSet& set) {
  const bool sound = describe(v, set.distribution, set.diameter);
  SectionReader* in = v.reader();
  if (in == nullptr || set.distribution.law == Distribution::Law::equal) return sound;
  set.diameter = sound ? mean_diameter(set.distribution) : invalid_value;
  if (const Node* positions = in->find("positions"); positions != nullptr)
    in->fault(*positions, "a set with a size distribution cannot have given positions",
              "give each size a set of its own, with its positions", "too-much");
  return sound;
}

void describe_material(KeyVisitor& v, BallSet& set) {
  const NumberSpec density("density", "kg/m3", positive, "density of a ball");
  if (SectionReader* in = v.reader()) {
    const auto given = read_density(*in, density, set.material);
    if (!given)
      in->missing(
          "density", density.about,
          set.material.empty()
              ? "write density = \"7850 kg/m3\", or material with a name from `mahlwerk list "
                "materials`"
              : fmt::format("the catalogue gives none for {}: write density = \"7850 kg/m3\"",
                            set.material));
    set.density = given.value_or(invalid_value);
  } else {
    v.number(density, set.density);
    v.text("material", set.material);
  }
  describe(v, set.elastic, set.material);
  describe(v, set.substance, set.material);
}

}  // namespace

void describe(KeyVisitor& v, BallSet& set, const Jar& jar) {
  SectionReader* in = v.reader();
  if (in == nullptr) {
    describe_count(v, set);
  } else if (const Node* model = in->find("model")) {
    in->text("model");
    if (const auto entry = find_entry(*in, "media", *model)) in->add_defaults(*entry);
  }
  const bool sound = describe_sizes(v, set);
  describe_material(v, set);
  if (in == nullptr) return;
  set.count = read_count(*in, set, jar);
  if (set.distribution.law == Distribution::Law::equal || !sound || set.count <= 0 ||
      !set.positions.empty())
    return;
  set.classes = read_classes(*in, set.distribution, set.count);
  set.diameter = mean_volume_diameter(set.classes);
}

std::vector<BallSet> read_balls(const Node* list, const Jar& jar, Findings& findings) {
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
  for (const Node& item : list->items) {
    SectionReader in(&item, fmt::format("balls.{}", balls.size() + 1), findings);
    describe(in, balls.emplace_back(), jar);
    in.report_unknown_keys();
  }
  return balls;
}

}  // namespace mahlwerk::cases
