// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The script of the replay, from a file that travels in the module: WebAssembly has no `.incbin`.
#include <fstream>
#include <iterator>
#include <string>

#include "mahlwerk/report/replay.hpp"

namespace mahlwerk::report {

std::string_view replay_script() {
  static const std::string script = [] {
    std::ifstream file("/replay.js", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  return script;
}

}  // namespace mahlwerk::report
