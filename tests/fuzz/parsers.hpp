// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace mahlwerk::fuzz {

/// The parser that the first byte of an input selects.
enum class Reader : std::uint8_t {
  case_file,
  mesh,
  motion,
  measurements,
  checkpoint,
  state,
  surrogate
};
constexpr std::uint8_t readers = 7;

/// A valid state, as a seed for the parser of states.
std::string state_of_a_run();

}  // namespace mahlwerk::fuzz
