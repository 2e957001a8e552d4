// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/admission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk {
namespace {

/// The largest magnitude that is admitted: nothing in or about a mill is larger.
double largest_admitted(std::string_view unit) {
  constexpr std::pair<std::string_view, double> limits[] = {
      {"m", 1e6},  {"s", 1e12},    {"m/s", 1e5},   {"m/s2", 1e8}, {"rad/s", 1e7},
      {"Hz", 1e9}, {"kg/m3", 1e6}, {"kg", 1e15},   {"m3", 1e12},  {"Pa", 1e18},
      {"K", 1e9},  {"J", 1e18},    {"J/kg", 1e15}, {"N/m", 1e20}, {"rad", 1e6}};
  const auto found = std::ranges::find(limits, unit, [](const auto& one) { return one.first; });
  return found == std::end(limits) ? 1e30 : found->second;
}

/// The smallest magnitude that is admitted where 0 is none: with a smaller one masses, time steps
/// or sizes of grids leave the range of numbers.
double smallest_admitted(std::string_view unit) {
  return unit == "m" ? 1e-12 : unit == "kg/m3" ? 1e-3 : 1e-30;
}

}  // namespace

std::string range_text(const Range& range, std::string_view unit) {
  if (range.without_zero) return "other than 0";
  const auto end = [&](double v) { return show(v, unit); };
  const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
  if (low && high)
    return fmt::format("{} {} and {} {}", range.without_least ? "above" : "at least",
                       end(range.least), range.without_most ? "below" : "at most", end(range.most));
  if (low)
    return fmt::format("{} {}", range.without_least ? "above" : "at least", end(range.least));
  return high ? fmt::format("{} {}", range.without_most ? "below" : "at most", end(range.most))
              : "";
}

std::string refusal(double value, const Range& range, std::string_view unit) {
  if (!std::isfinite(value)) return "not a finite number";
  if (!range.holds(value)) return "out of range: it must be " + range_text(range, unit);
  const double most = largest_admitted(unit), least = smallest_admitted(unit);
  if (std::abs(value) > most)
    return fmt::format("beyond all that a mill has: {} at most", show(most, unit));
  if (!range.holds(0) && std::abs(value) < least)
    return fmt::format("beyond all that a mill has: {} at least", show(least, unit));
  return "";
}

bool is_percentage(double value, const Range& range, std::string_view unit) {
  return unit.empty() && range.most <= 1 && !range.holds(value) && range.holds(0.01 * value);
}

std::array<double, 2> plausible_magnitude(std::string_view unit,
                                          const PlausibleMagnitude& written) {
  struct Magnitude {
    std::string_view unit;
    double least, most;
  };
  constexpr Magnitude plausible[] = {
      {"m", 1e-9, 20},       {"m3", 1e-12, 5000},    {"kg", 1e-9, 1e6},    {"m/s", 1e-7, 300},
      {"m/s2", 1e-3, 1e3},   {"rad/s", 1e-5, 3000},  {"Pa", 1, 2e12},      {"K", 1, 5000},
      {"Pa s", 1e-6, 1e4},   {"N/m", 1e-4, 1e12},    {"J/m2", 1e-6, 100},  {"W/m/K", 1e-3, 5000},
      {"J/kg/K", 10, 3e4},   {"W/m2/K", 1e-3, 1e5},  {"J/kg", 1e-6, 1e9},  {"J/mol", 1, 1e7},
      {"kg/m3", 500, 25000}, {"kg/mol", 5e-4, 1000}, {"m3/mol", 1e-9, 0.1}};
  std::array<double, 2> ends{0, std::numeric_limits<double>::infinity()};
  for (const Magnitude& one : plausible)
    if (one.unit == unit) ends = {one.least, one.most};
  if (!written.least.empty()) ends[0] = parse_in(written.least, unit);
  if (!written.most.empty()) ends[1] = parse_in(written.most, unit);
  return ends;
}

}  // namespace mahlwerk
