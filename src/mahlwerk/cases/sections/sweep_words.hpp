// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/cases/sweep.hpp"

// The words and limits of [sweep].
namespace mahlwerk::cases {

/// "grid", "latin-hypercube", ..., in the order of Design.
const std::vector<std::string>& design_words();
/// "linear" and "logarithmic".
const std::vector<std::string>& spacing_words();

/// Whether a design samples ranges and does not take lists.
inline bool needs_ranges(Design design) {
  return design != Design::grid;
}
/// Whether a design needs the key `samples`.
inline bool needs_samples(Design design) {
  return design != Design::grid && design != Design::one_at_a_time;
}

constexpr std::int64_t max_samples = 10'000'000;
constexpr std::int64_t max_steps = 1'000'000;

}  // namespace mahlwerk::cases
