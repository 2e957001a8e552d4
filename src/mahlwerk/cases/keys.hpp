// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk::cases {

/// A key of a case file.
struct KeyInfo {
  std::string key;                 ///< "mill.speed"; in lists without index: "balls.diameter"
  std::string unit;                ///< of a number
  Range range;                     ///< of a number, in `unit`
  std::vector<std::string> words;  ///< the words that the key takes, if it takes words
  std::string about;               ///< description of a number
};

/// Every key that a case may have under any model, in the order in which cases are written; without
/// the keys of [sweep], [optimise], [match] and [fit].
const std::vector<KeyInfo>& all_keys();

}  // namespace mahlwerk::cases
