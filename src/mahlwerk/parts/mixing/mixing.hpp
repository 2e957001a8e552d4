// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace mahlwerk::parts::mixing {

/// Mixing of the charge, and how it is packed; the section [mixing] (docs/theory/mixing.md).
struct Mixing {
  /// Which balls have the two colours, decided when counting begins.
  enum class Colour { sets, across, height, axis, radius };
  Colour colour = Colour::sets;
  double balls_per_cell = 20;                     ///< [1] about, of a full cell of Lacey's index
  std::optional<double> interval = std::nullopt;  ///< [s] between samples; none: a hundredth
  bool operator==(const Mixing&) const = default;
};

}  // namespace mahlwerk::parts::mixing
