// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/error.hpp"

#include <utility>

#include "mahlwerk/base/printable.hpp"

namespace mahlwerk {

std::string describe(const std::vector<Fault>& faults) {
  std::string text;
  for (const Fault& fault : faults) {
    if (!text.empty()) text += '\n';
    if (!fault.where.empty()) text += fault.where + ": ";
    text += fault.what;
    if (!fault.remedy.empty()) text += "\n    remedy: " + fault.remedy;
    if (!fault.code.empty()) text += "\n    more:   docs/errors.md#" + fault.code;
  }
  return printable(text);
}

InputError::InputError(std::vector<Fault> faults)
    : std::runtime_error(describe(faults)), faults_(std::move(faults)) {}

InputError::InputError(Fault fault) : InputError(std::vector<Fault>{std::move(fault)}) {}

}  // namespace mahlwerk
