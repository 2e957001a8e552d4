// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// The part of a campaign that a process runs: every `of`-th run, from `number`, which is 1 ... of.
struct Shard {
  std::size_t number = 1, of = 1;
  bool whole() const { return of == 1; }
};

/// Summary of one session of work on a campaign.
struct WorkSummary {
  std::size_t done = 0, failed = 0;  ///< runs
  std::size_t already_done = 0;      ///< done before this session
  double seconds = 0;
  bool interrupted = false;
};

/// Progress of the work on a campaign, for the progress line.
struct WorkProgress {
  double share = 0;                          ///< [1] of the work, estimated
  double seconds = 0;                        ///< since it began
  std::size_t done = 0, failed = 0, of = 0;  ///< runs
};

/// Settings of the work on a campaign.
struct CampaignSettings {
  std::string version;  ///< of the program
  cases::Catalogue catalogue;
  int threads = 0;               ///< 0: as many as the machine has
  bool force = false;            ///< replace the content of the folder
  std::optional<bool> folders;   ///< keep a folder of each run; by default for up to 1000 runs
  double checkpoint_every = 60;  ///< [s] between two saves of the state of an active run
  bool films = false;            ///< every replicate keeps frames (RunOptions::replays_of_all)
  const std::atomic<bool>* stop = nullptr;  ///< when set: end regularly, keep what was computed
  /// Writes the results of a run.
  std::function<void(const results::Folder&, const results::Outcome&)> write;
  std::function<void(const WorkProgress&)> progress;  ///< never called from two threads at once
  std::function<void(const Fault&)> on_write_error;   ///< called if states cannot be written
};

/// A campaign in its folder: the store, and the results of runs beside it. Locked for this process
/// until it is destroyed; the content stays, however the process ends.
class CampaignFolder {
 public:
  /// Continues the campaign in `place`, or begins one there; with settings.force always begins a
  /// new one. Throws InputError if the folder holds something else.
  CampaignFolder(CampaignSettings settings, const std::filesystem::path& case_file,
                 std::vector<cases::Override> set, std::filesystem::path place,
                 const Shard& shard = {});

  /// Reads the cases of all points, then opens the folder. A point whose case has faults fails in
  /// its turn; throws InputError if all points have faults, the folder cannot be written to, or
  /// another process is at work there. Does nothing once a stop is requested.
  void plan(Plan plan);
  /// Runs the waiting points of the plan. Throws InputError if results cannot be written.
  WorkSummary work();

  Store& store() { return *store_; }  ///< requires plan()
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

/// Makes the folder of a campaign for other processes to work on. Throws InputError if it holds
/// something else, or cannot be made.
void prepare_folder(const std::filesystem::path& place);

/// Opens the store of a campaign's folder for reading. Throws InputError if there is none.
Store open_store(const std::filesystem::path& place);

}  // namespace mahlwerk::campaign
