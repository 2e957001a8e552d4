// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::parts::wear {

/// Wear of balls and jar: the section [wear] (docs/theory/wear-heat.md).
struct Wear {
  enum class Model {
    archard,  ///< by normal force and sliding distance (wea.1)
    finnie    ///< by energy and angle of each impact (wea.4)
  };
  Model model = Model::archard;
  double coefficient = 1e-4;  ///< [1] Archard's K, or Finnie's k
  bool operator==(const Wear&) const = default;
};

}  // namespace mahlwerk::parts::wear
