// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "rival.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "child.hpp"

namespace mahlwerk::bench {

std::optional<Rival> Rival::from_environment() {
  const char* const name = std::getenv("MAHLWERK_RIVAL");
  if (name == nullptr || *name == '\0') {
    fmt::print(stderr,
               "bench fluid: times Mahlwerk alone. To time another program in the same turns, set "
               "MAHLWERK_RIVAL to an executable that is called with PACKING BALLS COLLISIONS and "
               "prints the number of collisions that it has simulated (bench/rival.hpp).\n");
    return {};
  }
  const std::filesystem::path program = std::filesystem::absolute(name);
  if (!std::filesystem::is_regular_file(program) || access(program.c_str(), X_OK) != 0)
    throw std::runtime_error(
        fmt::format("MAHLWERK_RIVAL: '{}' is not an executable file", program.string()));
  return Rival(program);
}

double Rival::collisions_per_second(double packing, int balls) const {
  const std::int64_t warm_up = 5 * std::int64_t{balls}, timed = 600'000;
  const Run brief = run(packing, balls, warm_up), full = run(packing, balls, warm_up + timed);
  const double more = full.cpu_seconds - brief.cpu_seconds;
  if (!(more > 0) || full.collisions <= brief.collisions)
    throw std::runtime_error(fmt::format(
        "MAHLWERK_RIVAL: {} collisions took {:.3g} s, {} took {:.3g} s; no speed follows",
        brief.collisions, brief.cpu_seconds, full.collisions, full.cpu_seconds));
  return static_cast<double>(full.collisions - brief.collisions) / more;
}

Rival::Run Rival::run(double packing, int balls, std::int64_t collisions) const {
  const TemporaryFolder folder;
  std::string last;
  const ChildResult result = watch_child({{program_.string(), fmt::format("{:.2f}", packing),
                                           std::to_string(balls), std::to_string(collisions)},
                                          folder.path(),
                                          {},
                                          600},
                                         [&](std::string_view line) { last = line; });
  if (!result.fault.empty())
    throw std::runtime_error(fmt::format("MAHLWERK_RIVAL: {} {}", program_.string(), result.fault));
  std::int64_t simulated = 0;
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), simulated);
  if (error != std::errc{} || end != last.data() + last.size() || simulated < collisions)
    throw std::runtime_error(
        fmt::format("MAHLWERK_RIVAL: {} should print a number of collisions, at least {}, on its "
                    "last line; it printed '{}'",
                    program_.string(), collisions, last));
  return {simulated, result.cpu_seconds};
}

}  // namespace mahlwerk::bench
