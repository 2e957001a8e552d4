// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How runs ended, in words and as an exit code.
#include <fmt/format.h>

#include "commands.hpp"
#include "messages.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

/// Why the first run that did not end as asked was stopped; empty if all did.
std::string first_failure(const std::vector<results::Outcome>& outcomes) {
  for (const results::Outcome& outcome : outcomes)
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stop_reason.empty()) return r.stop_reason;
  return "";
}

}  // namespace

int report_exit_status(const std::vector<results::Outcome>& outcomes) {
  constexpr const char* kept = "what was computed until then is kept, and marked incomplete";
  if (const std::string why = first_failure(outcomes); !why.empty())
    return report_end(stopped_by_physics,
                      fmt::format("stopped: {}\nWhat was computed until then is kept.", why),
                      {Fault{"", why, kept, "stopped"}});
  if (stop_wanted())
    return report_end(interrupted, fmt::format("interrupted: {}.", kept),
                      {Fault{"", "interrupted", kept, "interrupted"}});
  return success;
}

}  // namespace mahlwerk::app
