// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/run/streams.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {

/// Runs that go on where a process was ended: their states stand beside the results they are for,
/// in a folder of the same name with ".checkpoints" after it, which is this process's alone.
class ResumableRuns {
 public:
  /// For results in `results`. Throws InputError if another process is at work on them, or the
  /// folder cannot be made.
  explicit ResumableRuns(const std::filesystem::path& results);
  const std::filesystem::path& folder() const { return folder_; }

  struct CheckpointSettings {
    std::string_view version;  ///< of the program: it goes on with its own states only
    double interval = 1;       ///< [s] between two states
    std::function<void(std::size_t begun)> on_resume = {};  ///< how many points go on, if any
    std::function<void(const Fault&)> on_write_error;       ///< states that cannot be kept
  };
  /// All points computed together, those that have ended before taken as they ended. Points that
  /// keep every collision, or frames, are run anew.
  std::vector<results::Outcome> compute(const std::vector<cases::Case>& points,
                                        const Streams& streams, RunOptions options,
                                        const CheckpointSettings& settings);
  /// The results have been written: forgets what was computed. States of runs with other settings
  /// stay.
  void remove();

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;  // of states
  std::optional<CampaignLock> lock_;
};

}  // namespace mahlwerk::campaign
