// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "mahlwerk/base/number_text.hpp"

namespace mahlwerk::report {
namespace {

const std::string& value_of(const Point& p, std::size_t key) {
  static const std::string none;
  return key < p.values.size() ? p.values[key] : none;
}

bool is_number(const Campaign& c, std::size_t key) {
  return std::ranges::all_of(c.points, [&](const Point& p) {
    const NumberText s = number_text(value_of(p, key));
    return std::isfinite(s.number) && s.rest == c.keys[key].unit;
  });
}

Levels numbers_of(const Campaign& c, std::size_t key) {
  std::map<double, std::string> texts;
  for (const Point& p : c.points)
    texts.emplace(number_text(value_of(p, key)).number, value_of(p, key));
  Levels made;
  for (const auto& [number, text] : texts) {
    made.numbers.push_back(number);
    made.texts.push_back(text);
  }
  for (const Point& p : c.points) {
    const auto at = std::ranges::lower_bound(made.numbers, number_text(value_of(p, key)).number);
    made.of.push_back(static_cast<std::size_t>(at - made.numbers.begin()));
  }
  return made;
}

Levels words_of(const Campaign& c, std::size_t key) {
  Levels made;
  std::map<std::string, std::size_t> places;
  for (const Point& p : c.points) {
    const auto [at, is_new] = places.emplace(value_of(p, key), made.texts.size());
    if (is_new) made.texts.push_back(value_of(p, key));
    made.of.push_back(at->second);
  }
  return made;
}

/// Whether the points form a grid: no combination occurs twice and at least 60 % of them are there.
/// Stars and scattered points do not.
bool is_grid(const Sheet& s) {
  constexpr double enough = 0.6;
  double combinations = 1;
  for (const std::size_t key : s.free) combinations *= static_cast<double>(s.keys[key].size());
  const std::size_t points = s.campaign.points.size();
  if (points == 0 || static_cast<double>(points) > combinations ||
      static_cast<double>(points) < enough * combinations)
    return false;
  std::set<std::vector<std::size_t>> seen;
  for (std::size_t i = 0; i < points; ++i) {
    std::vector<std::size_t> place;
    for (const std::size_t key : s.free) place.push_back(s.keys[key].of[i]);
    if (!seen.insert(place).second) return false;
  }
  return true;
}

bool is_star(const Sheet& s) {
  if (s.campaign.points.empty() || s.free.size() < 2) return false;
  for (std::size_t i = 1; i < s.campaign.points.size(); ++i) {
    const auto moved = std::ranges::count_if(
        s.free, [&](std::size_t key) { return s.keys[key].of[i] != s.keys[key].of[0]; });
    if (moved > 1) return false;
  }
  return true;
}

Multiple multiple_of(const Campaign& c, std::size_t column) {
  double most = 0;
  for (const Point& p : c.points)
    if (const double v = value_at(p, column); std::isfinite(v)) most = std::max(most, std::abs(v));
  return multiple(most, c.columns[column].unit);
}

}  // namespace

Sheet::Sheet(const Campaign& c) : campaign(c), shown(shown_columns(c)) {
  for (std::size_t key = 0; key < c.keys.size(); ++key) {
    keys.push_back(is_number(c, key) ? numbers_of(c, key) : words_of(c, key));
    if (keys.back().size() > 1 && !c.keys[key].follows) free.push_back(key);
  }
  for (std::size_t i = 0; i < c.columns.size(); ++i) multiples.push_back(multiple_of(c, i));
  grid = is_grid(*this);
  star = !grid && is_star(*this);
}

std::size_t Sheet::axis() const {
  std::size_t best = keys.size(), most = 0;
  for (const std::size_t key : free) {
    if (!keys[key].numeric() || keys[key].size() <= most) continue;
    best = key;
    most = keys[key].size();
  }
  return best;
}

std::string Sheet::others(std::size_t point, const std::vector<std::size_t>& but) const {
  std::string text;
  for (const std::size_t key : free)
    if (std::ranges::find(but, key) == but.end())
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", distinct_key_words(campaign, key),
                          value_of(campaign.points[point], key));
  return text;
}

std::string key_words(std::string_view key) {
  std::string words(key.substr(key.rfind('.') + 1));
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string distinct_key_words(const Campaign& c, std::size_t key) {
  const std::string last = key_words(c.keys[key].key);
  const auto alike = [&](const CampaignKey& s) { return key_words(s.key) == last; };
  if (std::ranges::count_if(c.keys, alike) == 1) return last;
  std::string words = c.keys[key].key;
  std::ranges::replace_if(
      words, [](char ch) { return ch == '.' || ch == '_'; }, ' ');
  return words;
}

bool any_warnings(const Campaign& c) {
  return !std::ranges::all_of(c.points, [](const Point& p) { return p.warnings.empty(); });
}

bool regimes_differ(const Campaign& c) {
  std::string_view first;
  for (const Point& p : c.points) {
    if (p.regime.empty()) continue;
    if (!first.empty() && p.regime != first) return true;
    first = p.regime;
  }
  return false;
}

std::string axis_label(const CampaignKey& key) {
  return key.unit.empty() ? key.key : fmt::format("{} ({})", key.key, key.unit);
}

std::string column_label(const Column& column, const Multiple& m) {
  if (m.unit == "1") return label(column.name);
  return fmt::format("{} ({})", label(column.name), m.unit == "1/s" ? "/s" : m.unit);
}

std::string shortened(std::string_view message, std::size_t letters) {
  constexpr std::size_t bytes = 4;  // of a letter at most
  if (width(message) <= letters) return std::string(message);
  std::string text(message.substr(0, bytes * letters));
  while (width(text) >= letters) text.pop_back();  // removes a multi-byte character completely
  return text + "…";
}

std::string missing_reason(const Point& p, std::size_t letters) {
  if (p.waiting()) return "not run yet";
  const std::string_view reason = p.failure;
  return "failed: " + shortened(reason.substr(0, reason.find('\n')), letters);
}

bool over_decades(const std::vector<double>& values) {
  constexpr double far = 100;
  constexpr std::size_t tail = 20;  // 1/tail of the values at either end are ignored
  std::vector<double> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted),
                       [](double v) { return std::isfinite(v); });
  if (sorted.empty()) return false;
  std::ranges::sort(sorted);
  const std::size_t out = sorted.size() / tail;
  return sorted.front() > 0 && sorted[sorted.size() - 1 - out] >= far * sorted[out];
}

}  // namespace mahlwerk::report
