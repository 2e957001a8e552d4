// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/field.hpp"

namespace mahlwerk::powder {

/// Two pieces with uniformly distributed volumes (frg.4).
struct BinaryFragments {
  static constexpr std::string_view name = "binary";
  static constexpr std::string_view about = "two pieces, the volume of each uniform";
  static constexpr auto fields() { return std::array<Field<BinaryFragments>, 0>{}; }
  double breakage_function(double ratio, double, double) const {
    return math::pow(ratio, 6);
  }  // (frg.4)
  template <class Draw>
  double draw_fragment(double parent, double, Draw& uniform) const {
    return parent * math::pow(uniform(), 1.0 / 6);
  }
  bool operator==(const BinaryFragments&) const = default;
};

/// Two equal pieces.
struct Halves {
  static constexpr std::string_view name = "halves";
  static constexpr std::string_view about = "two equal pieces";
  static constexpr auto fields() { return std::array<Field<Halves>, 0>{}; }
  static constexpr double half = 0.7937005259840998;              // 2^(-1/3)
  double breakage_function(double ratio, double, double) const {  // (frg.5)
    return ratio >= half * (1 - 1e-9) ? 1 : 0;
  }
  template <class Draw>
  double draw_fragment(double parent, double, Draw&) const {
    return parent * half;
  }
  bool operator==(const Halves&) const = default;
};

}  // namespace mahlwerk::powder
