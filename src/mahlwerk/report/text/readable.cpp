// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/text/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/base/printable.hpp"

namespace mahlwerk::report {
namespace {

using Words = std::pair<std::string_view, std::string_view>;
/// Symbols of units whose display differs from their name.
constexpr std::array signs{Words{"1", ""},         Words{"1/s", "/s"},        Words{"deg", "°"},
                           Words{"degC", "°C"},    Words{"ug/g/h", "µg/g/h"}, Words{"m/s2", "m/s²"},
                           Words{"m2/kg", "m²/kg"}};

/// Whether a unit takes a prefix; counts and speeds (0.8 m/s, not 800 mm/s) do not.
bool takes_prefix(std::string_view unit) {
  constexpr std::array<std::string_view, 13> list{"J",   "W",   "m",    "s",   "N",   "Pa", "W/g",
                                                  "J/g", "N m", "W/m²", "g/h", "g/s", "g"};
  return std::find(list.begin(), list.end(), unit) != list.end();
}

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                    "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(exponent)))
    text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

int decade(double size) {
  return static_cast<int>(std::floor(std::log10(size)));
}

/// Decimal places such that the half-width has two digits, or without one the value four.
int places(double value, double ci95) {
  const bool told = std::isfinite(ci95) && ci95 > 0;
  const double size = told ? ci95 : std::abs(value);
  if (size == 0) return 0;
  return std::max((told ? 1 : 3) - decade(size), 0);
}

std::string fixed(double value, double ci95) {
  const int digits = places(value, ci95);
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find_first_of("123456789") == std::string::npos && text.starts_with('-'))
    text.erase(0, 1);  // rounds to -0
  if (ci95 > 0) text += fmt::format(" ± {:.{}f}", ci95, digits);
  return text;
}

/// Scientific notation, for values too large or too small to be written out.
std::string scientific(double value, double ci95) {
  const int exponent = decade(std::abs(value));
  const double scale = std::pow(10, exponent);
  const bool told = std::isfinite(ci95) && ci95 > 0;
  const int digits = told ? std::clamp(places(value / scale, ci95 / scale), 0, 9) : 1;
  if (!told) return fmt::format("{:.{}f} × {}", value / scale, digits, power_of_ten(exponent));
  return fmt::format("({:.{}f} ± {:.{}f}) × {}", value / scale, digits, ci95 / scale, digits,
                     power_of_ten(exponent));
}

}  // namespace

Multiple multiple(double size, std::string_view unit) {
  if (unit == "kg/s") {  // wear per hour, captured powder per second
    constexpr double fast = 1e-6, gram = 1e-3, hour = 3600;
    const double base = size < fast ? gram / hour : gram;
    const Multiple m = multiple(size / base, size < fast ? "g/h" : "g/s");
    return {m.factor * base, m.unit};
  }
  if (unit == "kg" && size < 1) {
    const Multiple m = multiple(1000 * size, "g");
    return {m.factor / 1000, m.unit};
  }
  using Prefix = std::pair<double, std::string_view>;
  constexpr std::array prefixes{Prefix{1e9, "G"},  Prefix{1e6, "M"},  Prefix{1e3, "k"},
                                Prefix{1, ""},     Prefix{1e-3, "m"}, Prefix{1e-6, "µ"},
                                Prefix{1e-9, "n"}, Prefix{1e-12, "p"}};
  constexpr double least = 0.9995e-12, most = 1e16;  // powers of ten of the unit itself beyond
  if (!takes_prefix(unit) || !(size >= least) || !(size < most)) return {1, std::string(unit)};
  for (const auto& [factor, prefix] : prefixes) {
    const bool big =
        factor > 1 && (unit.starts_with("s") || unit.starts_with("m"));  // no ks, no km/s
    if (!big && size >= 0.9995 * factor) return {factor, fmt::format("{}{}", prefix, unit)};
  }
  return {1, std::string(unit)};
}

std::string Readable::text() const {
  const bool close = unit.empty() || unit == "°";
  return number + (close ? "" : " ") + unit;
}

Readable readable(double value, double ci95, std::string_view unit, double size) {
  if (!std::isfinite(value)) return {std::isnan(value) ? "-" : "infinite", ""};
  // The half-width sets the multiple of a value below it: -1 ± 12 mW, not -773 µW.
  const double own = std::isfinite(ci95) ? std::max(std::abs(value), ci95) : std::abs(value);
  const Multiple m = multiple(size > 0 ? size : own, unit);
  const double v = value / m.factor, ci = ci95 / m.factor, shown_size = std::abs(v);
  std::string shown = m.unit;
  for (const auto& [said, sign] : signs)
    if (m.unit == said) shown = sign;
  if (!(ci > 0) && unit == "1" && v == std::round(v) && shown_size < 1e6)
    return {fmt::format("{:.0f}", v), ""};  // a count
  constexpr double small = 1e-3;
  const bool plain = shown_size == 0 || (shown_size >= small && shown_size < 1e7) ||
                     (ci >= shown_size && ci >= small);
  return {plain ? fixed(v, ci) : scientific(v, ci), std::move(shown)};
}

Readable readable_within(double value, double ci95, std::string_view unit, results::Range range,
                         double size) {
  const double low = value - ci95, high = value + ci95;
  const Readable usual = readable(value, ci95, unit, size);
  const bool inside = value >= range.least && value <= range.most;
  if (!inside || !std::isfinite(low) || (low >= range.least && high <= range.most)) return usual;
  const Multiple m = multiple(size > 0 ? size : std::max(std::abs(value), ci95), unit);
  constexpr double small = 1e-3;
  const bool plain = ci95 / m.factor >= small || high >= range.most;
  const int exponent = plain ? 0 : decade(ci95 / m.factor);
  const double scale = m.factor * std::pow(10, exponent);
  const int digits = std::min(places(value / scale, ci95 / scale), 9);
  const auto shown = [&](double v) {
    if (v == range.least || v == range.most) return fmt::format("{:.6g}", v / scale);
    return fmt::format("{:.{}f}", v / scale, digits);
  };
  const std::string text =
      fmt::format("{} ({} to {})", shown(value), shown(std::max(low, range.least)),
                  shown(std::min(high, range.most)));
  return {plain ? text : fmt::format("[{}] × {}", text, power_of_ten(exponent)), usual.unit};
}

std::string share_of(double share) {
  constexpr double many = 2, digits = 100;
  if (share > digits) return fmt::format("{:.0f} times", share);
  return share > many ? fmt::format("{:.3g} times", share)
                      : fmt::format("{:.0f} % of", 100 * share);
}

std::string threshold_text(double threshold) {
  return fmt::format("{:.6g} m/s", threshold);
}

std::string label(std::string_view name) {
  return results::label_of(name);
}

std::string label(const results::Quantity& q) {
  return q.name == "property" ? q.about.substr(0, q.about.rfind(',')) : label(q.name);
}

std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

Multiple time_unit(double longest) {
  constexpr double minute = 60, hour = 3600;
  if (longest <= 2 * minute) return {1, "s"};
  return longest <= 2 * hour ? Multiple{minute, "min"} : Multiple{hour, "h"};
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : printable(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string with_symbols(std::string_view text) {
  constexpr std::array symbols{Words{"u_n", "u<sub>n</sub>"}, Words{"u_t", "u<sub>t</sub>"},
                               Words{"^2", "²"}};
  std::string safe = escaped(text);
  for (const auto& [plain, symbol] : symbols)
    for (std::size_t at = safe.find(plain); at != std::string::npos;
         at = safe.find(plain, at + symbol.size()))
      safe.replace(at, plain.size(), symbol);
  return safe;
}

std::string tick_text(double value, bool as_power) {
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (as_power && (size < 0.0099 || size > 999)) {
    const int exponent = decade(size * (1 + 1e-9));
    const double digits = value / std::pow(10, exponent);  // 2 of 2000
    const std::string power = power_of_ten(exponent);
    return std::abs(digits - 1) < 1e-9 ? power : fmt::format("{:.3g}·{}", digits, power);
  }
  if (!as_power && (size < 1e-4 || size >= 1e6)) return fmt::format("{:.3g}", value);
  return fmt::format("{:.7g}", value);
}

}  // namespace mahlwerk::report
