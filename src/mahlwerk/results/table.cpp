// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/table.hpp"

#include <algorithm>

namespace mahlwerk::results {

double Column::number_of(std::string_view word) {
  const auto place = std::find(words.begin(), words.end(), word);
  const auto number = static_cast<double>(place - words.begin());
  if (place == words.end()) words.emplace_back(word);
  return number;
}

}  // namespace mahlwerk::results
