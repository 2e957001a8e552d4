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

// What a campaign has done and has still to do, in one SQLite file (docs/formats.md).
namespace mahlwerk::campaign {

/// A run by what it computes: its resolved case, what the files it names hold, and the version that
/// runs it. The same run has the same number wherever it stands in a campaign.
using RunHash = std::uint64_t;
RunHash run_hash(const cases::Case& what, std::string_view version);
std::string hash_text(RunHash hash);  ///< 16 hexadecimal digits

/// The columns of a quantity: its value and its half-width, with their unit.
std::array<std::string, 2> columns_of(const results::Quantity& q);

/// A campaign as it is planned.
struct CampaignPlan {
  std::string title, version;
  std::filesystem::path case_file;
  std::vector<cases::Override> overrides;
  std::vector<std::string> keys;            ///< that vary
  std::vector<std::string> following_keys;  ///< of them: those that go side by side with others
  std::vector<RunHash> runs;                ///< by point
  /// Of the keys at a point, as text; empty: not known.
  std::function<std::vector<std::string>(std::size_t point)> values;
};

enum class RunState { waiting, done, failed };

/// What came of a run.
struct RunRecord {
  RunHash hash = 0;
  std::string resolved;  ///< its case
  std::string engine, regime;
  std::string folder;  ///< of its results, relative to the store; empty: none is kept
  std::string began;   ///< UTC, ISO 8601
  double wall_seconds = 0, cpu_seconds = 0;
  std::string failure;  ///< why physics stopped it; empty: it ended as wanted
  std::vector<results::Quantity> quantities;
  Notices notices;
};

/// A point of the plan with what is known of its run.
struct StoredPoint {
  std::size_t number = 0;  ///< from 1
  std::vector<std::string> values;
  RunState state = RunState::waiting;
  std::string engine, regime, folder, message;
  std::string warnings;  ///< codes, separated by ";"
  double wall_seconds = 0, cpu_seconds = 0;
  std::vector<double> value, ci95;  ///< of the quantities asked for; NaN where there is none
};

struct RunCounts {
  std::size_t points = 0;                         ///< of the plan
  std::size_t waiting = 0, done = 0, failed = 0;  ///< runs of the plan; points may share one
};

/// Threads may call at the same time. Every failure of the file is an InputError; what was kept
/// before stays.
class Store {
 public:
  enum class Access {
    write,  ///< by this process alone, beside readers; on a disk of this machine
    shard,  ///< the same on any file system, slower
    read
  };
  Store(const std::filesystem::path& file, Access access);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Makes this the plan. Runs that are known stay as they are, others wait.
  void plan(const CampaignPlan& planned);
  std::unordered_map<RunHash, RunState> states() const;  ///< of all runs, those of old plans, too

  /// Runs whose results should be in a folder below `place`, and are not.
  std::vector<RunHash> without_folder(const std::filesystem::path& place) const;

  void keep(const RunRecord& finished);
  void fail(RunHash hash, std::string_view why);
  std::size_t retry();  ///< failed runs wait again; how many
  /// Takes over what `other` has done, and its plan if that was made later; how many runs.
  std::size_t merge(const std::filesystem::path& other);

  RunCounts counts() const;
  std::string title() const;
  std::filesystem::path case_file() const;
  std::vector<cases::Override> overrides() const;
  std::vector<std::string> keys() const;
  bool follows(const std::string& key) const;  ///< it goes side by side with another
  /// Name, unit and about of all that runs have given; values are missing.
  std::vector<results::Quantity> quantities() const;
  /// The notices of all points of the plan that have been run, by code.
  results::NoticeCounts notices() const;
  /// The points of the plan in order, with the quantities of these names.
  void read(const std::vector<std::string>& quantities,
            const std::function<void(const StoredPoint&)>& take) const;
  /// The view `results` as comma-separated text with a heading.
  void write_csv(std::ostream& out) const;

 private:
  struct SweptColumn {
    std::string key, unit, column;
    bool numeric = false, follows = false;
  };
  void make_tables();
  void make_view();
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

  bool writes_;  ///< and readers look on
  mutable std::mutex mutex_;
  Database database_;
  std::optional<Statement> run_done_, run_failed_, notice_, summary_;
  std::vector<results::Quantity> summary_form_;  ///< quantities that summary_ takes
};

/// Holds a folder's campaign for this process, until it ends however it ends. The file stays.
class CampaignLock {
 public:
  using Mode = results::FileLock::Mode;  ///< shared: with other shards, each of a part of its own
  /// Throws InputError where another process holds it, or it is held with others and wanted alone.
  explicit CampaignLock(const std::filesystem::path& file, Mode mode = Mode::exclusive);
  static bool held(const std::filesystem::path& file);  ///< by any process

 private:
  std::unique_ptr<results::FileLock> lock_;
};

}  // namespace mahlwerk::campaign
