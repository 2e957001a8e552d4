// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

/// Tells how far the nearest whole number of balls is from what the case asks for.
void remark_on_rounding(SectionReader& in, const Node& at, std::string_view key, double share,
                        double count) {
  constexpr double told = 0.01, large = 0.05;
  const double deviation = count / share - 1;
  if (!(std::abs(deviation) > told)) return;
  const NumberText asked = number_text(at.text);
  const std::string text = fmt::format(
      "[[{}]]: {} = \"{}\" is {} balls. The nearest whole number is {}, which makes {} {}: {:+.1f} "
      "%.",
      in.name(), key, at.text, show_rounded(share, ""), count,
      show_rounded(asked.number * count / share, ""), asked.rest, 100 * deviation);
  in.findings().remarks.push_back(std::abs(deviation) > large ? warning("count-rounded", text)
                                                              : note("count-rounded", text));
}

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
  remark_on_rounding(in, at, key, share, n);
  return count;
}

/// A list of vectors, one for each ball of a set, in the jar's own axes.
struct VectorList {
  NumberSpec component;
  std::string_view example;
};
const VectorList position_list{
    {"positions", "m", any_number, "positions of ball centres, from the jar's centre"},
    "[\"9 mm\", \"0 mm\", \"-7.74 mm\"]"};
const VectorList velocity_list{
    {"velocities", "m/s", any_number, "initial velocities of the balls of `positions`"},
    "[\"1 m/s\", \"0 m/s\", \"0 m/s\"]"};
const VectorList spin_list{
    {"spins", "rad/s", any_number, "initial spins of the balls of `positions`"},
    "[\"0 rad/s\", \"20 rad/s\", \"0 rad/s\"]"};

/// The vector of one ball; no value after a fault.
std::optional<Vec3> read_vector(SectionReader& in, const VectorList& list, const Node& row,
                                std::size_t number) {
  if (row.kind != Node::Kind::list || row.items.size() != 3) {
    in.fault(row,
             fmt::format("ball {} of `{}` must have three {}", number, list.component.key,
                         &list == &position_list ? "coordinates" : "components"),
             fmt::format("write x, y, z in the jar's own axes: {}", list.example), "wrong-type");
    return std::nullopt;
  }
  std::array<double, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) at[i] = in.quantity(row.items[i], list.component);
  const Vec3 vector{at[0], at[1], at[2]};
  return std::isnan(vector.x + vector.y + vector.z) ? std::nullopt : std::optional(vector);
}

std::string vectors_text(const VectorList& list, const std::vector<Vec3>& vectors) {
  const std::string_view unit = list.component.unit;
  std::string rows;
  for (const Vec3& p : vectors)
    rows += fmt::format("{}[{}, {}, {}]", rows.empty() ? "" : ", ", in_quotes(show(p.x, unit)),
                        in_quotes(show(p.y, unit)), in_quotes(show(p.z, unit)));
  return "[" + rows + "]";
}

/// One vector for each ball of a set; none after a fault.
std::vector<Vec3> read_vectors(SectionReader& in, const VectorList& list, const Node& at) {
  std::vector<Vec3> vectors;
  const std::string_view key = list.component.key;
  bool sound = at.kind == Node::Kind::list && !at.items.empty();
  if (!sound)
    in.fault(at, fmt::format("`{}` must be a list of {}", key, key),
             fmt::format("write {} = [{}]", key, list.example), "wrong-type");
  for (const Node& row : at.items) {
    const auto vector = read_vector(in, list, row, vectors.size() + 1);
    sound = sound && vector;
    vectors.push_back(vector.value_or(Vec3{}));
  }
  if (!sound) return {};
  in.record_origin(key, vectors_text(list, vectors), &at);
  return vectors;
}

/// The initial positions of the balls of a set, which are also its number; none after a fault.
std::vector<Vec3> read_positions(SectionReader& in, const Node& at) {
  std::vector<Vec3> positions = read_vectors(in, position_list, at);
  if (!positions.empty())
    in.record_origin("count", std::to_string(positions.size()), &at, "one for each of `positions`");
  return positions;
}

/// The initial velocities or spins of balls with given positions.
std::vector<Vec3> read_motion(SectionReader& in, const VectorList& list, const BallSet& set) {
  const std::string_view key = list.component.key;
  const Node* at = in.find(key);
  if (at == nullptr) return {};
  if (!in.gives("positions")) {
    in.fault(*at, fmt::format("`{}` needs `positions`: random balls have random speeds", key),
             "give the positions of the balls, or run.start_speed and run.start_spin", "too-much");
    return {};
  }
  std::vector<Vec3> vectors = read_vectors(in, list, *at);
  if (vectors.empty() || set.positions.empty() || vectors.size() == set.positions.size())
    return vectors;
  in.fault(*at,
           fmt::format("`{}` has {} entries for {} `positions`", key, vectors.size(),
                       set.positions.size()),
           "give one for each ball, in the order of the positions", "wrong-type");
  return {};
}

constexpr NumberSpec mass_of_set("mass", "kg", positive, "mass of all balls of this set");
constexpr NumberSpec filling_of_set =
    NumberSpec("filling", "", {.least = 0, .most = 1, .without_least = true},
               "volume of the balls over volume of the jar")
        .with({.label = "solid filling of balls", .usual = {"1 %", "50 %"}});

constexpr NumberSpec bulk_filling_of_set =
    NumberSpec("bulk_filling", "", {.least = 0, .most = 1, .without_least = true},
               "J: bulk volume of the balls, with 40 % voids, over volume of the jar")
        .with({.label = "bulk filling of balls", .symbol = "$J$"});

/// Warns of a solid filling that was probably meant as J: mills are filled to 20 to 45 % in bulk.
/// unusual_values() drops the warning where the jar is no drum.
void remark_on_filling(SectionReader& in, const Node& at, double filling) {
  constexpr double most = 0.45;
  const double bulk = filling / (1 - bed_porosity);
  if (!(bulk > most)) return;
  in.findings().remarks.push_back(warning(
      "solid-filling",
      fmt::format(
          "[[{}]]: filling = \"{}\" is the volume of the balls without the voids between "
          "them. With the voids they fill {} % of the drum; mills are filled to 20 to 45 %. "
          "If you mean J, the bulk filling, write bulk_filling in place of filling.",
          in.name(), at.text, show_rounded(100 * bulk, "", 2))));
}

/// The number of balls, given directly, by mass, by filling of the jar, or by initial positions.
std::int64_t read_count(SectionReader& in, BallSet& set, const Jar& jar) {
  const std::string_view key = in.one_of({"count", "mass", "filling", "bulk_filling", "positions"});
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
  const double filling = key == "filling"
                             ? in.quantity(at, filling_of_set)
                             : (1 - bed_porosity) * in.quantity(at, bulk_filling_of_set);
  if (key == "filling") remark_on_filling(in, at, filling);
  return nearest_count(in, at, key, filling * jar_volume(jar) / ball_volume(set));
}

/// [m] Diameter of the ball of mean volume; it does not depend on the number of classes.
double mean_diameter(Distribution of) {
  of.classes = std::max<std::int64_t>(of.classes, 1);
  return mean_volume_diameter(size_shares(of));
}

void describe_count(KeyVisitor& v, BallSet& set) {
  if (std::string name; v.visits_all())
    v.text({"model", "name of a ball set in the catalogue, which gives size, material and number"},
           name);
  v.alternative(mass_of_set.in_place_of("count"));
  v.alternative(filling_of_set.in_place_of("count"));
  v.alternative(bulk_filling_of_set.in_place_of("count"));
  const auto vectors = [&](const VectorList& list, const std::vector<Vec3>& given) {
    if (given.empty() && !v.visits_all()) return;
    const bool sound =
        (given.empty() || std::cmp_equal(given.size(), set.count)) &&
        std::ranges::all_of(given, [](const Vec3& p) { return std::isfinite(norm(p)); });
    v.custom({.key = list.component.key,
              .about = list.component.about,
              .sound = sound,
              .instead = &list == &position_list ? "count" : ""},
             [&] { return vectors_text(list, given); });
  };
  vectors(position_list, set.positions);
  vectors(velocity_list, set.velocities);
  vectors(spin_list, set.spins);
  if (set.positions.empty() || v.visits_all())
    v.integer({.key = "count",
               .least = 1,
               .most = max_balls,
               .about = "number of balls",
               .standard = 1,
               .source = "one ball",
               .presentation = {.label = "number of balls",
                                .symbol = "$N$",
                                .usual = {"1", "200", true}}},
              set.count);
}

/// False after a fault.
bool describe_sizes(KeyVisitor& v, BallSet& set) {
  if (describe_body(v, set.body, set.diameter)) return !std::isnan(set.diameter);
  const bool sound = describe(v, set.distribution, set.diameter);
  SectionReader* in = v.reader();
  if (in == nullptr || set.distribution.law == Distribution::Law::equal) return sound;
  set.diameter = sound ? mean_diameter(set.distribution) : invalid_value;
  if (const Node* positions = in->find("positions"); positions != nullptr)
    in->fault(*positions, "a set with a size distribution cannot have given positions",
              "give each size a set of its own, with its positions", "too-much");
  return sound;
}

constexpr NumberSpec wall_of_ball("wall_thickness", "m", positive,
                                  "shell of hollow balls, of their density; left out: solid");
constexpr NumberSpec coating_of_ball("coating_thickness", "m", positive,
                                     "layer of another density on a ball; left out: none");
constexpr NumberSpec coating_density("coating_density", "kg/m3", positive,
                                     "density of the coating; with coating_thickness");

/// Hollow and coated balls. The number of balls of a size distribution follows from the mass of
/// solid ones, and layers of one thickness would make the small ones denser or lighter.
void describe_layers(KeyVisitor& v, BallSet& set) {
  if (!set.body.is_sphere()) return;  // describe_body() refuses them
  SectionReader* in = v.reader();
  if (in != nullptr && set.distribution.law != Distribution::Law::equal) {
    in->refuse({wall_of_ball.key, coating_of_ball.key, coating_density.key},
               "for balls of several sizes", "give each size a set of its own");
    return;
  }
  v.optional_number(wall_of_ball, set.wall_thickness);
  v.optional_number(coating_of_ball, set.coating_thickness);
  v.optional_number(coating_density, set.coating_density);
}

void describe_material(KeyVisitor& v, BallSet& set) {
  const NumberSpec density = NumberSpec("density", "kg/m3", positive, "density of a ball")
                                 .with({.usual = {"1000 kg/m3", "16000 kg/m3"}});
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
    v.number(density.with_default_text("that of the material"), set.density);
    v.text({"material", "material of the balls, by its name in the catalogue"}, set.material);
  }
  describe(v, set.elastic, set.material);
  describe(v, set.substance, set.material);
  describe_layers(v, set);
}

}  // namespace

void describe(KeyVisitor& v, BallSet& set, const Jar& jar) {
  SectionReader* in = v.reader();
  if (in == nullptr) {
    describe_count(v, set);
  } else if (const Node* model = in->find("model")) {
    const auto name = in->entry_name("model", "media");
    if (const auto entry = name ? find_entry(*in, "media", *name, *model) : std::nullopt)
      in->add_defaults(*entry);
  }
  const bool sound = describe_sizes(v, set);
  describe_material(v, set);
  if (in == nullptr) return;
  set.count = read_count(*in, set, jar);
  set.velocities = read_motion(*in, velocity_list, set);
  set.spins = read_motion(*in, spin_list, set);
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
