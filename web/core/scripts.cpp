// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The scripts of pages, from files that travel in the module: WebAssembly has no `.incbin`.
#include "mahlwerk/report/scripts.hpp"

#include <fstream>
#include <iterator>
#include <string>

namespace mahlwerk::report {
namespace {

std::string read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::string_view replay_script() {
  static const std::string script = read("/replay.js");
  return script;
}

std::string_view plots_script() {
  static const std::string script = read("/plots.js");
  return script;
}

}  // namespace mahlwerk::report
