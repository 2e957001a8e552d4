// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace mahlwerk {

/// Range of values of a field. Ends are included unless `without_least` or `without_most` is set,
/// and 0 unless `without_zero` is.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool without_least = false, without_most = false;
  bool without_zero = false;

  constexpr bool holds(double v) const {
    if (without_zero && v == 0) return false;
    return (without_least ? v > least : v >= least) && (without_most ? v < most : v <= most);
  }
};

constexpr Range any_number{};
constexpr Range positive{.least = 0, .without_least = true};
constexpr Range not_negative{.least = 0};
constexpr Range not_zero{.without_zero = true};

/// Usual values of a key, as written in a case: the ends of a slider. They are no limits.
struct UsualRange {
  std::string_view least = "", most = "";
  bool log = false;  ///< whether equal ratios, not equal steps, are equally far apart
};

/// Magnitudes, 0 apart, beyond which a value is probably a mistake, for instance of its unit: it
/// gets a warning. As written in a case; an empty end: that of the unit (plausible_magnitude()).
struct PlausibleMagnitude {
  std::string_view least = "", most = "";
};

/// How pages, plots and new cases present a value.
struct Presentation {
  std::string_view label = "";   ///< name on an axis and in a form; empty: the key in words
  std::string_view symbol = "";  ///< in the texts of plots: "$f$"
  std::string_view start = "";   ///< value of a new case if neither user nor catalogue gives one
  UsualRange usual = {};
};

/// One numeric parameter of a model, for users. Parser, help, docs and results read this
/// description.
template <class Model>
struct Field {
  std::string_view key;   ///< key in TOML, Python and docs
  std::string_view unit;  ///< unit in which `value` is stored ("m", "Hz", "rad/s", "" for a number)
  double Model::*value;   ///< the member of the model
  Range range;            ///< in `unit`
  std::string_view about;                         ///< one sentence
  std::optional<double> standard = std::nullopt;  ///< the default; none: the parameter is required
  std::string_view source = "";                   ///< where the default comes from
  Presentation presentation = {};
  PlausibleMagnitude plausible = {};

  constexpr Field with(const Presentation& p) const {
    Field made = *this;
    made.presentation = p;
    return made;
  }
  constexpr Field plausible_within(std::string_view low, std::string_view high) const {
    Field made = *this;
    made.plausible = {low, high};
    return made;
  }
};

}  // namespace mahlwerk
