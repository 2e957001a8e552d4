// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/campaign/store/sqlite.hpp"
#include "mahlwerk/campaign/store/store.hpp"

namespace mahlwerk::campaign {

/// What a search was told so far, in a file beside its results, so that one that was ended goes on
/// where it was. Threads may call at the same time.
class TrialStore {
 public:
  /// `measure` names what was told of each replicate: other measures are strangers. The file is
  /// made once there is something to keep. Throws InputError where it cannot be read;
  /// `on_write_error` is told where it cannot be written, and the search goes on.
  TrialStore(const std::filesystem::path& file, std::string measure,
             std::function<void(const Fault&)> on_write_error);

  std::optional<TrialResult> find(RunHash run);
  void keep(RunHash run, const TrialResult& result);

 private:
  void write(RunHash run, const TrialResult& result);
  std::string name_of(RunHash run) const;
  void open();

  std::mutex mutex_;
  std::filesystem::path file_;
  std::optional<Database> database_;
  std::string measure_;
  std::function<void(const Fault&)> on_write_error_;
};

}  // namespace mahlwerk::campaign
