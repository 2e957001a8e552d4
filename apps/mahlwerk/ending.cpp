// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How runs ended, in words and as an exit code.
#include <fmt/format.h>

#include <cstdio>

#include "commands.hpp"
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
  if (const std::string why = trouble(outcomes); !why.empty()) {
    fmt::print(stderr, "stopped: {}\nWhat was computed until then is kept.\n", why);
    return stopped_by_physics;
  }
  if (stop_wanted()) {
    fmt::print(stderr,
               "interrupted: what was computed until then is kept, and marked incomplete.\n");
    return interrupted;
  }
  return fine;
}

}  // namespace mahlwerk::app
