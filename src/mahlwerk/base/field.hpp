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
};

}  // namespace mahlwerk
