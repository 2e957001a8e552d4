// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::array exponents{&Dimension::mass,        &Dimension::length, &Dimension::angle,
                               &Dimension::temperature, &Dimension::amount, &Dimension::time};
constexpr std::array<std::string_view, 6> base_units{"kg", "m", "rad", "K", "mol", "s"};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%' || (c & 0x80);
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string unit_name(const Dimension& d) {
  std::string above, below;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    const int n = d.*exponents[i];
    std::string& side = n > 0 ? above : below;
    if (n == 0) continue;
    side += n > 0 ? (above.empty() ? "" : " ") : "/";
    side += base_units[i];
    if (std::abs(n) > 1) side += std::to_string(std::abs(n));
  }
  return above.empty() && !below.empty() ? "1" + below : above + below;
}

/// The dimension with each exponent multiplied by `power`. Throws FormulaError if an exponent is
/// not an integer.
Dimension raised(const Dimension& d, double power) {
  Dimension result;
  for (const auto exponent : exponents) {
    const double n = power * d.*exponent;
    if (std::abs(n - std::round(n)) > 1e-9 || std::abs(n) > 100)
      throw FormulaError(fmt::format("the power {} of {} has no unit", power, unit_name(d)));
    result.*exponent = static_cast<std::int8_t>(std::lround(n));
  }
  return result;
}

Quantity product(const Quantity& a, const Quantity& b, int sign) {
  Quantity result{sign > 0 ? a.value * b.value : a.value / b.value, a.dimension};
  for (const auto exponent : exponents)
    result.dimension.*exponent =
        static_cast<std::int8_t>(a.dimension.*exponent + sign * b.dimension.*exponent);
  return result;
}

/// Recursive descent parser: sum, product, sign, power, atom.
class Parser {
 public:
  Parser(std::string_view text, const ValueOf& value_of) : text_(text), value_of_(value_of) {}

  Quantity whole() {
    const Quantity result = sum();
    if (!rest().empty())
      throw FormulaError(fmt::format("\"{}\" is left over in the formula", rest()));
    return result;
  }

 private:
  std::string_view rest() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return text_.substr(at_);
  }
  bool take(char c) {
    if (rest().empty() || rest().front() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (take(c)) return;
    throw FormulaError(rest().empty() ? fmt::format("the formula ends where \"{}\" is missing", c)
                                      : fmt::format("\"{}\" is missing before \"{}\"", c, rest()));
  }
  template <class Part>
  Quantity deeper(const Part& part) {
    if (++depth_ > 100) throw FormulaError("the formula has too many brackets");
    const Quantity result = part();
    --depth_;
    return result;
  }
  static void same(const Quantity& a, const Quantity& b) {
    if (a.dimension == b.dimension) return;
    const auto words = [](const Quantity& q) {
      const std::string unit = unit_name(q.dimension);
      return unit.empty() ? "a pure number" : unit;
    };
    throw FormulaError(fmt::format("{} and {} cannot be added or compared", words(a), words(b)));
  }

  Quantity sum() {
    Quantity result = products();
    for (;;) {
      const int sign = take('+') ? 1 : take('-') ? -1 : 0;
      if (sign == 0) return result;
      const Quantity next = products();
      same(result, next);
      result.value += sign * next.value;
    }
  }
  Quantity products() {
    Quantity result = signed_power();
    for (;;) {
      const int sign = take('*') ? 1 : take('/') ? -1 : 0;
      if (sign == 0) return result;
      result = product(result, signed_power(), sign);
    }
  }
  Quantity signed_power() {
    if (take('-')) {
      negated_ = true;
      Quantity result = deeper([&] { return signed_power(); });
      result.value = -result.value;
      return result;
    }
    const Quantity base = atom();
    negated_ = false;
    if (!take('^')) return base;
    const Quantity exponent = deeper([&] { return signed_power(); });
    return power(base, exponent);
  }
  static Quantity power(const Quantity& base, const Quantity& exponent) {
    if (exponent.dimension != Dimension{}) throw FormulaError("an exponent must be a pure number");
    return {math::pow(base.value, exponent.value), raised(base.dimension, exponent.value)};
  }

  Quantity atom() {
    if (take('(')) {
      const Quantity result = deeper([&] { return sum(); });
      expect(')');
      return result;
    }
    const std::string_view left = rest();
    if (left.empty()) throw FormulaError("the formula ends where a value is missing");
    if (is_digit(left.front()) || left.front() == '.') return number();
    if (is_letter(left.front())) return word();
    throw FormulaError(fmt::format("\"{}\" is not a value", left));
  }
  Quantity number() {
    const std::string_view left = rest();
    Quantity result;
    const auto read = std::from_chars(left.data(), left.data() + left.size(), result.value);
    if (read.ec != std::errc{}) throw FormulaError(fmt::format("\"{}\" is not a number", left));
    at_ += static_cast<std::size_t>(read.ptr - left.data());
    const std::size_t before = at_;
    if (rest().empty() || !is_letter(rest().front())) return result;
    const std::string_view name = take_name();
    if (name == "degC") return temperature(result.value);
    if (name.find('.') == std::string_view::npos) {
      if (!rest().empty() && rest().front() == '^')
        throw FormulaError(
            fmt::format("the power in \"{0} {1}^\" may apply to the unit or to the quantity; "
                        "write {0} {1}2 or ({0} {1})^2",
                        result.value, name));
      return product(result, unit(name), 1);
    }
    at_ = before;  // "2 jar.diameter" lacks an operator
    throw FormulaError(fmt::format("an operator is missing before \"{}\"", rest()));
  }
  std::string_view take_name() {
    const std::string_view left = rest();
    std::size_t n = 0;
    while (n < left.size() && (is_letter(left[n]) || is_digit(left[n]) || left[n] == '.')) ++n;
    at_ += n;
    return left.substr(0, n);
  }
  /// A temperature in degC, which is not a multiple of a unit: 20 degC are 293.15 K.
  Quantity temperature(double number) const {
    if (negated_)
      throw FormulaError("degC takes no minus sign in a formula; write for instance 268.15 K");
    return parse_quantity(fmt::format("{} degC", number));
  }
  static Quantity unit(std::string_view name) {
    if (name == "degC") throw FormulaError("degC may only follow a number");
    try {
      return parse_quantity(fmt::format("1 {}", name));
    } catch (const UnitError& error) {
      throw FormulaError(error.what());
    }
  }
  Quantity word() {
    const std::string_view name = take_name();
    if (name == "pi") return {std::numbers::pi, {}};
    if (!rest().empty() && rest().front() == '(') return call(name);
    const bool key = name.find('.') != std::string_view::npos || name == "gravity";
    return key ? value_of_(name) : unit(name);
  }
  Quantity call(std::string_view name) {
    expect('(');
    std::vector<Quantity> values{deeper([&] { return sum(); })};
    while (take(',')) values.push_back(deeper([&] { return sum(); }));
    expect(')');
    const bool several = name == "min" || name == "max";
    if (!several && values.size() > 1)
      throw FormulaError(fmt::format("{}() takes one value", name));
    if (name == "sqrt") return power(values[0], {0.5, {}});
    if (name == "cbrt") return {math::cbrt(values[0].value), raised(values[0].dimension, 1.0 / 3)};
    if (name == "abs") return {std::abs(values[0].value), values[0].dimension};
    if (!several)
      throw FormulaError(
          fmt::format("there is no function {}; known: sqrt, cbrt, abs, min, max", name));
    Quantity best = values[0];
    for (const Quantity& value : values) {
      same(best, value);
      best.value =
          name == "min" ? std::min(best.value, value.value) : std::max(best.value, value.value);
    }
    return best;
  }

  std::string_view text_;
  const ValueOf& value_of_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool negated_ = false;  // a minus sign precedes the value being read
};

}  // namespace

Quantity evaluate(std::string_view formula, const ValueOf& value_of) {
  return Parser(formula, value_of).whole();
}

std::string text_of(const Quantity& quantity) {
  if (!std::isfinite(quantity.value)) throw FormulaError("the value is not finite");
  const std::string unit = unit_name(quantity.dimension);
  return unit.empty() ? shortest(quantity.value)
                      : fmt::format("{} {}", shortest(quantity.value), unit);
}

}  // namespace mahlwerk::cases
