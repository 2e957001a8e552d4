// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// One-parameter family of curves by t10, the share finer than a tenth of the broken grain (King).
struct T10Fragments {
  static constexpr std::string_view name = "t10";
  static constexpr std::string_view about = "t_n = 1 - (1 - t10)^((9/(n - 1))^alpha), n = y/x";
  double t10 = 0;    ///< [1] 0 to 1; 0: that of the breakage model, which must predict it
  double alpha = 1;  ///< [1] > 0
  static constexpr auto fields() {
    using M = T10Fragments;
    constexpr Range shares{.least = 0, .most = 1, .without_most = true};
    return std::array{Field<M>{"t10", "", &M::t10, shares,
                               "share finer than a tenth of the broken grain; 0: predicted by the "
                               "breakage model",
                               0.0, "predicted by the breakage model"},
                      Field<M>{"alpha", "", &M::alpha, positive, "shape exponent of the family",
                               1.0, "about 1; no public source found"}};
  }
  double breakage_function(double ratio, double, double model_t10) const {  // (frg.3)
    if (ratio >= 1) return 1;
    return -math::expm1(math::log1p(-of(model_t10)) * math::pow(9 * ratio / (1 - ratio), alpha));
  }
  template <class Draw>
  double draw_fragment(double parent, double model_t10, Draw& uniform) const {
    const double n = math::pow(math::log(uniform()) / math::log1p(-of(model_t10)), 1 / alpha) / 9;
    return parent * n / (1 + n);
  }
  bool operator==(const T10Fragments&) const = default;

 private:
  double of(double model_t10) const { return t10 > 0 ? t10 : model_t10; }
};

}  // namespace mahlwerk::powder
