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

using Law = Distribution::Law;
constexpr std::string_view form =
    "write rows of opening and share of the mass: [[\"8 mm\", \"0 %\"], [\"10 mm\", \"40 %\"], "
    "[\"12 mm\", \"100 %\"]]";
constexpr std::size_t most_rows = static_cast<std::size_t>(most_classes) + 1;

/// Opening and share of one row; nothing after a fault.
std::optional<std::array<double, 2>> read_row(Section& in, std::string_view key, const Node& row) {
  if (row.kind != Node::Kind::list || row.items.size() != 2) {
    in.fault(row, fmt::format("a row of `{}` must be an opening and a share of the mass", key),
             std::string(form), "wrong-type");
    return std::nullopt;
  }
  constexpr Range shares{.least = 0, .most = 1};
  const double opening = in.quantity(row.items[0], {key, "m", positive, "opening of a sieve"});
  const double share = in.quantity(row.items[1], {key, "", shares, "share of the mass"});
  if (std::isnan(opening) || std::isnan(share)) return std::nullopt;
  return std::array{opening, share};
}

/// Rows with rising openings; none after a fault.
std::vector<std::array<double, 2>> read_rows(Section& in, std::string_view key, const Node& at) {
  std::vector<std::array<double, 2>> rows;
  if (at.kind != Node::Kind::list || at.items.size() < 2 || at.items.size() > most_rows) {
    in.fault(at, fmt::format("`{}` must be a list of 2 to {} rows", key, most_rows),
             std::string(form), "wrong-type");
    return rows;
  }
  bool sound = true;
  for (const Node& item : at.items) {
    const auto row = read_row(in, key, item);
    sound = sound && row;
    if (!row) continue;
    if (!rows.empty() && row->at(0) <= rows.back()[0]) {
      in.fault(item, fmt::format("the openings of `{}` do not rise", key),
               "sort the rows by opening, each once", "unsorted-sieves");
      sound = false;
    }
    rows.push_back(*row);
  }
  if (!sound) rows.clear();
  return rows;
}

/// Shares retained by each sieve as shares that pass it.
std::vector<std::array<double, 2>> passing_of(Section& in, const Node& at,
                                              std::vector<std::array<double, 2>> rows) {
  constexpr double rounding = 1e-9;
  if (rows.empty()) return rows;
  double sum = 0;
  for (auto& [opening, share] : rows) {
    const double kept = share;
    share = sum;
    sum += kept;
  }
  if (std::abs(sum - 1) > rounding) {
    in.fault(at,
             fmt::format("the shares of `retained` sum to {} %, not to 100 %",
                         show_rounded(100 * sum, "")),
             "give the share of the mass that each sieve keeps; together they are all of it",
             "sieve-shares");
    return {};
  }
  if (rows.back()[1] < sum) {
    in.fault(at, "the largest sieve of `retained` keeps balls, of which none has a largest size",
             "add a row with a larger opening and \"0 %\"", "sieve-shares");
    return {};
  }
  rows.back()[1] = 1;
  return rows;
}

/// Whether shares rise from 0 to 1.
bool cumulative(Section& in, const Node& at, const std::vector<std::array<double, 2>>& rows) {
  const auto fault = [&](std::string what, std::string remedy) {
    in.fault(at, std::move(what), std::move(remedy), "sieve-shares");
    return false;
  };
  if (rows.empty()) return false;
  if (rows.back()[1] != 1)
    return fault(fmt::format("{} % of the mass pass the largest sieve of `passing`, not 100 %",
                             show_rounded(100 * rows.back()[1], "")),
                 "add a row with the opening that everything passes and \"100 %\"");
  if (rows.front()[1] != 0)
    return fault("what passes the smallest sieve of `passing` has no smallest size",
                 "add a row with a smaller opening and \"0 %\"");
  if (!std::ranges::is_sorted(rows, {}, [](const auto& row) { return row[1]; }))
    return fault("the shares of `passing` fall", "give the whole mass that passes each sieve");
  return true;
}

/// Of sieves; empty after a fault.
std::vector<std::array<double, 2>> read_sieves(Section& in) {
  const std::string_view key = in.one_of({"passing", "retained"});
  if (key.empty()) {
    in.missing("passing", "openings of sieves with the share of the mass that passes them",
               fmt::format("write passing = ..., or retained: {}", form));
    return {};
  }
  const Node& at = *in.find(key);
  auto rows = read_rows(in, key, at);
  if (key == "retained") rows = passing_of(in, at, std::move(rows));
  if (!rows.empty() && !cumulative(in, at, rows)) rows.clear();
  if (!rows.empty()) {
    Distribution noted;
    noted.passing = rows;
    in.note("passing", passing_text(noted), &at, key == "retained" ? "from `retained`" : "");
  }
  return rows;
}

/// Keys that a law has no use for.
void refuse(Section& in, Law law, std::initializer_list<std::string_view> keys) {
  const std::string& word = distribution_words()[static_cast<std::size_t>(law)];
  for (const std::string_view key : keys)
    if (const Node* at = in.find(key); at != nullptr)
      in.fault(*at, fmt::format("{} has no meaning under distribution = \"{}\"", key, word),
               "remove it, or choose another distribution", "too-much");
}

/// The numbers of normal, lognormal or uniform. False after a fault.
bool read_numbers(Section& in, Distribution& d) {
  if (d.law == Law::uniform) {
    d.smallest = in.value({"smallest", "m", positive, "diameter of the smallest balls"});
    d.largest = in.value({"largest", "m", positive, "diameter of the largest balls"});
    if (d.largest <= d.smallest)
      in.fault(*in.find("largest"),
               fmt::format("largest ({}) is not above smallest ({})", show_rounded(d.largest, "m"),
                           show_rounded(d.smallest, "m")),
               "exchange them, or write distribution = \"equal\"", "out-of-range");
    return d.largest > d.smallest;
  }
  const bool normal = d.law == Law::normal;
  d.diameter = in.value({"diameter", "m", positive,
                         normal ? "mean diameter, by number" : "median diameter, by number"});
  constexpr Range deviations{.least = 0, .most = 0.3, .without_least = true};
  constexpr Range ratios{.least = 1, .most = 2, .without_least = true};
  d.spread = in.value({"spread", "", normal ? deviations : ratios,
                       normal ? "standard deviation over the mean diameter"
                              : "geometric standard deviation, a pure number above 1"});
  return !std::isnan(d.diameter) && !std::isnan(d.spread);
}

Law read_distribution_word(Section& in) {
  if (!in.gives("distribution")) return Law::equal;
  const std::string word = in.choice({"distribution", distribution_words(), ""});
  const auto at = std::ranges::find(distribution_words(), word);
  return at == distribution_words().end() ? Law::equal
                                          : static_cast<Law>(at - distribution_words().begin());
}

}  // namespace

bool read_distribution(Section& in, Distribution& d) {
  d.law = read_distribution_word(in);
  bool sound = true;
  if (d.law == Law::equal) {
    refuse(in, d.law, {"spread", "smallest", "largest", "passing", "retained", "classes"});
    return true;
  }
  if (d.law == Law::sieves) {
    refuse(in, d.law, {"diameter", "spread", "smallest", "largest", "classes"});
    d.passing = read_sieves(in);
    sound = !d.passing.empty();
  } else {
    refuse(in, d.law, {"passing", "retained"});
    if (d.law == Law::uniform)
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
  if (d.classes == 0 && d.law != Law::sieves) {
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
             d.law == Law::sieves ? "give more balls, or join this sieve with the next"
                                  : "give more balls, or fewer classes",
             "empty-size-class");
    break;
  }
  return classes;
}

}  // namespace mahlwerk::cases
