// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/store/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr int format = 2;  // schema version of the tables
constexpr std::array<std::string_view, 3> state_words{"waiting", "done", "failed"};

std::string_view word_of(RunState state) {
  return state_words[static_cast<std::size_t>(state)];
}

InputError damaged(const std::filesystem::path& file, const std::string& what) {
  return InputError(Fault{file.generic_string(), "the store is damaged: " + what,
                          "restore it from a copy, or start from the beginning with --force",
                          "store"});
}

/// Name of a column; the unit "%" is written "percent".
std::string column_of(const std::string& key, std::string_view unit) {
  return results::column_name(key, unit == "%" ? "percent" : unit);
}

}  // namespace

RunHash run_hash(const cases::Case& mill_case, std::string_view version) {
  cases::Case bare = mill_case;
  bare.origins.clear();
  bare.title.clear();
  bare.sweep = {};
  bare.optimise.reset();
  bare.match.reset();
  bare.fit.clear();
  return fingerprint(
      fmt::format("{}\n{}{}", version, cases::write(bare), cases::input_files_fingerprint(bare)));
}

std::array<std::string, 2> columns_of(const results::Quantity& q) {
  return {results::column_name(q.name, q.unit), results::column_name(q.name + "_ci95", q.unit)};
}

std::string hash_text(RunHash hash) {
  return fmt::format("{:016x}", hash);
}

Store::Store(const std::filesystem::path& file, Access access)
    : writes_(access == Access::write),
      database_(file, access == Access::read ? Database::Access::read : Database::Access::write) {
  refuse_views();
  if (access == Access::read) {
    if (database_.query_text("PRAGMA user_version") != std::to_string(format))
      throw InputError(Fault{file.generic_string(),
                             "this is not a campaign's store of this version",
                             "name the folder of a campaign", "store"});
    return;
  }
  // With WAL, readers see the last commit while the campaign runs. WAL needs memory shared between
  // processes of one machine, so shards on a network file system use a rollback journal.
  database_.run(access == Access::write
                    ? "PRAGMA journal_mode=WAL; PRAGMA synchronous=NORMAL"
                    : "PRAGMA journal_mode=TRUNCATE; PRAGMA synchronous=NORMAL");
  const std::string found = database_.query_text("PRAGMA user_version");
  if (found == "0")
    make_tables();
  else if (found != std::to_string(format))
    throw InputError(
        Fault{file.generic_string(), "the campaign's store was made by another version",
              "continue with the version that made it, or start from the beginning with --force",
              "store"});
  database_.run(
      "CREATE TABLE IF NOT EXISTS forms(form TEXT, position INTEGER, name TEXT, unit TEXT, about "
      "TEXT,"
      " PRIMARY KEY(form, position)) WITHOUT ROWID");
}

/// Switches from WAL to a rollback journal, so that a user without write permission for the folder
/// can read the finished store.
Store::~Store() {
  if (!writes_) return;
  run_done_.reset();
  run_failed_.reset();
  notice_.reset();
  summary_.reset();
  try {
    database_.run("PRAGMA busy_timeout=0; PRAGMA journal_mode=DELETE");
  } catch (const InputError&) {
    // Another process reads the store: WAL mode stays.
  }
}

void Store::make_tables() {
  Transaction all(database_);
  if (database_.query_text("SELECT count(*) FROM sqlite_master") != "0")
    throw InputError(Fault{database_.file().generic_string(), "this is another program's database",
                           "move it away", "store"});
  database_.run(
      "CREATE TABLE campaign(key TEXT PRIMARY KEY, value TEXT);"
      "CREATE TABLE overrides(position INTEGER PRIMARY KEY, key TEXT, value TEXT);"
      "CREATE TABLE swept(position INTEGER PRIMARY KEY, key TEXT, unit TEXT, \"column\" TEXT,"
      " \"numeric\" INTEGER, follows INTEGER);"
      "CREATE TABLE points(point INTEGER PRIMARY KEY, hash TEXT);"
      "CREATE TABLE runs(hash TEXT PRIMARY KEY, status TEXT NOT NULL, message TEXT,"
      " attempts INTEGER NOT NULL DEFAULT 0, began TEXT, wall_seconds REAL, cpu_seconds REAL,"
      " engine TEXT, regime TEXT, folder TEXT, \"case\" TEXT, warnings TEXT) WITHOUT ROWID;"
      "CREATE TABLE notices(hash TEXT, position INTEGER, code TEXT, severity TEXT, text TEXT,"
      " PRIMARY KEY(hash, position)) WITHOUT ROWID;"
      "CREATE TABLE quantities(position INTEGER PRIMARY KEY, name TEXT UNIQUE, unit TEXT,"
      " about TEXT, \"column\" TEXT, ci95_column TEXT);"
      "CREATE TABLE summary(hash TEXT PRIMARY KEY) WITHOUT ROWID;");
  make_view();
  database_.run(fmt::format("PRAGMA user_version={}", format));
  all.commit();
}

/// Makes the view `results`: one row per point, with the column names of campaign.csv.
void Store::make_view() {
  database_.run(
      // Names `main`: the bare name could mean the view of an attached store.
      "DROP VIEW IF EXISTS main.results; CREATE VIEW main.results AS " + query_of_results());
}

/// The query of the view `results`. The program asks it instead of the view, which another program
/// may have replaced by one that never ends.
std::string Store::query_of_results() const {
  std::string columns = "p.point";
  for (const SweptColumn& s : swept()) columns += ", p." + quoted_name(s.column);
  columns +=
      ", r.status, r.engine, r.regime, r.wall_seconds, r.cpu_seconds, r.folder, r.message, "
      "r.warnings";
  Statement known =
      database_.prepare("SELECT \"column\", ci95_column FROM quantities ORDER BY position");
  while (known.step())
    columns += fmt::format(", s.{}, s.{}", quoted_name(known.text(0)), quoted_name(known.text(1)));
  return fmt::format(
      "SELECT {} FROM points p JOIN runs r ON r.hash = p.hash LEFT JOIN summary s ON s.hash = "
      "p.hash ORDER BY p.point",
      columns);
}

/// Throws InputError if a table of the store is a view, which could have rows without end.
void Store::refuse_views() const {
  const std::string name = database_.query_text(
      "SELECT name FROM sqlite_master WHERE (type <> 'table' OR sql LIKE 'CREATE VIRTUAL%') AND "
      "name IN ('campaign', 'overrides', 'swept', 'points', 'runs', 'notices', 'quantities', "
      "'summary', 'forms')");
  if (!name.empty())
    throw InputError(Fault{database_.file().generic_string(),
                           fmt::format("`{}` is no table: Mahlwerk did not write this store", name),
                           "name the folder of a campaign as Mahlwerk wrote it", "store"});
}

std::vector<Store::SweptColumn> Store::swept() const {
  std::vector<SweptColumn> list;
  Statement asked = database_.prepare(
      "SELECT key, unit, \"column\", \"numeric\", follows FROM swept ORDER BY position");
  while (asked.step())
    list.push_back({asked.text(0), asked.text(1), asked.text(2), asked.integer(3) != 0,
                    asked.integer(4) != 0});
  return list;
}

void Store::plan(const CampaignPlan& planned) {
  const std::lock_guard lock(mutex_);
  std::vector<SweptColumn> swept;
  for (const std::string& key : planned.keys) swept.push_back({key, "", "", true});
  bool first = true;
  for (std::size_t i = 0; i < planned.runs.size(); ++i) {
    const std::vector<std::string> values = planned.values(i);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const NumberText value = number_text(values[k]);
      if (first) swept[k].unit = value.rest;
      swept[k].numeric =
          swept[k].numeric && std::isfinite(value.number) && value.rest == swept[k].unit;
    }
    first = false;
  }
  Transaction all(database_);
  database_.run(
      "DELETE FROM swept; DELETE FROM overrides; DROP VIEW IF EXISTS results; DROP TABLE points");
  std::string columns;
  for (std::size_t k = 0; k < swept.size(); ++k) {
    SweptColumn& s = swept[k];
    if (!s.numeric) s.unit.clear();
    s.column = column_of(s.key, s.unit);
    columns += fmt::format(", {} {}", quoted_name(s.column), s.numeric ? "REAL" : "TEXT");
    s.follows = std::ranges::find(planned.following_keys, s.key) != planned.following_keys.end();
    database_.prepare("INSERT INTO swept VALUES(?, ?, ?, ?, ?, ?)")
        .bind(1, static_cast<std::int64_t>(k))
        .bind(2, s.key)
        .bind(3, s.unit)
        .bind(4, s.column)
        .bind(5, static_cast<std::int64_t>(s.numeric))
        .bind(6, static_cast<std::int64_t>(s.follows))
        .run();
  }
  database_.run(
      fmt::format("CREATE TABLE points(point INTEGER PRIMARY KEY, hash TEXT{})", columns));
  Statement say = database_.prepare("INSERT OR REPLACE INTO campaign VALUES(?, ?)");
  say.bind(1, "title").bind(2, planned.title).run();
  say.bind(1, "version").bind(2, planned.version).run();
  say.bind(1, "case_file").bind(2, planned.case_file.generic_string()).run();
  say.bind(1, "planned")
      .bind(2, database_.query_text("SELECT strftime('%Y-%m-%dT%H:%M:%fZ', 'now')"))
      .run();
  Statement set = database_.prepare("INSERT INTO overrides(key, value) VALUES(?, ?)");
  for (const cases::Override& one : planned.overrides) {
    set.bind(1, one.key);
    (one.unset ? set.bind_null(2) : set.bind(2, one.value)).run();
  }
  std::string marks;
  for (std::size_t k = 0; k < swept.size(); ++k) marks += ", ?";
  Statement point = database_.prepare(fmt::format("INSERT INTO points VALUES(?, ?{})", marks));
  Statement run =
      database_.prepare("INSERT OR IGNORE INTO runs(hash, status) VALUES(?, 'waiting')");
  for (std::size_t i = 0; i < planned.runs.size(); ++i) {
    const std::string hash = hash_text(planned.runs[i]);
    const std::vector<std::string> values = planned.values(i);
    point.bind(1, static_cast<std::int64_t>(i + 1)).bind(2, hash);
    for (std::size_t k = 0; k < swept.size(); ++k) {
      const int place = static_cast<int>(k) + 3;
      if (swept[k].numeric)
        point.bind(place, number_text(values[k]).number);
      else
        point.bind(place, values[k]);
    }
    point.run();
    run.bind(1, hash).run();
  }
  make_view();
  all.commit();
}

std::unordered_map<RunHash, RunState> Store::states() const {
  const std::lock_guard lock(mutex_);
  std::unordered_map<RunHash, RunState> found;
  Statement asked = database_.prepare("SELECT hash, status FROM runs");
  while (asked.step()) {
    const auto state = std::ranges::find(state_words, asked.text(1));
    if (state == state_words.end())
      throw damaged(database_.file(), fmt::format("a run is \"{}\"", asked.text(1).substr(0, 60)));
    found.emplace(hash_in(asked, 0), static_cast<RunState>(state - state_words.begin()));
  }
  return found;
}

std::vector<RunHash> Store::runs() const {
  const std::lock_guard lock(mutex_);
  std::vector<RunHash> list;
  Statement asked = database_.prepare("SELECT hash FROM points ORDER BY point");
  while (asked.step()) list.push_back(hash_in(asked, 0));
  return list;
}

RunHash Store::hash_in(const Statement& row, int column) const {
  const std::string text = row.text(column);
  RunHash hash = 0;
  constexpr int hexadecimal = 16;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), hash, hexadecimal);
  if (error != std::errc{} || end != text.data() + text.size())
    throw damaged(database_.file(),
                  fmt::format("\"{}\" is not the identity of a run", text.substr(0, 60)));
  return hash;
}

void Store::keep(const RunRecord& f) {
  const std::lock_guard lock(mutex_);
  Transaction all(database_);
  try {
    prepare_summary(f.quantities);
    if (!run_done_)
      run_done_.emplace(database_.prepare(
          "INSERT INTO runs(hash, status, message, began, wall_seconds, cpu_seconds, engine, "
          "regime, folder, \"case\", warnings, attempts) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
          "1) ON "
          "CONFLICT(hash) DO UPDATE SET status = excluded.status, message = excluded.message, "
          "began = excluded.began, wall_seconds = excluded.wall_seconds, cpu_seconds = "
          "excluded.cpu_seconds, engine = excluded.engine, regime = excluded.regime, folder = "
          "excluded.folder, \"case\" = excluded.\"case\", warnings = "
          "excluded.warnings, attempts = attempts + 1"));
    const std::string hash = hash_text(f.hash);
    run_done_->bind(1, hash)
        .bind(2, word_of(f.failure.empty() ? RunState::done : RunState::failed))
        .bind(3, f.failure)
        .bind(4, f.began)
        .bind(5, f.wall_seconds)
        .bind(6, f.cpu_seconds)
        .bind(7, f.engine)
        .bind(8, f.regime)
        .bind(9, f.folder)
        .bind(10, f.resolved)
        .bind(11, results::warning_codes(f.notices))
        .run();
    keep_notices(hash, f.notices);
    summary_->bind(1, hash);
    int place = 1;
    for (const results::Quantity& q : f.quantities) {
      summary_->bind(++place, q.value);
      summary_->bind(++place, q.half_width());
    }
    summary_->run();
    all.commit();
  } catch (...) {
    summary_.reset();  // its columns may have been rolled back
    throw;
  }
}

void Store::fail(RunHash hash, std::string_view why) {
  const std::lock_guard lock(mutex_);
  if (!run_failed_)
    run_failed_.emplace(database_.prepare(
        "INSERT INTO runs(hash, status, message, attempts) VALUES(?, 'failed', ?, 1) ON "
        "CONFLICT(hash) DO UPDATE SET status = 'failed', message = excluded.message, attempts = "
        "attempts + 1"));
  run_failed_->bind(1, hash_text(hash)).bind(2, why).run();
}

std::size_t Store::retry() {
  const std::lock_guard lock(mutex_);
  database_.run("UPDATE runs SET status = 'waiting' WHERE status = 'failed'");
  return static_cast<std::size_t>(std::stoull(database_.query_text("SELECT changes()")));
}

}  // namespace mahlwerk::campaign
