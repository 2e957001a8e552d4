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

/// Results of a search so far, in a file beside its output, so that an interrupted search resumes.
/// Thread-safe.
class TrialStore {
 public:
  /// `measure` identifies the outcomes of each replicate: results of other measures are not found.
  /// The file is made with the first result. Throws InputError if it cannot be opened; if it
  /// cannot be written or read later, `on_write_error` is called and the search continues.
  TrialStore(const std::filesystem::path& file, std::string measure,
             std::function<void(const Fault&)> on_write_error);

  std::optional<TrialResult> find(RunHash run);  ///< empty if there is none
  void keep(RunHash run, const TrialResult& result);

 private:
  std::optional<TrialResult> read(RunHash run) const;
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
