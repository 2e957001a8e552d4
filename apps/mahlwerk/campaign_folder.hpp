// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/campaign/sweep/plan.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"

namespace mahlwerk::app {

/// Which part of a campaign a process does: each `of`-th run, from `number`, which is 1 ... of.
struct Shard {
  std::size_t number = 1, of = 1;
  bool whole() const { return of == 1; }
};

/// How a stretch of work on a campaign went.
struct Worked {
  std::size_t done = 0, failed = 0;  ///< runs
  std::size_t there = 0;             ///< that were done before
  double seconds = 0;
  bool interrupted = false;
};

/// A campaign in its folder: the store, and the results of runs beside it. It belongs to this
/// process alone until it is destroyed; what is in it stays, however the process ends.
class CampaignFolder {
 public:
  /// Of what is in `place`, or anew there; with request.force always anew. Throws InputError where
  /// it holds something else.
  CampaignFolder(const Request& request, const std::filesystem::path& case_file,
                 std::vector<cases::Override> set, std::filesystem::path place,
                 const Shard& shard = {});

  /// Reads the cases of all points, then opens the folder. A point whose case has faults fails as
  /// its turn comes; throws InputError if all have, the folder cannot be written to, or another
  /// process is at work there. Does nothing once a stop is wanted.
  void plan(campaign::Plan plan);
  /// Does the runs of the plan that wait. Throws InputError where results cannot be kept.
  Worked work();

  campaign::Store& store() { return *store_; }  ///< once there is a plan
  const std::filesystem::path& place() const { return place_; }
  std::size_t size() const { return runs_.size(); }  ///< points
  campaign::RunHash run(std::size_t point) const { return runs_[point].hash; }

 private:
  struct Run {
    campaign::RunHash hash = 0;
    double work = 0;     // [s], estimated
    double seconds = 0;  // to be simulated
  };
  class Desk;
  void open();
  void refuse_other_case() const;
  void clear_remains() const;
  std::vector<cases::Override> settings(std::size_t point) const;
  Run read_run(std::size_t point) const;
  std::vector<std::size_t> to_do(Worked& worked) const;
  bool keeps_folders() const;

  const Request& request_;
  cases::CaseFile file_;
  cases::Catalogue catalogue_;
  std::vector<cases::Override> set_;
  std::filesystem::path place_, case_file_;
  Shard shard_;
  std::optional<campaign::CampaignLock> own_lock_, lock_;
  std::optional<campaign::Store> store_;
  std::optional<campaign::Plan> plan_;
  std::vector<Run> runs_;
};

/// Makes the folder of a campaign that others will work on. Throws InputError if it holds something
/// else, or cannot be made.
void prepare_place(const std::filesystem::path& place);

/// What there is to tell of a campaign, from its store; where its design tells how much keys
/// matter, that too, if its case can still be read.
report::Campaign campaign_of(const campaign::Store& store);
/// Which quantities answer to which keys; `design` holds the places of the points. Nothing for a
/// design that does not tell.
void add_sensitivities(report::Campaign& campaign, const cases::Sweep& sweep,
                       const std::vector<std::vector<double>>& design);

/// campaign.csv, campaign.html and its pictures, into the folder.
void write_pages(const campaign::Store& store, const report::Campaign& campaign,
                 const std::filesystem::path& place);

/// The store of a campaign's folder, for those who only look. Throws InputError if there is none.
campaign::Store look_into(const std::filesystem::path& place);

}  // namespace mahlwerk::app
