// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a ball set says of the sizes of its balls.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read_parts.hpp"

namespace mahlwerk::cases {
namespace {

using SizeLaw = Distribution::Law;

/// Keys that a law has no use for.
void refuse(Section& in, SizeLaw law, std::initializer_list<std::string_view> keys) {
  const std::string& word = distribution_words()[static_cast<std::size_t>(law)];
  in.refuse(keys, fmt::format("under distribution = \"{}\"", word),
            "remove it, or choose another distribution");
}

/// The numbers of normal, lognormal or uniform. False after a fault.
bool read_numbers(Section& in, Distribution& d) {
  if (d.law == SizeLaw::uniform) {
    d.smallest = in.value({"smallest", "m", positive, "diameter of the smallest balls"});
    d.largest = in.value({"largest", "m", positive, "diameter of the largest balls"});
    if (d.largest <= d.smallest)
      in.fault(*in.find("largest"),
               fmt::format("largest ({}) is not above smallest ({})", show_rounded(d.largest, "m"),
                           show_rounded(d.smallest, "m")),
               "exchange them, or write distribution = \"equal\"", "out-of-range");
    return d.largest > d.smallest;
  }
  const bool normal = d.law == SizeLaw::normal;
  d.diameter = in.value({"diameter", "m", positive,
                         normal ? "mean diameter, by number" : "median diameter, by number"});
  constexpr Range deviations{.least = 0, .most = 0.3, .without_least = true};
  constexpr Range ratios{.least = 1, .most = 2, .without_least = true};
  d.spread = in.value({"spread", "", normal ? deviations : ratios,
                       normal ? "standard deviation over the mean diameter"
                              : "geometric standard deviation, a pure number above 1"});
  return !std::isnan(d.diameter) && !std::isnan(d.spread);
}

SizeLaw read_distribution_word(Section& in) {
  if (!in.gives("distribution")) return SizeLaw::equal;
  const std::string word = in.choice({"distribution", distribution_words(), ""});
  const auto at = std::ranges::find(distribution_words(), word);
  return at == distribution_words().end() ? SizeLaw::equal
                                          : static_cast<SizeLaw>(at - distribution_words().begin());
}

}  // namespace

bool read_distribution(Section& in, Distribution& d) {
  d.law = read_distribution_word(in);
  bool sound = true;
  if (d.law == SizeLaw::equal) {
    refuse(in, d.law, {"spread", "smallest", "largest", "passing", "retained", "classes"});
    return true;
  }
  if (d.law == SizeLaw::sieves) {
    refuse(in, d.law, {"diameter", "spread", "smallest", "largest", "classes"});
    d.passing = read_sieves(in, most_classes);
    sound = !d.passing.empty();
  } else {
    refuse(in, d.law, {"passing", "retained"});
    if (d.law == SizeLaw::uniform)
      refuse(in, d.law, {"diameter", "spread"});
    else
      refuse(in, d.law, {"smallest", "largest"});
    sound = read_numbers(in, d);
    if (in.gives("classes")) d.classes = in.whole("classes", most_classes).value_or(0);
  }
  if (const Node* places = in.find("positions"); places != nullptr)
    in.fault(*places, "balls whose sizes differ cannot be told where to start",
             "give each size a set of its own, with its positions", "too-much");
  return sound;
}

std::vector<SizeClass> read_classes(Section& in, Distribution& d, std::int64_t count) {
  if (d.classes == 0 && d.law != SizeLaw::sieves) {
    d.classes = classes_that_fill(d, count);
    in.note_default("classes", std::to_string(d.classes),
                    fmt::format("{} at most, and a ball in each", usual_classes));
  }
  const std::vector<SizeShare> shares = size_shares(d);
  const std::vector<std::int64_t> counts = counted_out(count, shares);
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
