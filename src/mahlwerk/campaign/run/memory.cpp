// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"

namespace mahlwerk::campaign {
namespace {

/// [bytes] per ball: twice the memory measured with 5e4 to 2e5 balls at a filling of 30 %, because
/// a settled bed has more contacts (docs/performance.md, "Memory").
constexpr double soft_ball = 1600, event_ball = 1200;
constexpr double any_replicate = 2e6;  // histograms, time series
constexpr double pair_of_kinds = 8e3;  // a histogram and sums

/// The number in a file; empty if the file holds the word "max".
std::optional<double> number_in(const std::string& file) {
  std::ifstream stream(file);
  double number = 0;
  return stream >> number ? std::optional(number) : std::nullopt;
}

/// [bytes] The number of a line "NAME:  NUMBER kB" of /proc/meminfo.
std::optional<double> meminfo(const std::string& file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key;
    double kilobytes = 0;
    if (words >> key >> kilobytes && key == name + ":") return 1024 * kilobytes;
  }
  return std::nullopt;
}

/// [bytes] Memory left in a control group. Without a limit, its file holds "max" or a number above
/// all memory.
std::optional<double> remaining(const std::string& limit, const std::string& used) {
  const auto most = number_in(limit), now = number_in(used);
  if (!most || !now) return std::nullopt;
  return std::max(0.0, *most - *now);
}

std::string in_megabytes(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

}  // namespace

double memory_needed(const cases::Case& mill_case) {
  const auto balls = static_cast<double>(cases::balls_count(mill_case.balls));
  const auto sets = static_cast<double>(mill_case.balls.size());
  const double each = mill_case.run.engine == cases::EngineName::event
                          ? event_ball
                          : soft_ball;  // "auto": may be soft
  return any_replicate + pair_of_kinds * sets * (sets + 3) / 2 + each * balls;
}

std::optional<double> memory_available(const std::string& root) {
  const std::string group = root + "/sys/fs/cgroup/";
  std::optional<double> least;
  for (const auto& one :
       {meminfo(root + "/proc/meminfo", "MemAvailable"),
        remaining(group + "memory.max", group + "memory.current"),
        remaining(group + "memory/memory.limit_in_bytes", group + "memory/memory.usage_in_bytes")})
    if (one && (!least || *one < *least)) least = one;
  return least;
}

std::vector<Fault> memory_faults(const std::vector<cases::Case>& points, int at_once,
                                 std::optional<double> available) {
  if (points.empty() || !available) return {};
  const cases::Case& largest = *std::ranges::max_element(points, {}, memory_needed);
  double replicates = 0;
  for (const cases::Case& mill_case : points)
    replicates += static_cast<double>(mill_case.run.replicates);
  const auto together = static_cast<double>(replicates_together(largest));  // in each thread
  const double running = std::min(replicates, at_once * together);
  const double each = memory_needed(largest), needed = each * running;
  if (needed <= *available) return {};
  const auto balls = static_cast<double>(cases::balls_count(largest.balls));
  const double fits = balls * std::max(0.0, *available / each - 0.01);
  std::string remedy = running > 1 && each <= *available
                           ? fmt::format("run fewer replicates at once, --threads {:.0f}, or take ",
                                         std::max(1.0, std::floor(*available / (each * together))))
                           : std::string("take ");
  remedy += fmt::format("fewer or larger balls: one replicate of about {:.2g} balls fits", fits);
  return {{largest.powder && largest.powder->grain_size
               ? cases::location_of(largest, "powder.grain_size")
               : cases::location_of(largest, "balls.1.count"),
           fmt::format("{:.3g} balls in {:.0f} replicate{} at once need about {} of memory, but "
                       "{} are available",
                       balls, running, running == 1 ? "" : "s", in_megabytes(needed),
                       in_megabytes(*available)),
           std::move(remedy), "not-enough-memory"}};
}

}  // namespace mahlwerk::campaign
