// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace mahlwerk {

/// Converts a 32-bit index, >= 0, to the index type of vectors.
constexpr std::size_t as_index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace mahlwerk
