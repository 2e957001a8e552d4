// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [powder]: amount and sizes of the powder, and its simulation as grains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/grinding_fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr NumberSpec mass_of_powder = NumberSpec("mass", "kg", positive, "mass of the powder")
                                          .with({.usual = {"0.1 g", "100 g", true}});
constexpr Presentation grain_size{.label = "grain size", .usual = {"0.01 mm", "5 mm", true}};
constexpr NumberSpec ball_to_powder("ball_to_powder", "", positive,
                                    "mass of the balls over mass of the powder");
constexpr NumberSpec filling_of_powder =
    NumberSpec("filling", "", {.least = 0, .most = 1, .without_least = true},
               "solid volume of the powder over volume of the jar")
        .with({.label = "powder filling"});
constexpr NumberSpec void_filling_of_powder =
    NumberSpec("void_filling", "", positive,
               "U: bulk volume of the powder, with 40 % voids, over the voids between the balls at "
               "rest")
        .with({.label = "powder filling of the voids", .symbol = "$U$"});
constexpr NumberSpec density_of_solid("density", "kg/m3", positive, "density of the solid");
constexpr NumberSpec size_of_grains("grain_size", "m", positive,
                                    "diameter of the spheres that represent the powder");

/// The mass ratio of balls to powder, given as "70:1" or 70.
double read_ball_to_powder(SectionReader& in, const Node& at) {
  const auto colon = at.text.find(':');
  if (at.kind != Node::Kind::text || colon == std::string::npos)
    return in.quantity(at, ball_to_powder);
  try {
    const double ratio =
        parse_in(at.text.substr(0, colon), "") / parse_in(at.text.substr(colon + 1), "");
    if (std::isfinite(ratio) && ratio > 0) return ratio;
    in.fault(at, fmt::format("ball_to_powder = \"{}\" is not a ratio above 0", at.text),
             "write balls to powder by mass: \"30:1\"", "out-of-range");
  } catch (const UnitError& error) {
    in.fault(at, fmt::format("ball_to_powder = \"{}\": {}", at.text, error.what()),
             "write balls to powder by mass, \"30:1\", or the number 30", "bad-quantity");
  }
  return invalid_value;
}

void report_missing_density(SectionReader& in, const Powder& powder, std::string_view why) {
  in.missing("density", fmt::format("density of the solid, which {} needs", why),
             powder.material.empty()
                 ? "write density = \"4930 kg/m3\", or material with a name from `mahlwerk list "
                   "materials`"
                 : fmt::format("the catalogue gives none for {}: write density = \"4930 kg/m3\"",
                               powder.material));
}

/// [kg] The powder's mass, given directly, by ball_to_powder, or by filling of the jar.
double read_powder_mass(SectionReader& in, const Powder& powder, const std::vector<BallSet>& balls,
                        const Jar& jar) {
  const std::string_view key = in.one_of({"mass", "ball_to_powder", "filling", "void_filling"});
  NumberSpec spec = mass_of_powder;
  spec.instead = "ball_to_powder";
  if (key.empty() || key == "mass") return in.value(spec);
  const Node& at = *in.find(key);
  double mass = invalid_value;
  if (key == "ball_to_powder") {
    mass = balls_mass(balls) / read_ball_to_powder(in, at);
  } else {
    if (!powder.density) report_missing_density(in, powder, key);
    const double solid = key == "filling"
                             ? in.quantity(at, filling_of_powder) * jar_volume(jar)
                             : in.quantity(at, void_filling_of_powder) * bed_porosity *
                                   bulk_filling(balls, jar) * jar_volume(jar) * (1 - bed_porosity);
    mass = solid * powder.density.value_or(invalid_value);
  }
  if (!std::isnan(mass))
    in.record_origin("mass", show(mass, "kg"), &at, fmt::format("{} = \"{}\"", key, at.text));
  return mass;
}

/// [m] Diameter of the grains; by default the powder's own size.
double read_grain_size(SectionReader& in, const Powder& powder) {
  if (in.gives("grain_size")) return in.value(size_of_grains);
  if (powder.size && powder.feed.law == powder::Feed::Law::equal) {
    in.record_default("grain_size", show(*powder.size, "m"), "the powder's own size");
    return *powder.size;
  }
  in.missing("grain_size", size_of_grains.about,
             "write for instance grain_size = \"1 mm\", or give `size`");
  return invalid_value;
}

/// The size distribution of the feed. After a fault of its sieves it has one invalid size.
void describe_feed(KeyVisitor& v, Powder& powder) {
  using Law = powder::Feed::Law;
  SectionReader* in = v.reader();
  const std::vector<std::string> words{"equal", "sieves", "lognormal", "rosin-rammler"};
  powder::Feed& feed = powder.feed;
  if (in == nullptr ? feed.law != Law::equal || v.visits_all() : v.gives("distribution"))
    v.word({"distribution",
            words,
            "equal",
            "grains of one size",
            "size distribution of the powder as fed, by mass",
            {"one size", "sieve analysis", "lognormal distribution", "Rosin-Rammler distribution"}},
           feed.law);
  const auto refuse = [&](std::initializer_list<std::string_view> keys) {
    v.refuse(keys, fmt::format("under distribution = \"{}\"", to_word(feed.law, words)),
             "remove it, or choose another distribution");
  };
  if (feed.law == Law::sieves) {
    refuse({"size", "spread"});
    describe_sieves(v, feed.passing, max_powder_sieves);
    if (in != nullptr && feed.passing.empty()) {
      feed = {.size = invalid_value};
      powder.size = invalid_value;
      return;
    }
  } else {
    refuse({"passing", "retained"});
  }
  if (feed.law == Law::equal) {
    refuse({"spread"});
    v.optional_number(NumberSpec("size", "m", positive, "grain size of the powder as fed")
                          .with_default_text("none; [capture] and [grinding] need it")
                          .with(grain_size)
                          .plausible_within("", "0.5 m"),
                      powder.size);
    if (in != nullptr) feed.size = powder.size.value_or(0);
  }
  if (feed.law == Law::lognormal || feed.law == Law::rosin_rammler) {
    const bool normal = feed.law == Law::lognormal;
    v.number(NumberSpec(
                 "size", "m", positive,
                 normal ? "median grain size, by mass" : "grain size that 63.2 % of the mass pass")
                 .with(grain_size)
                 .plausible_within("", "0.5 m"),
             feed.size);
    v.number({"spread", "", feed_spreads(feed.law),
              normal ? "geometric standard deviation" : "exponent of Rosin-Rammler"},
             feed.spread);
  }
  if (in != nullptr && feed.law != Law::equal) powder.size = feed.quantile(0.5);
}

/// The number of grains; 0 after a fault.
std::int64_t grain_count(SectionReader& in, const Powder& powder, double grain) {
  const double exact = powder.mass / grain, count = std::max(1.0, std::round(exact));
  if (std::isnan(exact)) return 0;  // already reported
  constexpr double fair = 0.05;     // largest error of the mass by rounding to whole grains
  if (std::abs(count - exact) > fair * exact) {
    in.fault(
        *in.find("as"),
        fmt::format("the powder ({}) is {:.2g} grains of {}: no whole number of grains has its "
                    "mass",
                    show_rounded(powder.mass, "kg"), exact, show_rounded(*powder.grain_size, "m")),
        "give a smaller grain_size, or more powder", "too-few-grains");
    return 0;
  }
  if (count <= max_grains) {
    in.record_origin("count", fmt::format("{:.0f}", count), in.find("as"),
                     "mass of the powder over that of a grain");
    return static_cast<std::int64_t>(count);
  }
  constexpr double advised = 1e5;
  const Node* at = in.find("grain_size") != nullptr ? in.find("grain_size") : in.find("size");
  in.fault(
      *at,
      fmt::format("grains of {} would be {:.3g}, more than {:.0e}",
                  show_rounded(*powder.grain_size, "m"), count, max_grains),
      fmt::format("write grain_size = \"{}\": some {:.0e} grains",
                  show_rounded(*powder.grain_size * math::cbrt(count / advised), "m", 2), advised),
      "too-many-grains");
  return 0;
}

/// The ball set that represents the powder.
BallSet read_grains(SectionReader& in, Powder& powder) {
  powder.grain_size = read_grain_size(in, powder);
  BallSet set{.count = 0,
              .diameter = *powder.grain_size,
              .density = powder.density.value_or(invalid_value),
              .material = powder.material,
              .grains = true};
  describe(in, set.elastic, powder.material);
  describe(in, set.substance, powder.material);
  if (!powder.density && in.find("filling") == nullptr && in.find("void_filling") == nullptr)
    report_missing_density(in, powder, "as = \"grains\"");
  if (powder.size && *powder.grain_size < *powder.size)
    in.fault(*in.find("grain_size"),
             fmt::format("grain_size ({}) is smaller than the powder's own size ({})",
                         show_rounded(*powder.grain_size, "m"), show_rounded(*powder.size, "m")),
             "a grain represents one particle or more: give a larger grain_size", "out-of-range");
  set.count = grain_count(in, powder, set.mass());
  return set;
}

/// Appends the powder to `balls` if it is simulated as grains.
void read_part(SectionReader& in, Powder& powder, std::vector<BallSet>& balls) {
  if (in.gives("as") && in.choice({"as", {"mass", "grains"}, ""}) == "grains")
    balls.push_back(read_grains(in, powder));
  else
    in.refuse({"grain_size", "youngs_modulus", "poisson_ratio", "hardness", "conductivity",
               "heat_capacity"},
              "unless the powder is simulated as grains", "remove it, or write as = \"grains\"");
}

}  // namespace

void describe(KeyVisitor& v, Powder& powder, std::vector<BallSet>& balls, const Jar& jar) {
  if (SectionReader* in = v.reader()) {
    powder.density = read_density(*in, density_of_solid, powder.material);
    powder.mass = read_powder_mass(*in, powder, balls, jar);
    describe_feed(v, powder);
    return read_part(*in, powder, balls);
  }
  v.text({"material", "material of the powder, by its name in the catalogue"}, powder.material);
  v.number(mass_of_powder, powder.mass);
  v.alternative(ball_to_powder.in_place_of("mass"));
  v.alternative(filling_of_powder.in_place_of("mass"));
  v.alternative(void_filling_of_powder.in_place_of("mass"));
  describe_feed(v, powder);
  v.optional_number(density_of_solid.with_default_text("that of the material"), powder.density);
  if (!powder.grain_size || balls.empty()) return;
  std::size_t grains = 1;
  v.choose({"as",
            {"mass", "grains"},
            "mass",
            "powder is not simulated as particles",
            "how the powder takes part in the simulation",
            {"only its mass counts", "spheres of grain_size represent it"}},
           grains);
  if (grains == 0) return;
  v.optional_number(size_of_grains.with_default_text("the size of the powder"), powder.grain_size);
  describe(v, balls.back().elastic, powder.material);
  describe(v, balls.back().substance, powder.material);
}

}  // namespace mahlwerk::cases
