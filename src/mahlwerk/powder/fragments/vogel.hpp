// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Vogel's breakage function: a power of the size, cut off below the size x_min (frg.1).
struct VogelFragments {
  static constexpr std::string_view name = "vogel";
  static constexpr std::string_view about = "(x/y)^q (1 + tanh((x - x_min)/x_min))/2, scaled to 1";
  double q = 0;      ///< [1] > 0
  double x_min = 0;  ///< [m] > 0
  static constexpr auto fields() {
    using M = VogelFragments;
    return std::array{Field<M>{"q", "", &M::q, positive, "exponent of the fragments' sizes, q"},
                      Field<M>{"x_min", "m", &M::x_min, positive,
                               "size below which there are few fragments, x'"}};
  }
  double breakage_function(double ratio, double parent, double) const {  // (frg.1)
    return math::pow(ratio, q) * above(ratio * parent) / above(parent);
  }
  /// Draws the larger of two sizes, each distributed by one factor of `breakage_function`.
  template <class Draw>
  double draw_fragment(double parent, double, Draw& uniform) const {
    const double one = parent * math::pow(uniform(), 1 / q);
    const double share = uniform() * above(parent);
    if (!(share > above(0))) return one;
    return std::max(one, x_min * (1 + math::log(share / (1 - share)) / 2));  // atanh(2 share - 1)
  }
  bool operator==(const VogelFragments&) const = default;

 private:
  double above(double x) const { return 0.5 * (1 + math::tanh((x - x_min) / x_min)); }
};

}  // namespace mahlwerk::powder
