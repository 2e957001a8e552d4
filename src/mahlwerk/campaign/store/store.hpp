// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "mahlwerk/campaign/store/sqlite.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/files/file_lock.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/summary.hpp"

// Store of a campaign: planned points and records of runs in one SQLite file (docs/formats.md).
namespace mahlwerk::campaign {

/// Identity of a run: a hash of its resolved case, the content of the files that the case names,
/// and the program version. Independent of the run's position in a campaign.
using RunHash = std::uint64_t;
RunHash run_hash(const cases::Case& mill_case, std::string_view version);
std::string hash_text(RunHash hash);  ///< 16 hexadecimal digits

/// Column names of a quantity: its value and its half-width, with their unit.
std::array<std::string, 2> columns_of(const results::Quantity& q);

/// The plan of a campaign.
struct CampaignPlan {
  std::string title, version;
  std::filesystem::path case_file;
  std::vector<cases::Override> overrides;
  std::vector<std::string> keys;            ///< varied keys
  std::vector<std::string> following_keys;  ///< those of `keys` that vary together with another
  std::vector<RunHash> runs;                ///< by point
  /// Values of `keys` at a point, as text; empty: not known.
  std::function<std::vector<std::string>(std::size_t point)> values;
};

enum class RunState { waiting, done, failed };

/// Record of a finished run.
struct RunRecord {
  RunHash hash = 0;
  std::string resolved;  ///< the resolved case as text
  std::string engine, regime;
  std::string folder;  ///< of its results, relative to the store; empty: no results are kept
  std::string began;   ///< UTC, ISO 8601
  double wall_seconds = 0, cpu_seconds = 0;
  std::string failure;  ///< why physics stopped the run; empty: it ended regularly
  std::vector<results::Quantity> quantities;
  Notices notices;
};

/// A point of the plan with the record of its run.
struct Point {
  std::size_t number = 0;                ///< from 1
  std::vector<std::string> values = {};  ///< of the varied keys, as in the case: "400 rpm"
  /// Of the requested quantities, in SI units; NaN for missing values, trailing ones may be
  /// omitted.
  std::vector<double> value = {}, ci95 = {};
  RunState state = RunState::done;
  std::string engine = {}, regime = {};  ///< regime: one word, "cataracting"; empty: none
  std::string warnings = {};             ///< codes, separated by ";"
  std::string folder = {};  ///< of its own result, relative to the campaign folder; empty: not kept
  std::string failure = {};  ///< reason of the failure; empty: none
  double wall_seconds = 0, cpu_seconds = 0;

  bool waiting() const { return state == RunState::waiting; }  ///< not run yet
};

struct RunCounts {
  std::size_t points = 0;                         ///< of the plan
  std::size_t waiting = 0, done = 0, failed = 0;  ///< runs of the plan; points may share a run
};

/// Thread-safe. Every failure of the file throws InputError; committed data are kept.
class Store {
 public:
  enum class Access {
    write,  ///< no other writer, but concurrent readers; on a disk of this machine
    shard,  ///< the same on any file system, slower
    read
  };
  Store(const std::filesystem::path& file, Access access);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Replaces the plan. Known runs keep their state, new runs wait.
  void plan(const CampaignPlan& planned);
  std::unordered_map<RunHash, RunState> states() const;  ///< of all runs, also of earlier plans
  std::vector<RunHash> runs() const;                     ///< of the points of the plan, in order
  std::string planned() const;  ///< when the plan was made: UTC, ISO 8601; empty: never

  /// Finished runs whose results folder does not exist below `place`.
  std::vector<RunHash> without_folder(const std::filesystem::path& place) const;

  void keep(const RunRecord& finished);           ///< stores a run that has ended
  void fail(RunHash hash, std::string_view why);  ///< stores a run that cannot be computed
  std::size_t retry();  ///< sets failed runs to waiting; returns their number
  /// Merges the finished runs of `other`, and its plan if that is newer. Returns the number of
  /// runs.
  std::size_t merge(const std::filesystem::path& other);

  RunCounts counts() const;
  std::string title() const;
  std::filesystem::path case_file() const;
  std::vector<cases::Override> overrides() const;
  std::vector<std::string> keys() const;
  bool follows(const std::string& key) const;  ///< whether the key varies together with another
  /// Name, unit and description of the quantities of all runs; values are missing.
  std::vector<results::Quantity> quantities() const;
  /// Notices of all points of the plan that have been run, by code.
  results::NoticeCounts notices() const;
  /// Calls `take` for each point of the plan, in order, with the named quantities.
  void read(const std::vector<std::string>& quantities,
            const std::function<void(const Point&)>& take) const;
  /// Writes the rows of the view `results` as comma-separated text with a heading.
  void write_csv(std::ostream& out) const;

 private:
  struct SweptColumn {
    std::string key, unit, column;
    bool numeric = false, follows = false;
  };
  RunHash hash_in(const Statement& row, int column) const;
  void make_tables();
  void make_view();
  std::string query_of_results() const;
  void refuse_views() const;
  void refuse_other_campaign(const std::filesystem::path& other) const;
  void take_newer_plan();
  std::vector<SweptColumn> swept() const;
  std::vector<results::Quantity> known_quantities() const;
  void keep_old_form();
  bool keep_form(const std::vector<results::Quantity>& form);
  void add_columns(const std::vector<results::Quantity>& quantities);
  void add_columns_of_other(const std::vector<results::Quantity>& quantities);
  void add_unknown(const std::vector<results::Quantity>& quantities);
  void put_in_order();
  void keep_notices(std::string_view hash, const Notices& notices);
  void prepare_summary(const std::vector<results::Quantity>& quantities);

  bool writes_;  ///< opened with Access::write
  mutable std::mutex mutex_;
  Database database_;
  std::optional<Statement> run_done_, run_failed_, notice_, summary_;
  std::vector<results::Quantity> summary_form_;  ///< quantities bound by summary_
};

/// Locks a campaign's folder until the object or the process ends. The lock file stays.
class CampaignLock {
 public:
  using Mode = results::FileLock::Mode;  ///< shared: several shards, each running its own part
  /// Throws InputError if another process holds the lock in a conflicting mode.
  explicit CampaignLock(const std::filesystem::path& file, Mode mode = Mode::exclusive);
  static bool held(const std::filesystem::path& file);  ///< by any process

 private:
  std::unique_ptr<results::FileLock> lock_;
};

}  // namespace mahlwerk::campaign
