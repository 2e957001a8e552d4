// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace mahlwerk {

struct SinCos {
  double sin, cos;
  bool operator==(const SinCos&) const = default;
};

inline SinCos sin_cos_of_large(double x);

/// Sine and cosine of x [rad], with an absolute error below 2.3e-16 for |x| below 1e4 and 4e-16 up
/// to 2^31. Results of the C library differ between versions and processors; these have the same
/// bits everywhere, and are inline. From |x| = 2^31 on, the C library computes them.
///
/// Argument reduction to |r| <= pi/4 with pi/2 in three parts (Cody and Waite 1980), then minimax
/// polynomials with the coefficients of fdlibm.
inline SinCos sin_cos(double x) {
  if (!(std::abs(x) < 1e5)) return sin_cos_of_large(x);
  constexpr double two_over_pi = 6.36619772367581382433e-01, round = 0x1.8p52;
  constexpr double half_pi_1 = 1.57079632673412561417e+00, half_pi_2 = 6.07710050630396597660e-11,
                   half_pi_3 = 2.02226624879595063154e-21;
  const double shifted = x * two_over_pi + round, k = shifted - round;
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const double r = ((x - k * half_pi_1) - k * half_pi_2) - k * half_pi_3, z = r * r, w = z * z;

  const double s =
      r + r * z *
              ((-1.66666666666666324348e-01 + z * 8.33333333332248946124e-03) +
               w * ((-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06) +
                    w * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  const double c = (1 - 0.5 * z) +
                   w * ((4.16666666666666019037e-02 + z * -1.38888888888741095749e-03) +
                        w * ((2.48015872894767294178e-05 + z * -2.75573143513906633035e-07) +
                             w * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)));
  const bool swapped = (quadrant & 1U) != 0;
  const double sine = swapped ? c : s, cosine = swapped ? s : c;
  return {(quadrant & 2U) != 0 ? -sine : sine, ((quadrant + 1) & 2U) != 0 ? -cosine : cosine};
}

/// `sin_cos` for |x| from 1e5 to 2^31: the parts of pi/2 have so few bits that their multiples are
/// exact.
inline SinCos sin_cos_of_large(double x) {
  if (!(std::abs(x) < 0x1p31)) return {std::sin(x), std::cos(x)};
  constexpr double two_over_pi = 6.36619772367581382433e-01, round = 0x1.8p52;
  constexpr double half_pi[] = {0x1.921fbp+0, 0x1.5110bp-22, 0x1.18469p-44, 0x1.13198a2e03707p-65};
  const double k = (x * two_over_pi + round) - round;
  double r = x;
  for (const double part : half_pi) r -= k * part;
  const SinCos of = sin_cos(r);
  switch (static_cast<std::int64_t>(k) & 3) {
    case 0:
      return of;
    case 1:
      return {of.cos, -of.sin};
    case 2:
      return {-of.sin, -of.cos};
    default:
      return {-of.cos, of.sin};
  }
}

}  // namespace mahlwerk
