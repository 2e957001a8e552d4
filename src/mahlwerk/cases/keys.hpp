// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk::cases {

/// A key of a case file.
struct KeyInfo {
  std::string key;                 ///< "mill.speed"; of lists without a number: "balls.diameter"
  std::string unit;                ///< of a number
  Range range;                     ///< of a number, in `unit`
  std::vector<std::string> words;  ///< of a key that takes one of a few
  std::string about;               ///< a sentence on a number
};

/// Every key that a case may have, under one model or another, in the order in which cases are
/// written; without the sections about many runs.
const std::vector<KeyInfo>& all_keys();

}  // namespace mahlwerk::cases
