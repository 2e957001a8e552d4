// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace mahlwerk {

/// A number that is stored in 32 bits, as what a vector is indexed with; >= 0.
constexpr std::size_t as_index(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace mahlwerk
