// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A sieve analysis, of balls or of powder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::string_view form =
    "write rows of opening and share of the mass: [[\"8 mm\", \"0 %\"], [\"10 mm\", \"40 %\"], "
    "[\"12 mm\", \"100 %\"]]";

/// Opening and share of one row; no value after a fault.
std::optional<std::array<double, 2>> read_row(SectionReader& in, std::string_view key,
                                              const Node& row) {
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

/// Rows with increasing openings; none after a fault.
Sieves read_rows(SectionReader& in, std::string_view key, const Node& at, std::size_t max_rows) {
  Sieves rows;
  if (at.kind != Node::Kind::list || at.items.size() < 2 || at.items.size() > max_rows) {
    in.fault(at, fmt::format("`{}` must be a list of 2 to {} rows", key, max_rows),
             std::string(form), "wrong-type");
    return rows;
  }
  bool sound = true;
  for (const Node& item : at.items) {
    const auto row = read_row(in, key, item);
    sound = sound && row;
    if (!row) continue;
    if (!rows.empty() && row->at(0) <= rows.back()[0]) {
      in.fault(item, fmt::format("the openings of `{}` do not increase", key),
               "sort the rows by opening, each opening once", "unsorted-sieves");
      sound = false;
    }
    rows.push_back(*row);
  }
  if (!sound) rows.clear();
  return rows;
}

/// Converts the shares retained by each sieve to cumulative shares that pass it.
Sieves passing_of(SectionReader& in, const Node& at, Sieves rows) {
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
             "give the share of the mass that each sieve retains; the shares sum to 100 %",
             "sieve-shares");
    return {};
  }
  if (rows.back()[1] < sum) {
    in.fault(at, "the largest sieve of `retained` retains mass, which then has no largest size",
             "add a row with a larger opening and \"0 %\"", "sieve-shares");
    return {};
  }
  rows.back()[1] = 1;
  return rows;
}

/// Whether openings increase, and shares do not decrease and go from 0 to 1.
bool rise_to_all(const Sieves& rows) {
  bool sound = rows.size() > 1 && rows.front()[0] > 0 && rows.front()[1] == 0 &&
               std::isfinite(rows.back()[0]) && rows.back()[1] == 1;
  for (std::size_t i = 1; i < rows.size(); ++i)
    sound = sound && rows[i - 1][0] < rows[i][0] && rows[i - 1][1] <= rows[i][1];
  return sound;
}

/// Whether shares do not decrease and go from 0 to 1; reports a fault otherwise.
bool cumulative(SectionReader& in, const Node& at, const Sieves& rows) {
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
    return fault("the mass that passes the smallest sieve of `passing` has no smallest size",
                 "add a row with a smaller opening and \"0 %\"");
  if (!std::ranges::is_sorted(rows, {}, [](const auto& row) { return row[1]; }))
    return fault("the shares of `passing` decrease", "give the whole mass that passes each sieve");
  return true;
}

}  // namespace

void describe_sieves(KeyVisitor& v, Sieves& rows, std::int64_t most) {
  constexpr CustomKey passing{
      .key = "passing",
      .about = "openings of sieves with the share of the mass that passes them",
      .required = true};
  constexpr CustomKey retained{.key = "retained",
                               .about = "openings of sieves with the share that each retains",
                               .instead = "passing"};
  SectionReader* in = v.reader();
  if (in == nullptr) {
    if (v.visits_all()) v.custom(retained, [] { return std::string(); });
    CustomKey key = passing;
    key.sound = rise_to_all(rows);
    return v.custom(key, [&] { return passing_text(rows); });
  }
  const std::string_view key = in->one_of({"passing", "retained"});
  if (key.empty()) {
    in->missing(passing.key, passing.about,
                fmt::format("write passing = ..., or retained: {}", form));
    return;
  }
  const Node& at = *in->find(key);
  rows = read_rows(*in, key, at, static_cast<std::size_t>(most) + 1);
  if (key == "retained") rows = passing_of(*in, at, std::move(rows));
  if (!rows.empty() && !cumulative(*in, at, rows)) rows.clear();
  if (!rows.empty())
    in->record_origin("passing", passing_text(rows), &at,
                      key == "retained" ? "from `retained`" : "");
}

}  // namespace mahlwerk::cases
