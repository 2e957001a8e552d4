// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/points/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/points/designs.hpp"

namespace mahlwerk::campaign {
namespace {

/// Whether the values of a key are whole numbers.
bool is_count(std::string_view key) {
  static const std::set<std::string_view> names{
      "count",   "replicates", "cycles", "classes",     "classes_per_octave",
      "lifters", "arms",       "sample", "jars_carried"};
  return names.contains(key.substr(key.rfind('.') + 1));
}

[[noreturn]] void refuse(const cases::SweptKey& range, const std::string& what) {
  throw InputError(Fault{
      fmt::format("\"{}\" from \"{}\" to \"{}\"", range.key, range.values[0], range.values[1]),
      what, "write for instance { from = \"200 rpm\", to = \"600 rpm\" }", "bad-range"});
}

/// The ends of a range, in the unit of its upper end.
struct Ends {
  double from = 0, to = 1;
  std::string unit;
};

Ends ends_of(const cases::SweptKey& range) {
  const std::string& last = range.values[1];
  const auto [number, unit] = number_text(last);
  if (std::isnan(number)) refuse(range, fmt::format("\"{}\" is not a number", last));
  Ends ends{.to = number, .unit = std::string(unit)};
  try {
    const mahlwerk::Quantity first = parse_quantity(range.values[0]), second = parse_quantity(last);
    if (first.dimension != second.dimension)
      refuse(range, "the units of the ends differ in dimension");
    ends.from = parse_in(range.values[0], unit);
  } catch (const UnitError& error) {
    refuse(range, error.what());
  }
  if (!(ends.from < ends.to)) refuse(range, "the first end is not below the second");
  if (range.logarithmic && !(ends.from > 0)) refuse(range, "a logarithmic range must lie above 0");
  return ends;
}

std::vector<std::string> list_of(const cases::SweptKey& key) {
  if (!key.range) return key.values;
  std::vector<std::string> list;
  constexpr int all_digits = 9;  // hides rounding: 0.15, not 0.15000000000000002
  for (std::int64_t i = 0; i < key.steps; ++i)
    list.push_back(value_in_range(key, static_cast<double>(i) / static_cast<double>(key.steps - 1),
                                  all_digits));
  return list;
}

[[noreturn]] void too_many(std::string remedy) {
  throw InputError(Fault{"[sweep]",
                         fmt::format("the sweep has more than {} points", Plan::max_points),
                         std::move(remedy), "too-many-points"});
}

void check_size(const cases::Sweep& sweep) {
  const auto keys = static_cast<double>(sweep.keys.size());
  const auto samples = static_cast<double>(sweep.samples);
  const double each = sweep.design == cases::Design::morris          ? keys + 1
                      : sweep.design == cases::Design::sobol_indices ? keys + 2
                                                                     : 1;
  if (samples * each > static_cast<double>(Plan::max_points)) too_many("give fewer samples");
}

/// Positions in the ranges; NaN where a key keeps the value of the case.
DesignMatrix rows_of(const cases::Sweep& sweep, std::uint64_t seed) {
  const std::size_t keys = sweep.keys.size();
  const auto samples = static_cast<std::size_t>(sweep.samples);
  switch (sweep.design) {
    case cases::Design::latin_hypercube:
      return latin_hypercube(keys, samples, seed);
    case cases::Design::sobol:
      return sobol_points(keys, samples);
    case cases::Design::morris:
      return morris_design(keys, samples, seed);
    case cases::Design::sobol_indices:
      return saltelli_design(keys, samples, seed);
    case cases::Design::one_at_a_time:
    case cases::Design::grid:
      break;
  }
  return one_at_a_time_design(keys, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

std::string unit_of_range(const cases::SweptKey& range) {
  return std::string(number_text(range.values[1]).rest);
}

double number_in(const std::string& text, const std::string& unit) {
  const double one = unit.empty() ? 1 : parse_quantity("1 " + unit).value;
  return parse_quantity(text).value / one;
}

std::string value_in_range(const cases::SweptKey& range, double place, int digits) {
  const Ends ends = ends_of(range);
  double value = range.logarithmic ? ends.from * math::pow(ends.to / ends.from, place)
                                   : std::lerp(ends.from, ends.to, place);
  if (is_count(range.key)) value = std::round(value);
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  const std::string number(text.data(), end.ptr);
  return ends.unit.empty() ? number : fmt::format("{} {}", number, ends.unit);
}

Plan::Plan(const cases::Sweep& sweep, std::uint64_t seed) {
  for (const cases::SweptKey& key : sweep.keys) keys_.push_back(key.key);
  for (const std::vector<std::string>& group : sweep.together)
    following_keys_.insert(following_keys_.end(), group.begin() + 1, group.end());
  if (sweep.design != cases::Design::grid && !keys_.empty()) {
    ranges_ = sweep.keys;
    for (const cases::SweptKey& range : ranges_) ends_of(range);  // throws if the range is invalid
    check_size(sweep);
    design_ = rows_of(sweep, seed);
    size_ = design_.size();
    return;
  }
  for (const cases::SweptKey& key : sweep.keys) lists_.push_back(list_of(key));
  make_groups(sweep);
  size_ = keys_.empty() ? 0 : 1;
  for (const Group& group : groups_) {
    if (group.length > max_points / size_)
      too_many("give fewer values, or choose a design that takes samples");
    size_ *= group.length;
  }
}

void Plan::make_groups(const cases::Sweep& sweep) {
  std::vector<bool> grouped(keys_.size(), false);
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (grouped[i]) continue;
    Group group{.keys = {i}, .length = lists_[i].size()};
    for (const auto& names : sweep.together) {
      if (std::ranges::find(names, keys_[i]) == names.end()) continue;
      for (std::size_t k = i + 1; k < keys_.size(); ++k)
        if (std::ranges::find(names, keys_[k]) != names.end()) group.keys.push_back(k);
    }
    for (const std::size_t k : group.keys) grouped[k] = true;
    groups_.push_back(std::move(group));
  }
}

std::vector<std::string> Plan::values(std::size_t point) const {
  std::vector<std::string> values(keys_.size());
  if (!design_.empty()) {
    for (std::size_t k = 0; k < keys_.size(); ++k)
      if (const double place = design_[point][k]; !std::isnan(place))
        values[k] = value_in_range(ranges_[k], place);
    return values;
  }
  // The last group varies fastest.
  for (auto group = groups_.rbegin(); group != groups_.rend(); ++group) {
    for (const std::size_t key : group->keys) values[key] = lists_[key][point % group->length];
    point /= group->length;
  }
  return values;
}

std::vector<cases::Override> Plan::overrides(std::size_t point) const {
  std::vector<cases::Override> list;
  const std::vector<std::string> texts = values(point);
  for (std::size_t k = 0; k < texts.size(); ++k)
    if (!texts[k].empty()) list.push_back({keys_[k], texts[k], cases::ValueSource::sweep});
  return list;
}

std::vector<std::string> point_values(const Plan& plan, std::size_t point,
                                      const std::vector<std::string>& own) {
  std::vector<std::string> values = plan.values(point);
  for (std::size_t k = 0; k < values.size(); ++k)
    if (values[k].empty()) values[k] = own[k];
  return values;
}

std::vector<std::string> base_values(const Plan& plan, const cases::Case& mill_case) {
  std::vector<std::string> own;
  for (const std::string& key : plan.keys()) {
    const auto origin = std::ranges::find(mill_case.origins, key, &cases::Origin::key);
    own.push_back(origin == mill_case.origins.end() ? "" : origin->value);
  }
  return own;
}

}  // namespace mahlwerk::campaign
