// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/quantities/traits.hpp"
#include "mahlwerk/results/summary.hpp"

// Formatting of numbers, units and names for readers.
namespace mahlwerk::report {

/// Formatted value: "2.42 ± 0.03" and "mJ". Value and half-width in the same multiple of the unit,
/// rounded to the second digit of the half-width, or to four digits without one. NaN is "-".
struct Readable {
  std::string number, unit;
  std::string text() const;
};
/// Formats a value. The multiple of the unit suits `size`, so that numbers shown side by side share
/// it; default: the larger of value and half-width.
Readable readable(double value, double ci95, std::string_view unit, double size = 0);
/// The same for a quantity with a range: an interval that leaves it is written by its ends, cut at
/// the range: "0.23 (0 to 0.48)" instead of "0.23 ± 0.25".
Readable readable_within(double value, double ci95, std::string_view unit, results::Range range,
                         double size = 0);
inline Readable readable(const results::Quantity& q) {
  return readable_within(q.value, q.half_width(), q.unit, results::range_of(q.name));
}
/// The text of the quantity of that name; "-" if the list lacks it.
inline std::string text_of(const std::vector<results::Quantity>& list, std::string_view name) {
  return readable(results::named(list, name)).text();
}

/// "52 % of", or "9519 times" above 2.
std::string share_of(double share);

/// The threshold [m/s] as in the case, without prefix: "0.1 m/s".
std::string threshold_text(double threshold);

/// The largest power of 1000 not above `size` that `unit` can take: 1e-3 and "mJ" for 0.0024 J.
/// For kg/s it is a multiple of g/h or, from 1 mg/s on, of g/s.
struct Multiple {
  double factor = 1;
  std::string unit;
};
Multiple multiple(double size, std::string_view unit);

/// Label of a quantity in tables and on axes: "mean normal energy" for energy_normal_mean.
std::string label(std::string_view name);
/// The same; for the property of [kinetics], the name that the case gives.
std::string label(const results::Quantity& q);

/// Number of characters of UTF-8 text (code points).
std::size_t width(std::string_view text);

/// Unit for times of milling up to `longest` [s].
Multiple time_unit(double longest);

/// Text escaped for HTML and SVG.
std::string escaped(std::string_view text);

/// The same; symbols such as u_n^2 get subscript and exponent.
std::string with_symbols(std::string_view text);

/// Label of an axis tick: "10⁻³", "2·10⁻³", "0.1", "250"; with `as_power`, powers of ten for long
/// numbers.
std::string tick_text(double value, bool as_power);

}  // namespace mahlwerk::report
