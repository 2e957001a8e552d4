// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "streams.hpp"

namespace mahlwerk::app {

/// Runs that go on where a process was ended: their states stand beside the results they are for,
/// in a folder of the same name with ".checkpoints" after it, which is this process's alone.
class KeptRuns {
 public:
  /// For results in `results`. Throws InputError if another process is at work on them, or the
  /// folder cannot be made.
  explicit KeptRuns(const std::filesystem::path& results);
  const std::filesystem::path& place() const { return place_; }

  /// All points computed together, those that have ended before taken as they ended. Points that
  /// keep every collision, or frames, are run anew.
  std::vector<results::Outcome> compute(const Request& request,
                                        const std::vector<cases::Case>& points,
                                        const Streams& streams);
  /// The results have been written: forgets what was computed. States of runs with other settings
  /// stay.
  void remove();

 private:
  std::filesystem::path place_;
  std::vector<std::filesystem::path> files_;  // of states
  std::optional<campaign::CampaignLock> lock_;
};

}  // namespace mahlwerk::app
