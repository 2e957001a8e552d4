// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/output.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/commands/reporting/listener.hpp"

namespace mahlwerk::commands {

void to_stdout(std::string_view text) {
  if (listener() != nullptr) return;
  fmt::print("{}", printable(text));
}

void json_to_stdout(const results::Json& json) {
  if (listener() != nullptr) return listener()->result(json.text());
  fmt::print("{}\n", json.text(2));
}

}  // namespace mahlwerk::commands
