// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Austin's breakage function: fines and coarse pieces, each a power of the size (frg.2).
struct AustinFragments {
  static constexpr std::string_view name = "austin";
  static constexpr std::string_view about = "share (x/y)^gamma + (1 - share) (x/y)^beta";
  double share = 0;  ///< [1] 0 to 1, of the fines, Phi
  double gamma = 0;  ///< [1] > 0 exponent of the fines
  double beta = 0;   ///< [1] > 0 exponent of coarse pieces
  static constexpr auto fields() {
    using M = AustinFragments;
    constexpr Range shares{.least = 0, .most = 1};
    return std::array{
        Field<M>{"share", "", &M::share, shares, "share of the mass that goes to fines, Phi"},
        Field<M>{"gamma", "", &M::gamma, positive, "exponent of the fines, usually 0.5-1.5"},
        Field<M>{"beta", "", &M::beta, positive, "exponent of coarse pieces, usually 2.5-5"}};
  }
  double breakage_function(double ratio, double, double) const {  // (frg.2)
    return share * math::pow(ratio, gamma) + (1 - share) * math::pow(ratio, beta);
  }
  template <class Draw>
  double draw_fragment(double parent, double, Draw& uniform) const {
    const double exponent = uniform() < share ? gamma : beta;
    return parent * math::pow(uniform(), 1 / exponent);
  }
  bool operator==(const AustinFragments&) const = default;
};

}  // namespace mahlwerk::powder
