// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk {

/// The known word nearest to `word` by insertions, deletions, exchanges and swaps of neighbours, or
/// empty if none is near enough to be meant.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk
