// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The size distribution of a ball set.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

using SizeLaw = Distribution::Law;

constexpr Presentation ball_diameter{
    .label = "ball diameter", .symbol = "$d$", .usual = {"1 mm", "60 mm", true}};

/// The parameters of a normal, lognormal or uniform distribution. False after a fault.
bool describe_spread(KeyVisitor& v, Distribution& d) {
  if (d.law == SizeLaw::uniform) {
    v.number({"smallest", "m", positive, "diameter of the smallest balls"}, d.smallest);
    v.number({"largest", "m", positive, "diameter of the largest balls"}, d.largest);
    if (SectionReader* in = v.reader(); in != nullptr && d.largest <= d.smallest)
      in->fault(*in->find("largest"),
                fmt::format("largest ({}) is not above smallest ({})", show_rounded(d.largest, "m"),
                            show_rounded(d.smallest, "m")),
                "swap them, or write distribution = \"equal\"", "out-of-range");
    return d.largest > d.smallest;
  }
  const bool normal = d.law == SizeLaw::normal;
  v.number(NumberSpec("diameter", "m", positive,
                      normal ? "mean diameter, by number" : "median diameter, by number")
               .with(ball_diameter)
               .plausible_within("", "0.5 m"),
           d.diameter);
  constexpr double least = 1e-3;  // less is one size within rounding
  constexpr Range deviations{.least = least, .most = 0.3}, ratios{.least = 1 + least, .most = 2};
  v.number({"spread", "", normal ? deviations : ratios,
            normal ? "standard deviation over the mean diameter"
                   : "geometric standard deviation, a pure number above 1"},
           d.spread);
  return !std::isnan(d.diameter) && !std::isnan(d.spread);
}

/// The number of size classes; if it is not given, read_classes() derives it from the number of
/// balls.
void describe_classes(KeyVisitor& v, Distribution& d) {
  if (v.reader() == nullptr || v.gives("classes"))
    v.integer({.key = "classes",
               .least = 1,
               .most = max_classes,
               .about = "number of sizes that represent the distribution",
               .default_text = "12 at most, and a ball in each"},
              d.classes);
}

/// Faults for given keys that the law does not use.
void refuse_others(KeyVisitor& v, SizeLaw law) {
  const auto useless = [&](std::initializer_list<std::string_view> keys) {
    v.refuse(keys, fmt::format("under distribution = \"{}\"", to_word(law, distribution_words())),
             "remove it, or choose another distribution");
  };
  switch (law) {
    case SizeLaw::equal:
      return useless({"spread", "smallest", "largest", "passing", "retained", "classes"});
    case SizeLaw::sieves:
      return useless({"diameter", "spread", "smallest", "largest", "classes"});
    case SizeLaw::uniform:
      return useless({"passing", "retained", "diameter", "spread"});
    default:
      return useless({"passing", "retained", "smallest", "largest"});
  }
}

}  // namespace

bool describe(KeyVisitor& v, Distribution& d, double& diameter) {
  const SectionReader* in = v.reader();
  if (in == nullptr ? d.law != SizeLaw::equal || v.visits_all() : v.gives("distribution"))
    v.word({"distribution",
            distribution_words(),
            "equal",
            "balls of one size",
            "distribution of the diameters",
            {"one diameter", "normal distribution by number", "lognormal distribution by number",
             "all diameters between two limits equally often", "sieve analysis, by mass"}},
           d.law);
  refuse_others(v, d.law);
  if (d.law == SizeLaw::equal) {
    v.number(NumberSpec("diameter", "m", positive, "diameter of a ball")
                 .with(ball_diameter)
                 .plausible_within("", "0.5 m"),
             diameter);
    return true;
  }
  bool sound = true;
  if (d.law == SizeLaw::sieves) {
    describe_sieves(v, d.passing, max_classes);
    sound = !d.passing.empty();
  } else {
    sound = describe_spread(v, d);
    describe_classes(v, d);
  }
  return sound;
}

std::vector<SizeClass> read_classes(SectionReader& in, Distribution& d, std::int64_t count) {
  if (d.classes == 0 && d.law != SizeLaw::sieves) {
    d.classes = max_filled_classes(d, count);
    in.record_default("classes", std::to_string(d.classes),
                      fmt::format("{} at most, and a ball in each", default_classes));
  }
  const std::vector<SizeShare> shares = size_shares(d);
  const std::vector<std::int64_t> counts = apportion(count, shares);
  std::vector<SizeClass> classes;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    classes.push_back({shares[i].diameter, counts[i]});
    if (counts[i] > 0) continue;
    const Node* at = in.find("classes") != nullptr ? in.find("classes") : in.find("distribution");
    in.fault(*at,
             fmt::format("none of the {} balls falls between {} and {}", count,
                         show_rounded(shares[i].low, "m"), show_rounded(shares[i].high, "m")),
             d.law == SizeLaw::sieves ? "give more balls, or join this sieve with the next"
                                      : "give more balls, or fewer classes",
             "empty-size-class");
    break;
  }
  return classes;
}

}  // namespace mahlwerk::cases
