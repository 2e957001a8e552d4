// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk {

/// The known word with the smallest edit distance to `word` (insertion, deletion, substitution,
/// transposition of neighbours), regardless of case. Empty if none is near enough.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk
