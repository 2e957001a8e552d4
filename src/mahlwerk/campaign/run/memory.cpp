// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "mahlwerk/campaign/run/checkpoint.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"

namespace mahlwerk::campaign {
namespace {

/// [bytes] per ball: twice the memory measured with 5e4 to 2e5 balls at a filling of 30 %, because
/// a settled bed has more contacts (docs/performance.md, "Memory").
constexpr double soft_ball = 1600, event_ball = 1200;
constexpr double any_replicate = 2e6;  // histograms, time series
constexpr double pair_of_kinds = 8e3;  // a histogram and sums
constexpr double program_itself = 4e7;
/// [bytes] of an ended replicate: windows and values; maps of wall and plane; spectra of a pair.
constexpr double any_result = 4e4, maps = 2.6e5, spectra_of_pair = 2.5e4;
constexpr double sums_of_pair = 4e3;  // of an ended replicate whose spectra are summed up

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

/// Replicates that are computed at the same time, and [bytes] what those that have ended keep.
struct Needs {
  double running = 0, kept = 0;
};

Needs needs_of(const std::vector<cases::Case>& points, const cases::Case& largest, int at_once,
               bool sums_up) {
  Needs needs;
  double replicates = 0;
  for (const cases::Case& mill_case : points) {
    const auto own = static_cast<double>(mill_case.run.replicates);
    replicates += own;
    needs.kept += own * memory_kept(mill_case, sums_up);
  }
  const auto together = static_cast<double>(replicates_together(largest));  // in each thread
  needs.running = std::min(replicates, at_once * together);
  return needs;
}

}  // namespace

std::string bytes_in_words(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.3g} MB", bytes / 1e6)
                     : fmt::format("{:.3g} GB", bytes / 1e9);
}

double memory_needed(const cases::Case& mill_case) {
  double balls = 0;  // of bodies, their spheres
  for (const cases::BallSet& set : mill_case.balls)
    balls += static_cast<double>(set.count * set.body.count());
  if (mill_case.bed_breakage)
    balls +=
        static_cast<double>(cases::largest_grain_number(mill_case) - mill_case.balls.back().count);
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

double memory_kept(const cases::Case& mill_case, bool sums_up) {
  const auto sets = static_cast<double>(mill_case.balls.size());
  const auto faces = static_cast<double>(cases::wall_faces(mill_case));
  const double pairs = sets * (0.5 * (sets + 1) + faces);
  if (sums_up && results::can_be_summed_up(mill_case)) return any_result + sums_of_pair * pairs;
  return any_result + maps + spectra_of_pair * pairs;
}

double memory_of_run(const std::vector<cases::Case>& points, int at_once, bool sums_up) {
  const cases::Case& largest = *std::ranges::max_element(points, {}, memory_needed);
  const Needs needs = needs_of(points, largest, at_once, sums_up);
  const double states = std::min(needs.kept, static_cast<double>(Checkpoint::most_in_memory));
  return program_itself + needs.running * memory_needed(largest) + needs.kept + states;
}

std::vector<Fault> memory_faults(const std::vector<cases::Case>& points, int at_once,
                                 std::optional<double> available, bool sums_up) {
  if (points.empty() || !available) return {};
  const cases::Case& largest = *std::ranges::max_element(points, {}, memory_needed);
  const auto [running, kept] = needs_of(points, largest, at_once, sums_up);
  const double each = memory_needed(largest), needed = each * running + kept;
  if (needed <= *available) return {};
  if (kept > 0.5 * *available)
    return {{cases::location_of(largest, "run.replicates"),
             fmt::format("the results of all replicates need up to {} of memory, but {} are "
                         "available",
                         bytes_in_words(kept), bytes_in_words(*available)),
             "take fewer run.replicates; the same time in fewer, longer replicates costs no memory",
             "not-enough-memory"}};
  const double left = *available - kept;
  const auto balls = static_cast<double>(cases::balls_count(largest.balls));
  const double fits = balls * std::max(0.0, left / each - 0.01);
  const auto together = static_cast<double>(replicates_together(largest));
  std::string remedy = running > 1 && each <= left
                           ? fmt::format("run fewer replicates at once, --threads {:.0f}, or take ",
                                         std::max(1.0, std::floor(left / (each * together))))
                           : std::string("take ");
  remedy += fmt::format("fewer or larger balls: one replicate of about {:.2g} balls fits", fits);
  return {{largest.powder && largest.powder->grain_size
               ? cases::location_of(largest, "powder.grain_size")
               : cases::location_of(largest, "balls.1.count"),
           fmt::format("{:.3g} balls in {:.0f} replicate{} at once need about {} of memory, but "
                       "{} are available",
                       balls, running, running == 1 ? "" : "s", bytes_in_words(needed),
                       bytes_in_words(*available)),
           std::move(remedy), "not-enough-memory"}};
}

}  // namespace mahlwerk::campaign
