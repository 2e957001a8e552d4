// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace mahlwerk {

/// The values a field may take. Ends are included unless said otherwise.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool without_least = false, without_most = false;

  constexpr bool holds(double v) const {
    return (without_least ? v > least : v >= least) && (without_most ? v < most : v <= most);
  }
};

constexpr Range any_number{};
constexpr Range positive{.least = 0, .without_least = true};
constexpr Range not_negative{.least = 0};

/// One number a user may give to a model. Parser, help, docs and results read this.
template <class Model>
struct Field {
  std::string_view key;    ///< the word in TOML, Python and docs
  std::string_view unit;   ///< the unit `value` is kept in ("m", "Hz", "rad/s", "" for a number)
  double Model::*value;    ///< where it lives
  Range range;             ///< in `unit`
  std::string_view about;  ///< one sentence
  std::optional<double> standard = std::nullopt;  ///< the default; none: the user must say it
  std::string_view source = "";                   ///< where the default comes from
};

}  // namespace mahlwerk
