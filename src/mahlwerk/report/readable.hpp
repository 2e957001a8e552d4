// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/summary.hpp"

// Numbers as people read them.
namespace mahlwerk::report {

/// "2.42 ± 0.03" with "mJ": value and half-width in one multiple of the unit, rounded where the
/// half-width says so (to its second digit), else to four digits. What is not a number is a dash.
struct Readable {
  std::string number, unit;
  std::string text() const;
};
/// The multiple is the one that suits `size`, for numbers shown beside each other; by default the
/// value, or a half-width larger than it.
Readable readable(double value, double ci95, std::string_view unit, double size = 0);
inline Readable readable(const results::Quantity& q) {
  return readable(q.value, q.ci95, q.unit);
}

/// "52 % of" something, or "9519 times" it.
std::string share_of(double share);

/// "0.1 m/s", as the case says it rather than in a multiple.
std::string threshold_text(double threshold);

/// The largest power of 1000 not above `size` that `unit` can take: 1e-3 and "mJ" for 0.0024 J.
/// Of kg/s it is of g/h or, from 1 mg/s on, of g/s.
struct Multiple {
  double factor = 1;
  std::string unit;
};
Multiple multiple(double size, std::string_view unit);

/// What a quantity is called in tables and on axes: "mean normal energy" for energy_normal_mean.
std::string label(std::string_view name);
/// The same, but a property of [kinetics] by the name the case gave it.
std::string label(const results::Quantity& q);

/// Characters a terminal shows for UTF-8 text.
std::size_t width(std::string_view text);

/// Text made safe inside HTML and SVG.
std::string escaped(std::string_view text);

/// The same for a sentence with symbols: u_n^2 gets its index and its power.
std::string with_symbols(std::string_view text);

/// "10⁻³", "2·10⁻³", "0.1", "250": a tick, with a power of ten where the number would be long.
std::string tick_text(double value, bool as_power);

}  // namespace mahlwerk::report
