// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/unit_table.hpp"

namespace mahlwerk {
namespace {

constexpr double ice_point = 273.15;  // [K]
constexpr std::size_t longest_text = 200;

/// A text split into number and unit.
struct Parts {
  double number = 0;
  std::string_view digits, unit;
};

[[noreturn]] void not_a_quantity(std::string_view text) {
  throw UnitError(fmt::format("\"{}\" is not a number with a unit", text.substr(0, longest_text)));
}

Parts split(std::string_view whole) {
  const std::string_view text = trimmed(whole);
  if (text.size() > longest_text) not_a_quantity(text);
  std::string_view rest = text;
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  const std::size_t sign = !rest.empty() && rest.front() == '-' && rest.size() != text.size() - 1;
  if (rest.size() <= sign) not_a_quantity(text);
  const char head = rest[sign];
  if (head != '.' && (head < '0' || head > '9')) not_a_quantity(text);  // nan, inf, words
  Parts p;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), p.number);
  if (error == std::errc::result_out_of_range)
    throw UnitError(fmt::format("the number in \"{}\" is too large or too small", text));
  if (error != std::errc{}) not_a_quantity(text);
  p.digits = {text.data(), static_cast<std::size_t>(end - text.data())};
  p.unit = trimmed({end, static_cast<std::size_t>(rest.data() + rest.size() - end)});
  if (p.unit.starts_with(','))
    throw UnitError(fmt::format("\"{}\" has a comma; write a decimal point", text));
  return p;
}

bool celsius(std::string_view unit) {
  return unit == "degC" || unit == "\u00b0C";
}

/// A number in a unit that is no multiple of an SI unit, in SI units: degC, and mesh as the opening
/// of a test sieve. No value for other units.
std::optional<Quantity> special(const Parts& p) {
  if (celsius(p.unit)) return Quantity{p.number + ice_point, {.temperature = 1}};
  if (p.unit != "mesh") return std::nullopt;
  const auto opening = mesh_opening(p.number);
  if (!opening)
    throw UnitError(fmt::format("ASTM E11 has no sieve of {} mesh; the nearest: {}", p.digits,
                                nearest_meshes(p.number)));
  return Quantity{*opening, {.length = 1}};
}

/// Converts `value` from the unit `from` to the unit `to`.
double converted(double value, const Scale& from, const Scale& to) {
  double numerator = from.numerator * to.denominator, denominator = from.denominator * to.numerator;
  for (double a = numerator, b = denominator;;) {
    if (b == 0) {
      numerator /= a;
      denominator /= a;
      break;
    }
    a = std::exchange(b, std::fmod(a, b));
  }
  double out = value * numerator / denominator;
  constexpr double turn = 2 * std::numbers::pi;
  for (int i = from.turns; i < to.turns; ++i) out /= turn;
  for (int i = to.turns; i < from.turns; ++i) out *= turn;
  return out;
}

double finite_or_fault(double value, std::string_view text) {
  if (std::isfinite(value)) return value;
  throw UnitError(fmt::format("the number in \"{}\" is too large", text));
}

/// Common name of the dimension of a unit.
std::string_view kind_of(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> kinds[] = {
      {"m", "a length"},
      {"kg", "a mass"},
      {"s", "a time"},
      {"Hz", "a frequency"},
      {"rad/s", "an angular speed"},
      {"rad", "an angle"},
      {"m/s", "a speed"},
      {"m/s2", "an acceleration"},
      {"kg/m3", "a density"},
      {"m3", "a volume"},
      {"Pa", "a pressure"},
      {"J", "an energy"},
      {"W", "a power"},
      {"N/m", "a stiffness"},
      {"J/m2", "a surface energy"},
      {"J/m3", "an energy density"},
      {"s/m", "a time per length"},
      {"K", "a temperature"},
      {"W/m/K", "a thermal conductivity"},
      {"J/kg/K", "a specific heat capacity"},
      {"W/m2/K", "a heat transfer coefficient"},
      {"J/kg", "an energy per mass"},
      {"kg/m2", "a mass per area"},
      {"kg/J/m", "a material parameter f_mat, in kg/(J m)"},
      {"J m/kg", "an energy per mass times a length"},
      {"J/mol", "an energy per amount of substance"},
      {"kg/mol", "a molar mass"},
      {"m3/mol", "a volume per amount of substance"},
      {"", "a number without a unit"}};
  for (const auto& [u, kind] : kinds)
    if (u == unit) return kind;
  return "a quantity of this dimension";
}

/// The unit that a number without one probably has. No solid or liquid has 30 kg/m3.
std::string_view example_unit(std::string_view unit, double value) {
  constexpr double light = 30;
  if (unit == "kg/m3" && value < light) return "g/cm3";
  constexpr std::pair<std::string_view, std::string_view> units[] = {
      {"m", "mm"}, {"kg", "g"}, {"rad/s", "rpm"}, {"rad", "deg"}, {"m3", "ml"}, {"Pa", "GPa"}};
  for (const auto& [u, example] : units)
    if (u == unit) return example;
  return unit;
}

}  // namespace

Quantity parse_quantity(std::string_view text) {
  const Parts p = split(text);
  if (const auto q = special(p)) return {finite_or_fault(q->value, text), q->dimension};
  const ParsedUnit m = parse_unit(p.unit);
  return {finite_or_fault(converted(p.number, m.scale, {}), text), m.dimension};
}

double parse_in(std::string_view text, std::string_view unit) {
  const Parts p = split(text);
  if (celsius(unit)) return celsius(p.unit) ? p.number : parse_in(text, "K") - ice_point;
  const ParsedUnit wanted = parse_unit(unit);
  const std::optional<Quantity> absolute = special(p);
  if (absolute && wanted.dimension == absolute->dimension)
    return finite_or_fault(converted(absolute->value, {}, wanted.scale), text);
  if (p.unit.empty() && wanted.dimension != Dimension{})
    throw UnitError(fmt::format("the unit is missing; write for instance \"{} {}\"", p.digits,
                                example_unit(unit, p.number)));
  ParsedUnit found = absolute ? ParsedUnit{{}, absolute->dimension} : parse_unit(p.unit);
  if (unit == "Hz" && found.dimension == Dimension{.time = -1}) {  // 1/s is no angular speed here
    found.dimension = wanted.dimension;
    ++found.scale.turns;
  }
  if (found.dimension != wanted.dimension)
    throw UnitError(fmt::format("\"{}\" is not {}; write for instance \"{}\"", trimmed(text),
                                kind_of(unit), example_of(unit)));
  return finite_or_fault(converted(p.number, found.scale, wanted.scale), text);
}

std::string example_of(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> examples[] = {{"m", "12 mm"},
                                                                        {"kg", "10 g"},
                                                                        {"s", "60 s"},
                                                                        {"Hz", "10 Hz"},
                                                                        {"rad/s", "400 rpm"},
                                                                        {"rad", "30 deg"},
                                                                        {"m/s", "0.1 m/s"},
                                                                        {"m/s2", "9.81 m/s2"},
                                                                        {"kg/m3", "7850 kg/m3"},
                                                                        {"m3", "5 ml"},
                                                                        {"Pa", "200 GPa"},
                                                                        {"K", "20 degC"},
                                                                        {"N/m", "72 mN/m"},
                                                                        {"J/m2", "0.05 J/m2"},
                                                                        {"J/m3", "1e5 J/m3"},
                                                                        {"W/m/K", "15 W/m/K"},
                                                                        {"J/kg/K", "500 J/kg/K"},
                                                                        {"W/m2/K", "15 W/m2/K"},
                                                                        {"J/kg", "100 J/kg"},
                                                                        {"kg/m2", "0.1 kg/m2"},
                                                                        {"J m/kg", "0.1 J m/kg"},
                                                                        {"J/mol", "100 kJ/mol"},
                                                                        {"kg/mol", "60 g/mol"},
                                                                        {"m3/mol", "10 ml/mol"},
                                                                        {"", "0.5"}};
  for (const auto& [u, example] : examples)
    if (u == unit) return std::string(example);
  return fmt::format("1 {}", unit);
}

std::string shortest(double value) {
  std::array<char, 400> room;
  const auto plain = std::to_chars(room.data(), room.data() + room.size(), value);
  std::string text(room.data(), plain.ptr);
  const double size = std::abs(value);
  if (text.find('e') == std::string::npos || !(size >= 1e-4 && size < 1e15)) return text;
  const auto fixed =
      std::to_chars(room.data(), room.data() + room.size(), value, std::chars_format::fixed);
  return {room.data(), fixed.ptr};
}

namespace {

/// `value` rounded to `digits` significant digits.
double rounded(double value, int digits) {
  std::array<char, 64> room;
  const auto end = std::to_chars(room.data(), room.data() + room.size(), value,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  double out = value;
  std::from_chars(room.data(), end, out);
  return out;
}

std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? shortest(value) : fmt::format("{} {}", shortest(value), unit);
}

constexpr int unreadable = 1000;  // larger than the cost of any number

/// Distance of |value| from the readable range 0.1 to 1000, in decades. `unreadable` where the
/// value overflows in its unit.
int readability_cost(double value) {
  const double size = std::abs(value);
  if (size == 0) return 0;
  if (!std::isfinite(size)) return unreadable;
  if (size < 0.1) return static_cast<int>(std::ceil(-1 - math::log10(size)));
  return size < 1000 ? 0 : static_cast<int>(std::floor(math::log10(size))) - 2;
}

/// A candidate text of a value.
struct Rendering {
  std::string text;
  int cost = unreadable;
};

/// The shortest text in the unit `as` that reads back as exactly `value` in `unit`; empty if there
/// is none.
Rendering exact_in(double value, std::string_view unit, std::string_view as) {
  constexpr int enough = 17;
  const Scale here = parse_unit(unit).scale, there = parse_unit(as).scale;
  const double x = converted(value, here, there);
  if (!std::isfinite(x)) return {};
  for (int digits = 1; digits <= enough; ++digits) {
    const double r = rounded(x, digits);
    if (std::isfinite(r) && converted(r, there, here) == value)
      return {with_unit(r, as), digits + 3 * readability_cost(r)};
  }
  return {};
}

}  // namespace

std::string show(double value, std::string_view unit) {
  Rendering best;
  if (std::isfinite(value))
    for (const std::string_view as : display_units(unit)) {
      Rendering rendering = exact_in(value, unit, as);
      if (!rendering.text.empty() && rendering.cost < best.cost) best = std::move(rendering);
    }
  return best.text.empty() ? with_unit(value, unit) : best.text;
}

std::string show_rounded(double value, std::string_view unit, int digits) {
  if (!std::isfinite(value)) return with_unit(value, unit);
  std::string_view best = unit;
  int least = unreadable;
  for (const std::string_view as : display_units(unit)) {
    const int cost =
        readability_cost(converted(value, parse_unit(unit).scale, parse_unit(as).scale));
    if (cost < least) {
      least = cost;
      best = as;
    }
  }
  const double x = converted(value, parse_unit(unit).scale, parse_unit(best).scale);
  return with_unit(rounded(x, digits), best);
}

std::string two_digits(double value) {
  return show_rounded(value, "", 2);
}

}  // namespace mahlwerk
