// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/campaign/sweep/plan.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Which part of a campaign a process does: each `of`-th run, from `number`, which is 1 ... of.
struct Shard {
  std::size_t number = 1, of = 1;
  bool whole() const { return of == 1; }
};

/// How a stretch of work on a campaign went.
struct WorkSummary {
  std::size_t done = 0, failed = 0;  ///< runs
  std::size_t already_done = 0;      ///< that were done before
  double seconds = 0;
  bool interrupted = false;
};

/// Where the work on a campaign stands, for the line a user watches.
struct WorkProgress {
  double share = 0;                          ///< [1] of the work, estimated
  double seconds = 0;                        ///< since it began
  std::size_t done = 0, failed = 0, of = 0;  ///< runs
};

/// How a campaign is worked on.
struct CampaignSettings {
  std::string version;  ///< of the program
  cases::Catalogue catalogue;
  int threads = 0;                          ///< 0: as many as the machine has
  bool force = false;                       ///< what is in the folder is replaced
  std::optional<bool> folders;              ///< of each run; by default of up to 1000 runs
  const std::atomic<bool>* stop = nullptr;  ///< set: end cleanly, keep what was computed
  /// Writes the results of a run.
  std::function<void(const results::Folder&, const results::Outcome&)> write;
  std::function<void(const WorkProgress&)> progress;  ///< never from two threads at once
  std::function<void(const Fault&)> on_write_error;   ///< states that cannot be kept
};

/// A campaign in its folder: the store, and the results of runs beside it. It belongs to this
/// process alone until it is destroyed; what is in it stays, however the process ends.
class CampaignFolder {
 public:
  /// Of what is in `place`, or anew there; with settings.force always anew. Throws InputError where
  /// it holds something else.
  CampaignFolder(CampaignSettings settings, const std::filesystem::path& case_file,
                 std::vector<cases::Override> set, std::filesystem::path place,
                 const Shard& shard = {});

  /// Reads the cases of all points, then opens the folder. A point whose case has faults fails as
  /// its turn comes; throws InputError if all have, the folder cannot be written to, or another
  /// process is at work there. Does nothing once a stop is wanted.
  void plan(Plan plan);
  /// Does the runs of the plan that wait. Throws InputError where results cannot be kept.
  WorkSummary work();

  Store& store() { return *store_; }  ///< once there is a plan
  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return runs_.size(); }  ///< points
  RunHash run(std::size_t point) const { return runs_[point].hash; }

 private:
  struct Run {
    RunHash hash = 0;
    double work = 0;     // [s], estimated
    double seconds = 0;  // to be simulated
  };
  class ActiveRuns;
  bool stopped() const { return settings_.stop != nullptr && *settings_.stop; }
  void open();
  void refuse_other_case() const;
  void remove_leftovers() const;
  std::vector<cases::Override> settings(std::size_t point) const;
  Run read_run(std::size_t point) const;
  std::vector<std::size_t> waiting_runs(WorkSummary& worked) const;
  bool keeps_folders() const;

  CampaignSettings settings_;
  cases::CaseFile file_;
  std::vector<cases::Override> set_;
  std::filesystem::path path_, case_file_;
  Shard shard_;
  std::optional<CampaignLock> own_lock_, lock_;
  std::optional<Store> store_;
  std::optional<Plan> plan_;
  std::vector<Run> runs_;
};

/// Makes the folder of a campaign that others will work on. Throws InputError if it holds something
/// else, or cannot be made.
void prepare_folder(const std::filesystem::path& place);

/// The store of a campaign's folder, for those who only look. Throws InputError if there is none.
Store open_store(const std::filesystem::path& place);

}  // namespace mahlwerk::campaign
