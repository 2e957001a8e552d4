// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// [powder]: how much of what there is, and whether it takes part as grains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/grinding_fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

/// "70:1" or 70, balls to powder by mass.
double read_ball_to_powder(Section& in, const Node& at) {
  const Wanted wanted("ball_to_powder", "", positive, "mass of the balls over mass of the powder");
  const auto colon = at.text.find(':');
  if (at.kind != Node::Kind::text || colon == std::string::npos) return in.quantity(at, wanted);
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
  return unread;
}

void no_density(Section& in, const Powder& powder, std::string_view why) {
  in.missing("density", fmt::format("density of the solid, which {} needs", why),
             powder.material.empty()
                 ? "write density = \"4930 kg/m3\", or material with a name `mahlwerk list "
                   "materials` shows"
                 : fmt::format("the catalogue gives none for {}: write density = \"4930 kg/m3\"",
                               powder.material));
}

/// By mass, by the balls' mass over it, or by its solid share of the jar's volume.
double read_powder_mass(Section& in, const Powder& powder, const Case& c) {
  const std::string_view key = in.one_of({"mass", "ball_to_powder", "filling"});
  Wanted wanted("mass", "kg", positive, "mass of the powder");
  wanted.instead = "ball_to_powder";
  if (key.empty() || key == "mass") return in.value(wanted);
  const Node& at = *in.find(key);
  double mass = unread;
  if (key == "ball_to_powder") {
    mass = balls_mass(c.balls) / read_ball_to_powder(in, at);
  } else {
    constexpr Range share{.least = 0, .most = 1, .without_least = true};
    const double filling = in.quantity(
        at, {"filling", "", share, "solid volume of the powder over volume of the jar"});
    if (!powder.density) no_density(in, powder, "filling");
    mass = filling * jar_volume(c.jar) * powder.density.value_or(unread);
  }
  if (!std::isnan(mass))
    in.note("mass", show(mass, "kg"), &at, fmt::format("{} = \"{}\"", key, at.text));
  return mass;
}

/// How large the spheres are; of the powder's own size unless said otherwise.
double read_grain_size(Section& in, const Powder& powder) {
  const Wanted wanted("grain_size", "m", positive,
                      "diameter of the spheres that stand for the powder");
  if (in.gives("grain_size")) return in.value(wanted);
  if (powder.size && powder.feed.law == powder::Feed::Law::equal) {
    in.note_default("grain_size", show(*powder.size, "m"), "each grain for itself");
    return *powder.size;
  }
  in.missing("grain_size", wanted.about,
             "write for instance grain_size = \"1 mm\", or give `size`");
  return unread;
}

/// The feed's law with its numbers; of the one size, unread, after a fault.
powder::Feed read_feed(Section& in) {
  using Law = powder::Feed::Law;
  constexpr std::string_view remedy = "remove it, or choose another distribution";
  const auto word = in.gives("distribution") ? in.choice({"distribution", feed_words(), ""}) : "";
  const Law law = word.empty() ? Law::equal : word_of<Law>(word, feed_words());
  const std::string why =
      fmt::format("under distribution = \"{}\"", feed_words()[static_cast<std::size_t>(law)]);
  powder::Feed feed{.law = law};
  if (law == Law::sieves) {
    in.refuse({"size", "spread"}, why, std::string(remedy));
    feed.passing = read_sieves(in, most_powder_sieves);
    return feed.passing.empty() ? powder::Feed{.size = unread} : feed;
  }
  in.refuse({"passing", "retained"}, why, std::string(remedy));
  if (law == Law::equal) {
    in.refuse({"spread"}, why, std::string(remedy));
    feed.size = in.maybe({"size", "m", positive, "grain size of the powder as fed"}).value_or(0);
    return feed;
  }
  const bool normal = law == Law::lognormal;
  feed.size =
      in.value({"size", "m", positive,
                normal ? "median grain size, by mass" : "grain size that 63.2 % of the mass pass"});
  feed.spread = in.value({"spread", "", feed_spreads(law),
                          normal ? "geometric standard deviation" : "exponent of Rosin-Rammler"});
  return feed;
}

/// How many grains there are; 0 after a fault.
std::int64_t grain_count(Section& in, const Powder& powder, double grain) {
  const double exact = powder.mass / grain, count = std::max(1.0, std::round(exact));
  if (std::isnan(exact)) return 0;  // reported where it comes from
  constexpr double fair = 0.05;     // of the mass, that whole grains may be off by
  if (std::abs(count - exact) > fair * exact) {
    in.fault(
        *in.find("as"),
        fmt::format("the powder ({}) is {:.2g} grains of {}: whole grains would not have its "
                    "mass",
                    show_rounded(powder.mass, "kg"), exact, show_rounded(*powder.grain_size, "m")),
        "give a smaller grain_size, or more powder", "too-few-grains");
    return 0;
  }
  if (count <= most_grains) {
    in.note("count", fmt::format("{:.0f}", count), in.find("as"),
            "mass of the powder over that of a grain");
    return static_cast<std::int64_t>(count);
  }
  constexpr double advised = 1e5;
  const Node* at = in.find("grain_size") != nullptr ? in.find("grain_size") : in.find("size");
  in.fault(
      *at,
      fmt::format("grains of {} would be {:.3g}, more than {:.0e}",
                  show_rounded(*powder.grain_size, "m"), count, most_grains),
      fmt::format("write grain_size = \"{}\": some {:.0e} grains",
                  show_rounded(*powder.grain_size * std::cbrt(count / advised), "m", 2), advised),
      "too-many-grains");
  return 0;
}

/// The ball set that stands for the powder.
BallSet read_grains(Section& in, Powder& powder, const Catalogue& catalogue) {
  powder.grain_size = read_grain_size(in, powder);
  BallSet set{.count = 0,
              .diameter = *powder.grain_size,
              .density = powder.density.value_or(unread),
              .material = powder.material,
              .elastic = read_elastic(in, powder.material, catalogue),
              .substance = read_substance(in, powder.material, catalogue),
              .grains = true};
  if (!powder.density && in.find("filling") == nullptr) no_density(in, powder, "as = \"grains\"");
  if (powder.size && *powder.grain_size < *powder.size)
    in.fault(*in.find("grain_size"),
             fmt::format("grain_size ({}) is smaller than the powder's own size ({})",
                         show_rounded(*powder.grain_size, "m"), show_rounded(*powder.size, "m")),
             "a grain stands for one particle or more: give a larger grain_size", "out-of-range");
  set.count = grain_count(in, powder, set.mass());
  return set;
}

}  // namespace

void read_powder(const Node* table, Case& c, const Catalogue& catalogue, Findings& findings) {
  Section in(table, "powder", findings);
  Powder& powder = c.powder.emplace();
  powder.density = read_density(in, {"density", "kg/m3", positive, "density of the solid"},
                                powder.material, catalogue);
  powder.mass = read_powder_mass(in, powder, c);
  powder.feed = read_feed(in);
  if (powder.feed.law != powder::Feed::Law::equal || powder.feed.size != 0)
    powder.size = powder.feed.quantile(0.5);
  const bool grains = in.gives("as") && in.choice({"as", powder_words(), ""}) == "grains";
  if (grains) {
    c.balls.push_back(read_grains(in, powder, catalogue));
  } else {
    for (const std::string_view key : {"grain_size", "youngs_modulus", "poisson_ratio", "hardness",
                                       "conductivity", "heat_capacity"})
      if (const Node* at = in.find(key); at != nullptr)
        in.fault(*at, fmt::format("{} has no meaning unless the powder takes part as grains", key),
                 "remove it, or write as = \"grains\"", "too-much");
  }
  in.close();
}

}  // namespace mahlwerk::cases
