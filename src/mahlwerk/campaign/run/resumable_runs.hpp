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

/// Runs that resume where a process was ended. Their states are beside the results, in a folder of
/// the same name with ".checkpoints" appended, which only this process uses.
class ResumableRuns {
 public:
  /// For results in `results`. Throws InputError if another process is at work on them, or the
  /// folder cannot be made.
  explicit ResumableRuns(const std::filesystem::path& results);
  const std::filesystem::path& folder() const { return folder_; }

  struct CheckpointSettings {
    std::string_view version;  ///< of the program; states of other versions are not used
    double interval = 1;       ///< [s] between two saves of a state
    std::function<void(std::size_t begun)> on_resume = {};  ///< if points resume: how many
    std::function<void(const Fault&)> on_write_error;       ///< called if states cannot be written
  };
  /// Computes all points together; the kept states of points that have ended are used. Points that
  /// record every collision, or frames, start from the beginning.
  std::vector<results::Outcome> compute(const std::vector<cases::Case>& points,
                                        const Streams& streams, RunOptions options,
                                        const CheckpointSettings& settings);
  /// Removes the states once the results are written. States of runs with other settings stay.
  void remove();

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;  // of states
  std::optional<CampaignLock> lock_;
};

}  // namespace mahlwerk::campaign
