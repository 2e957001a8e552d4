// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/trig.hpp"

// Elementary functions with the same bits on every processor, with every C library and in browsers.
// Those of the C library differ in the last bit, which is enough for a chaotic run to take another
// course. Only IEEE operations; polynomials with the coefficients of fdlibm. Templates on V take a
// double or a register of doubles (base/lanes.hpp), with the same bits in each lane.
namespace mahlwerk::math {

/// A number as the sum of a double and a much smaller rest.
template <class V>
struct SumOf {
  V high, low;
};
using Sum = SumOf<double>;

/// The product of two numbers, exact (Dekker 1971); neither above 1e290.
template <class V>
[[gnu::always_inline]] inline SumOf<V> product(const V& a, const V& b) {
  const auto split = [](const V& v) __attribute__((always_inline)) {
    const V shifted = 0x1p27 * v + v, high = shifted - (shifted - v);
    return SumOf<V>{high, v - high};
  };
  const SumOf<V> x = split(a), y = split(b);
  const V high = a * b;
  return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

/// The nearest whole number, for |x| below 2^51.
template <class V>
[[gnu::always_inline]] inline V nearest(const V& x) {
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

/// x times 2^k.
inline double scaled(double x, int k) {
  if (k < -1000 || k > 1000) return std::ldexp(x, k);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52U);
}
/// The same for whole k from -1000 to 1000.
template <Vector V>
[[gnu::always_inline]] inline V scaled(const V& x, const V& k) {
  using Words = typename RegisterOf<width_of<V>>::Words;
  return x * (V)(((Words)(k + 0x1.8p52) + 1023U) << 52U);  // the last bits are those of k
}

struct Parts {
  double mantissa;  ///< [1/2, 1)
  int exponent;
};

/// The parts of finite x > 0.
inline Parts parts_of(double x) {
  if (x < std::numeric_limits<double>::min()) {
    const Parts normal = parts_of(x * 0x1p54);
    return {normal.mantissa, normal.exponent - 54};
  }
  constexpr std::uint64_t fraction = (std::uint64_t{1} << 52U) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return {std::bit_cast<double>((bits & fraction) | (std::uint64_t{1022} << 52U)),
          static_cast<int>(bits >> 52U) - 1022};
}

/// The mantissa [1/2, 1) and the exponent of finite x > 0; in registers of x not below 2^-1022.
template <class V>
struct PartsOf {
  V mantissa, exponent;
};
template <class V>
[[gnu::always_inline]] inline PartsOf<V> parts_in_lanes(const V& x) {
  if constexpr (std::same_as<V, double>) {
    const Parts parts = parts_of(x);
    return {parts.mantissa, static_cast<double>(parts.exponent)};
  } else {
    using Words = typename RegisterOf<width_of<V>>::Words;
    constexpr std::uint64_t fraction = (std::uint64_t{1} << 52U) - 1;
    const auto bits = (Words)x;
    // As last bits of 2^52 the exponent is a number that is added to 2^52.
    const V biased = (V)(bits >> 52U | std::bit_cast<std::uint64_t>(0x1p52)) - 0x1p52;
    return {(V)((bits & fraction) | (std::uint64_t{1022} << 52U)), biased - 1022.0};
  }
}

/// log x for finite x > 0, relative error below 1e-17; in registers of x not below 2^-1022.
template <class V>
[[gnu::always_inline]] inline SumOf<V> log_sum(const V& x) {
  const PartsOf<V> parts = parts_in_lanes(x);
  const V zero{};
  const MaskOf<V> small = less(parts.mantissa, zero + 0.5 * std::numbers::sqrt2);
  const V m = select(small, 2.0 * parts.mantissa, parts.mantissa);
  const V k = select(small, parts.exponent - 1.0, parts.exponent);
  // log m = 2 atanh s, s = f/(2 + f)
  const V f = m - 1.0, below = 2.0 + f, below_rest = f - (below - 2.0), s = f / below;
  const SumOf<V> back = product(s, below);
  const V s_rest = ((f - back.high) - back.low - s * below_rest) / below;
  const V z = s * s, w = z * z;
  const V tail = w * (3.999999999940941908e-01 +
                      w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01)) +
                 z * (6.666666666666735130e-01 +
                      w * (2.857142874366239149e-01 +
                           w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  constexpr double ln2 = 6.93147180369123816490e-01, ln2_rest = 1.90821492927058770002e-10;
  const V whole = k * ln2, high = whole + 2.0 * s;
  const V lost =
      select(less(abs(2.0 * s), abs(whole)), (whole - high) + 2.0 * s, (2.0 * s - high) + whole);
  const V low = lost + (2.0 * s_rest + s * tail + k * ln2_rest);
  return {high + low, (high - (high + low)) + low};
}

/// A number times 2^exponent.
template <class V>
struct ScaledOf {
  V number, exponent;
};
/// exp(x.high + x.low) for |x.high| below 750, relative error below 1.4e-16 and that of its
/// argument.
template <class V>
[[gnu::always_inline]] inline ScaledOf<V> exp_parts(const SumOf<V>& x) {
  constexpr double ln2 = 6.93147180369123816490e-01, ln2_rest = 1.90821492927058770002e-10;
  const V k = nearest(x.high * (1 / std::numbers::ln2));
  const V high = x.high - k * ln2, low = k * ln2_rest - x.low, r = high - low, t = r * r;
  const V c =
      r - t * (1.66666666666666019037e-01 +
               t * (-2.77777777770155933842e-03 +
                    t * (6.61375632143793436117e-05 +
                         t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
  return {1.0 - ((low - (r * c) / (2.0 - c)) - high), k};
}
inline double exp_sum(const Sum& x) {
  if (!(x.high < 709.8)) return x.high > 0 ? std::numeric_limits<double>::infinity() : x.high;
  if (x.high < -745.2) return 0;
  const ScaledOf<double> parts = exp_parts(x);
  return scaled(parts.number, static_cast<int>(parts.exponent));
}

inline double log(double x) {
  if (!(x > 0) || std::isinf(x))
    return x == 0  ? -std::numeric_limits<double>::infinity()
           : x > 0 ? x
                   : std::numeric_limits<double>::quiet_NaN();
  return log_sum(x).high;
}
inline double exp(double x) {
  return exp_sum({x, 0});
}
/// x to the power y for x >= 0; relative error below 2e-16 (1 + |y log x| / 16).
inline double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (!(x > 0) || std::isinf(x) || !std::isfinite(y)) return std::pow(x, y);  // ends of the range
  const Sum l = log_sum(x);
  if (std::abs(y * l.high) > 800)
    return y * l.high > 0 ? std::numeric_limits<double>::infinity() : 0;
  const Sum p = product(y, l.high);
  return exp_sum({p.high, p.low + y * l.low});
}
/// In registers: log x and x to the power y for x not below 2^-1022 and |y log x| below 690.
template <Vector V>
[[gnu::always_inline]] inline V log(const V& x) {
  return log_sum(x).high;
}
template <Vector V>
[[gnu::always_inline]] inline V pow(const V& x, double y) {
  const SumOf<V> l = log_sum(x), p = product(V{} + y, l.high);
  const ScaledOf<V> parts = exp_parts(SumOf<V>{p.high, p.low + y * l.low});
  return scaled(parts.number, parts.exponent);
}
inline double exp2(double x) {
  return pow(2, x);
}
/// log x times the constant `by`; exact for whole powers of a base.
inline double scaled_log(double x, const Sum& by) {
  if (!(x > 0) || std::isinf(x)) return log(x);
  const Sum l = log_sum(x), p = product(l.high, by.high);
  return p.high + (p.low + (l.high * by.low + l.low * by.high));
}
inline double log2(double x) {
  return scaled_log(x, {1.4426950408889634, 2.0355273740931033e-17});
}
inline double log10(double x) {
  return scaled_log(x, {0.4342944819032518, 1.098319650216765e-17});
}
/// exp(x) - 1 and log(1 + x) without cancellation (Kahan).
inline double expm1(double x) {
  const double u = exp(x);
  if (u == 1) return x;
  if (u - 1 == -1 || x > 700) return u - 1;
  return (u - 1) * x / log(u);
}
inline double log1p(double x) {
  const double u = 1 + x;
  return u == 1 ? x : x > 1e16 || std::isinf(u) ? log(u) : log(u) * x / (u - 1);
}
inline double tanh(double x) {
  const double e = expm1(-2 * std::abs(x));
  return std::copysign(-e / (e + 2), x);
}

inline double sin(double x) {
  return sin_cos(x).sin;
}
inline double cos(double x) {
  return sin_cos(x).cos;
}
inline double tan(double x) {
  const SinCos of = sin_cos(x);
  return of.sin / of.cos;
}

inline double atan(double x) {
  struct Middle {
    double angle, rest;
  };
  const double size = std::abs(x);
  if (!(size < 0x1p66)) return std::isnan(x) ? x : std::copysign(0.5 * std::numbers::pi, x);
  Middle at{0, 0};
  double r = size;
  if (size >= 2.4375)
    at = {1.57079632679489655800e+00, 6.12323399573676603587e-17}, r = -1 / size;
  else if (size >= 1.1875)
    at = {9.82793723247329054082e-01, 1.39033110312309984516e-17},
    r = (size - 1.5) / (1 + 1.5 * size);
  else if (size >= 0.6875)
    at = {7.85398163397448278999e-01, 3.06161699786838301793e-17}, r = (size - 1) / (size + 1);
  else if (size >= 0.4375)
    at = {4.63647609000806093515e-01, 2.26987774529616870924e-17}, r = (2 * size - 1) / (2 + size);
  const double z = r * r, w = z * z;
  const double odd =
      z * (3.33333333333329318027e-01 +
           w * (1.42857142725034663711e-01 +
                w * (9.09088713343650656196e-02 +
                     w * (6.66107313738753120669e-02 +
                          w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const double even =
      w * (-1.99999999998764832476e-01 +
           w * (-1.11111104054623557880e-01 +
                w * (-7.69187620504482999495e-02 +
                     w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
  return std::copysign(at.angle - ((r * (odd + even) - at.rest) - r), x);
}
/// The angle of (x, y) from -pi to pi.
inline double atan2(double y, double x) {
  constexpr double pi = std::numbers::pi, pi_rest = 1.2246467991473531772e-16;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (y == 0) return std::signbit(x) ? std::copysign(pi, y) : y;
  if (x == 0) return std::copysign(0.5 * pi, y);
  if (std::isinf(x) || std::isinf(y)) return std::atan2(y, x);  // ends of the range
  const double angle = atan(std::abs(y / x));
  return std::copysign(x > 0 ? angle : pi - (angle - pi_rest), y);
}
inline double asin(double x) {
  return std::abs(x) <= 1 ? atan2(x, std::sqrt((1 - x) * (1 + x)))
                          : std::numeric_limits<double>::quiet_NaN();
}

/// exp(-x^2) with the rounding of x^2 taken into account.
inline double gauss(double x) {
  const Sum square = product(x, x);
  return exp_sum({-square.high, -square.low});
}
/// 1 - erf x, relative error below 6e-15. Below 1 a series of positive terms of erf, above it the
/// continued fraction of erfc (Abramowitz and Stegun 7.1.6, 7.1.14).
inline double erfc(double x) {
  if (std::isnan(x)) return x;
  const double size = std::abs(x);
  if (size > 28) return x > 0 ? 0 : 2;
  const double root_pi = 1 / std::numbers::inv_sqrtpi;
  if (size < 1) {
    double term = size, sum = size;
    for (int n = 1; term > 1e-17 * sum; ++n) {
      term *= 2 * size * size / (2 * n + 1);
      sum += term;
    }
    const double erf = 2 / root_pi * gauss(size) * sum;
    return x > 0 ? 1 - erf : 1 + erf;
  }
  double fraction = size;
  for (int n = static_cast<int>(20 + 200 / (size * size)); n > 0; --n)
    fraction = size + 0.5 * n / fraction;
  const double rest = gauss(size) / (root_pi * fraction);
  return x > 0 ? rest : 2 - rest;
}
inline double erf(double x) {
  if (!(std::abs(x) < 0.5)) return x > 0 ? 1 - erfc(x) : erfc(-x) - 1;
  double term = x, sum = x;
  for (int n = 1; n < 20; ++n) {
    term *= 2 * x * x / (2 * n + 1);
    sum += term;
  }
  return 2 * std::numbers::inv_sqrtpi * gauss(x) * sum;
}

/// The length of (x, y) of sizes between 1e-150 and 1e150.
inline double hypot(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// x to the power 1/n for x >= 0 and n = 3 or 5: Newton's iteration on x scaled to [1, 2^n).
template <int n>
double root(double x) {
  if (!(x > 0) || std::isinf(x)) return x;
  const Parts parts = parts_of(x);
  const int exponent = parts.exponent - 1;
  const int whole = exponent >= 0 ? exponent / n : -((n - 1 - exponent) / n);
  const double radicand = scaled(2 * parts.mantissa, exponent - n * whole);
  double r = 1 + (radicand - 1) / (n + radicand);  // within 8 %
  constexpr int iterations = 6;
  for (int i = 0; i < iterations; ++i) {
    double power = r;
    for (int k = 2; k < n; ++k) power *= r;  // r^(n - 1)
    r += (radicand / power - r) / n;
  }
  return scaled(r, whole);
}
inline double cbrt(double x) {
  return x < 0 ? -root<3>(-x) : root<3>(x);
}
inline double fifth_root(double x) {
  return root<5>(x);
}

}  // namespace mahlwerk::math
