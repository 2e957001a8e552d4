// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/text.hpp"
#include "mahlwerk/base/unit_table.hpp"

namespace mahlwerk {
namespace {

constexpr int highest_power = 9;  // of a unit; bounds exponents and factors

/// Replaces non-ASCII spellings of units.
std::string with_ascii_symbols(std::string_view text) {
  static constexpr std::pair<std::string_view, std::string_view> spellings[] = {
      {"\u00b5", "u"},   {"\u03bc", "u"},        {"\u00b2", "2"},
      {"\u00b3", "3"},   {"\u00b7", "*"},        {"\u00b0C", "degC"},
      {"\u00b0", "deg"}, {"\u207b\u00b9", "-1"}, {"\u2212", "-"}};
  std::string out(text);
  for (const auto& [from, to] : spellings)
    for (auto at = out.find(from); at != std::string::npos; at = out.find(from, at + to.size()))
      out.replace(at, from.size(), to);
  return out;
}

double common_divisor(double a, double b) {
  while (b != 0) a = std::exchange(b, std::fmod(a, b));
  return a;
}

[[noreturn]] void unknown_unit(std::string_view symbol) {
  std::vector<std::string> known;
  for (const Unit& u : all_units()) known.emplace_back(u.symbol);
  known.insert(known.end(),
               {"degC", "mesh", "1/min", "rad/s", "m/s", "kg/m3", "g/cm3", "m/s2", "J/kg"});
  const std::string near = nearest_word(symbol, known);
  throw UnitError(near.empty()
                      ? fmt::format("there is no unit \"{}\"", symbol)
                      : fmt::format("there is no unit \"{}\"; did you mean \"{}\"?", symbol, near));
}

const Unit& find_unit(std::string_view symbol) {
  for (const Unit& u : all_units())
    if (u.symbol == symbol) return u;
  unknown_unit(symbol);
}

void multiply(ParsedUnit& m, const Unit& unit, int power) {
  const int n = std::abs(power), sign = power < 0 ? -1 : 1;
  for (int i = 0; i < n; ++i) {
    m.scale.numerator *= power > 0 ? unit.scale.numerator : unit.scale.denominator;
    m.scale.denominator *= power > 0 ? unit.scale.denominator : unit.scale.numerator;
    m.scale.turns += sign * unit.scale.turns;
    const auto add = [&](std::int8_t& into, std::int8_t what) {
      const int sum = into + sign * what;
      if (std::abs(sum) > 100) throw UnitError("the unit has too high a power");
      into = static_cast<std::int8_t>(sum);
    };
    add(m.dimension.length, unit.dimension.length);
    add(m.dimension.mass, unit.dimension.mass);
    add(m.dimension.time, unit.dimension.time);
    add(m.dimension.temperature, unit.dimension.temperature);
    add(m.dimension.angle, unit.dimension.angle);
    add(m.dimension.amount, unit.dimension.amount);
  }
  if (!std::isfinite(m.scale.numerator) || !std::isfinite(m.scale.denominator))
    throw UnitError("the unit has too high a power");
  const double divisor = common_divisor(m.scale.numerator, m.scale.denominator);
  m.scale.numerator /= divisor;
  m.scale.denominator /= divisor;
}

/// The power after a symbol: "3", "^3", "^-3"; 1 if empty.
int parse_power(std::string_view power, std::string_view symbol) {
  if (power.empty()) return 1;
  std::string_view digits = power;
  if (digits.front() == '^') digits.remove_prefix(1);
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || value == 0 ||
      std::abs(value) > highest_power)
    throw UnitError(fmt::format("\"{}{}\" is not a unit", symbol, power));
  return value;
}

void multiply_factor(ParsedUnit& m, std::string_view factor, int sign) {
  std::size_t end = 0;
  while (end < factor.size() &&
         (std::isalpha(static_cast<unsigned char>(factor[end])) != 0 || factor[end] == '%'))
    ++end;
  const std::string_view symbol = factor.substr(0, end);
  if (symbol.empty()) unknown_unit(factor);
  if (symbol == "degC") throw UnitError("\"degC\" cannot be part of a compound unit; use \"K\"");
  if (symbol == "mesh")
    throw UnitError(
        "\"mesh\" is a sieve's number and no unit of its own; write for instance \"75 um\"");
  multiply(m, find_unit(symbol), sign * parse_power(factor.substr(end), symbol));
}

/// Expands brackets: "J/(kg K)" becomes "J/kg/K". A factor in the bracket of a denominator divides.
std::string without_brackets(std::string_view text) {
  std::string out;
  bool inside = false, divided = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(' || c == ')') {
      const std::string_view next = trimmed(text.substr(i + 1));
      const bool ends = next.empty() || next.front() == '*' || next.front() == '/';
      if (inside == (c == '(') || (inside && !ends))
        throw UnitError(
            fmt::format("the brackets of \"{}\" say nothing; write for instance "
                        "\"J/kg/K\" or \"J/(kg K)\"",
                        text));
      inside = c == '(';
      divided = inside && trimmed(out).ends_with('/');
    } else if (inside && divided && (c == '*' || c == '/')) {
      out += c == '*' ? '/' : '*';
    } else {
      out += c;
    }
  }
  if (inside) throw UnitError(fmt::format("a bracket of \"{}\" is not closed", text));
  return out;
}

/// Replaces blanks between factors by "*": "J m/kg" becomes "J*m/kg".
std::string with_products(std::string_view text) {
  const auto joins = [](char c) { return c == '*' || c == '/' || c == '('; };
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != ' ') {
      out += text[i];
      continue;
    }
    const std::size_t next = std::min(text.find_first_not_of(' ', i), text.size() - 1);
    const bool between = !out.empty() && !joins(out.back()) && text[next] != '*' &&
                         text[next] != '/' && text[next] != ')';
    if (between) out += '*';
    i = next - 1;
  }
  return out;
}

/// Whether `text` is turns per minute as rating plates and methods sections write it.
bool turns_per_minute(std::string_view text) {
  constexpr std::string_view spellings[] = {"1/min", "/min",  "min-1",  "min^-1",
                                            "r/min", "U/min", "rev/min"};
  return std::ranges::find(spellings, text) != std::end(spellings);
}

}  // namespace

ParsedUnit parse_unit(std::string_view given) {
  const std::string text = without_brackets(with_products(trimmed(with_ascii_symbols(given))));
  ParsedUnit m;
  if (text.empty()) return m;
  if (turns_per_minute(text)) return parse_unit("rpm");
  std::size_t from = 0;
  int sign = 1;
  for (bool first = true;; first = false) {
    const std::size_t to = std::min(text.find_first_of("*/", from), text.size());
    const std::string_view factor = std::string_view(text).substr(from, to - from);
    if (!(first && factor == "1" && to < text.size())) multiply_factor(m, factor, sign);
    if (to == text.size()) return m;
    sign = text[to] == '/' ? -1 : 1;
    from = to + 1;
  }
}

}  // namespace mahlwerk
