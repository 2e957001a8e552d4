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
std::string trouble(const std::vector<results::Outcome>& outcomes) {
  for (const results::Outcome& outcome : outcomes)
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stopped.empty()) return r.stopped;
  return "";
}

}  // namespace

int how_it_ended(const std::vector<results::Outcome>& outcomes) {
  constexpr const char* kept = "what was computed until then is kept, and marked incomplete";
  if (const std::string why = trouble(outcomes); !why.empty())
    return tell_end(stopped_by_physics,
                    fmt::format("stopped: {}\nWhat was computed until then is kept.", why),
                    {Fault{"", why, kept, "stopped"}});
  if (stop_wanted())
    return tell_end(interrupted, fmt::format("interrupted: {}.", kept),
                    {Fault{"", "interrupted", kept, "interrupted"}});
  return fine;
}

}  // namespace mahlwerk::app
