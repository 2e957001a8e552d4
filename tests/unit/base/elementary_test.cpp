// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/elementary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include "isas.hpp"
#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::elementary_test {
namespace {

using Function = double (*)(double);
using Exact = long double (*)(long double);

double pow_04(double x) {
  return math::pow(x, 0.4);
}
double power_of_e(double x) {
  return math::pow(2.7, x);
}
double angle(double y) {
  return math::atan2(y, -1.3);
}

/// Largest relative error over numbers from `low` to `high`.
double worst(Function f, Exact exact, double low, double high) {
  Random random(1, 1);
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(low, high);
    const long double right = exact(x);
    most = max_or_nan(most, static_cast<double>(std::abs((f(x) - right) / right)));
  }
  return most;
}

TEST(Elementary, functions_are_within_their_errors) {
  struct Line {
    std::string name;
    Function f;
    Exact exact;
    double low, high, bound;
  };
  const Line lines[] = {
      {"log", math::log, std::log, 0, 1, 1.2e-16},
      {"log of large numbers", math::log, std::log, 1, 1e9, 1.2e-16},
      {"exp", math::exp, std::exp, -700, 700, 1.4e-16},
      {"x^0.4", pow_04, [](long double x) { return std::pow(x, 0.4L + (0.4 - 0.4L)); }, 0, 10,
       2e-16},
      {"2.7^x", power_of_e, [](long double x) { return std::pow(0.0L + 2.7, x); }, -30, 30,
       2e-16 * 3},
      {"expm1", math::expm1, std::expm1, -20, 5, 4e-16},
      {"log1p", math::log1p, std::log1p, -0.5, 1, 4e-16},
      {"log10", math::log10, std::log10, 1.1, 1000, 2.3e-16},
      {"log2", math::log2, std::log2, 1.1, 1000, 2.3e-16},
      {"tanh", math::tanh, std::tanh, -3, 3, 7e-16},
      {"tan", math::tan, std::tan, -1.5, 1.5, 5e-16},
      {"atan", math::atan, std::atan, -10, 10, 1.6e-16},
      {"atan2", angle, [](long double y) { return std::atan2(y, 0.0L - 1.3); }, -10, 10, 3e-16},
      {"asin", math::asin, std::asin, -1, 1, 3.5e-16},
      {"cube root", math::cbrt, std::cbrt, 0, 100, 1.7e-16},
      {"erfc", math::erfc, std::erfc, -6, 25, 6e-15},
      {"erf", math::erf, std::erf, -6, 6, 1.5e-15},
  };
  for (const Line& one : lines)
    stays_below("relative error of " + one.name, worst(one.f, one.exact, one.low, one.high),
                one.bound, "functions of 64 bits of mantissa or more; 0.5 ulp is 1.1e-16");
}

TEST(Elementary, whole_powers_of_their_base_are_exact) {
  for (int n = -300; n <= 300; ++n) {
    EXPECT_EQ(math::log2(std::ldexp(1.0, 3 * n)), 3 * n);
    EXPECT_EQ(math::log10(std::pow(10.0, n)), n);
  }
  EXPECT_EQ(math::pow(10, 3), 1000);
  EXPECT_EQ(math::exp2(-7), 0x1p-7);
  EXPECT_EQ(math::cbrt(-27), -3);
  EXPECT_EQ(math::hypot(3, -4), 5);
}

TEST(Elementary, ends_of_the_range_are_those_of_the_standard) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(math::log(0), -infinity);
  EXPECT_EQ(math::log(infinity), infinity);
  EXPECT_TRUE(std::isnan(math::log(-1)));
  EXPECT_EQ(math::exp(-infinity), 0);
  EXPECT_EQ(math::exp(1000), infinity);
  EXPECT_TRUE(std::isnan(math::exp(NAN)));
  EXPECT_EQ(math::exp(-800), 0);
  EXPECT_EQ(math::expm1(705), math::exp(705));
  EXPECT_EQ(math::expm1(infinity), infinity);
  EXPECT_NEAR(math::log1p(std::numeric_limits<double>::max()), 709.782712893384, 1e-12);
  EXPECT_EQ(math::log1p(infinity), infinity);
  EXPECT_TRUE(std::isnan(math::log1p(-infinity)));
  EXPECT_EQ(math::pow(0, 0.2), 0);
  EXPECT_EQ(math::pow(0, -1), infinity);
  EXPECT_EQ(math::pow(5, 0), 1);
  EXPECT_EQ(math::pow(1e-200, 2), 0);
  EXPECT_EQ(math::pow(1e200, 2), infinity);
  EXPECT_EQ(math::cbrt(0), 0);
  EXPECT_EQ(math::atan2(0, -1), std::atan2(0, -1));
  EXPECT_EQ(math::atan2(-0.0, -1), std::atan2(-0.0, -1));
  EXPECT_EQ(math::atan2(0, 0), 0);
  EXPECT_EQ(math::atan(infinity), std::atan(infinity));
  EXPECT_EQ(math::erfc(40), 0);
  EXPECT_EQ(math::erfc(-40), 2);
  EXPECT_EQ(math::erf(0), 0);
  EXPECT_TRUE(std::isnan(math::asin(1.1)));
}

TEST(Elementary, bits_are_the_same_everywhere) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211U;
  };
  for (int i = 1; i <= 20000; ++i) {
    const double x = 0.001 * i;
    for (const double y : {math::log(x), math::exp(-x), math::pow(x, 0.4), math::expm1(x),
                           math::log1p(x), math::log10(x), math::tanh(x), math::tan(x),
                           math::atan2(x, -1), math::cbrt(x), math::hypot(x, 1), math::erfc(x)})
      add(y);
  }
  EXPECT_EQ(hash, 1381972666686405785U) << "as found with g++ on x86-64";
}

/// log and power of numbers, register by register.
struct InRegisters {
  static constexpr double power = 0.687;
  struct Numbers {
    alignas(64) std::array<double, lanes> x, log, pow;
  };
  template <int width>
  static void run(Numbers& n) {
    using V = Register<width>;
    for (int l = 0; l < lanes; l += width) {
      const V x = load<V>(n.x.data() + l);
      store<V>(n.log.data() + l, math::log(x));
      store<V>(n.pow.data() + l, math::pow(x, power));
    }
  }
};

TEST(Elementary, has_the_bits_of_one_number_in_registers) {
  for (const Isa each : supported_isas()) {
    const ChosenIsa chosen(each);
    const auto in_registers = Multiversioned<InRegisters, void (*)(InRegisters::Numbers&)>::best();
    Random random(5, 1);
    int wrong = 0;
    constexpr int registers = 20000;
    for (int i = 0; i < registers; ++i) {
      InRegisters::Numbers n{};
      for (double& x : n.x)
        x = std::ldexp(random.uniform(0.5, 1), static_cast<int>(random.uniform(-1000, 1000)));
      n.x[0] = 1, n.x[1] = std::numeric_limits<double>::min(), n.x[2] = 0.5 * std::numbers::sqrt2;
      in_registers(n);
      for (std::size_t l = 0; l < lanes; ++l)
        wrong += static_cast<int>(n.log[l] != math::log(n.x[l]) ||
                                  n.pow[l] != math::pow(n.x[l], InRegisters::power));
    }
    states("lanes that differ from one number, " + std::string(name_of(each)), wrong, 0, 0,
           "the same operations");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::elementary_test
