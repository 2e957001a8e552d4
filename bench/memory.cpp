// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "memory.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace mahlwerk::bench {
namespace {

/// Pairs of a process and its parent.
std::vector<std::pair<int, int>> process_parents() {
  std::vector<std::pair<int, int>> found;
  std::error_code gone;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", gone)) {
    std::ifstream file(entry.path() / "stat");
    std::string line;
    if (!std::getline(file, line)) continue;
    // The process name, in brackets, may contain any character.
    const std::size_t after = line.rfind(')');
    int process = 0, parent = 0;
    if (after != std::string::npos && std::sscanf(line.c_str(), "%d", &process) == 1 &&
        std::sscanf(line.c_str() + after + 1, " %*c %d", &parent) == 1)
      found.emplace_back(process, parent);
  }
  return found;
}

double own_peak(int process) {
  std::ifstream file(fmt::format("/proc/{}/status", process));
  double kilobytes = 0;
  for (std::string line; std::getline(file, line);)
    if (std::sscanf(line.c_str(), "VmHWM: %lf", &kilobytes) == 1) break;
  return kilobytes * 1024 / 1e6;
}

double peak_of(int process, const std::vector<std::pair<int, int>>& process_parents) {
  double sum = own_peak(process);
  for (const auto& [child, parent] : process_parents)
    if (parent == process) sum += peak_of(child, process_parents);
  return sum;
}

}  // namespace

double peak_memory(int process) {
  return peak_of(process, process_parents());
}

}  // namespace mahlwerk::bench
