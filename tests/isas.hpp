// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string>
#include <vector>

#include "mahlwerk/base/isa.hpp"

namespace mahlwerk::tests {

/// The instruction sets of this machine for which the program has code.
inline std::vector<Isa> supported_isas() {
  std::vector<Isa> all;
  for (const Isa isa : all_isas)
    if (is_supported(isa)) all.push_back(isa);
  return all;
}

/// Selects an instruction set for everything that is made during the lifetime of this object.
class ChosenIsa {
 public:
  explicit ChosenIsa(Isa isa) {
    const char* value = std::getenv(variable);
    before_ = value == nullptr ? "" : value;
    setenv(variable, std::string(word_of(isa)).c_str(), 1);
  }
  ~ChosenIsa() {
    if (before_.empty())
      unsetenv(variable);
    else
      setenv(variable, before_.c_str(), 1);
  }
  ChosenIsa(const ChosenIsa&) = delete;
  ChosenIsa& operator=(const ChosenIsa&) = delete;

 private:
  static constexpr const char* variable = "MAHLWERK_SIMD";
  std::string before_;
};

}  // namespace mahlwerk::tests
