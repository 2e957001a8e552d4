// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace mahlwerk::tests {

/// Checks one number: prints its expected value, the value found, the tolerance and the source, and
/// fails if the deviation exceeds the tolerance (absolute).
inline void states(const std::string& what, double found, double expected, double tolerance,
                   const std::string& source) {
  std::printf("    %-58s expected %.10g, found %.10g, off by %.2g (tolerance %.2g) [%s]\n",
              what.c_str(), expected, found, std::abs(found - expected), tolerance, source.c_str());
  EXPECT_LE(std::abs(found - expected), tolerance) << what << " [" << source << "]";
}

/// Prints a number with its upper bound and the source, and fails if the number exceeds the bound.
inline void stays_below(const std::string& what, double found, double bound,
                        const std::string& source) {
  std::printf("    %-58s at most %.3g, found %.3g [%s]\n", what.c_str(), bound, found,
              source.c_str());
  EXPECT_LE(found, bound) << what << " [" << source << "]";
}

/// The larger of two numbers; NaN if one of them is NaN, which std::max would lose.
template <class T>
T max_or_nan(T a, T b) {
  return a != a || b <= a ? a : b;
}

}  // namespace mahlwerk::tests
