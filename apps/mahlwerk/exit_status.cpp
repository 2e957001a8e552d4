// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How runs ended, as message and exit code.
#include <fmt/format.h>

#include "commands.hpp"
#include "messages.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

/// The reason why the first stopped run was stopped; empty if none was.
std::string first_failure(const std::vector<results::Outcome>& outcomes) {
  for (const results::Outcome& outcome : outcomes)
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

}  // namespace

int report_exit_status(const std::vector<results::Outcome>& outcomes) {
  constexpr const char* kept = "results computed until then are kept, and marked incomplete";
  if (const std::string why = first_failure(outcomes); !why.empty())
    return report_end(stopped_by_physics,
                      fmt::format("stopped: {}\nResults computed until then are kept.", why),
                      {Fault{"", why, kept, "stopped"}});
  if (stop_wanted())
    return report_end(interrupted, fmt::format("interrupted: {}.", kept),
                      {Fault{"", "interrupted", kept, "interrupted"}});
  return success;
}

}  // namespace mahlwerk::app
