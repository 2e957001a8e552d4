// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Queries of a campaign's store, and merging of the stores of shards.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::campaign {
namespace {

std::size_t count(const Database& database, const std::string& sql) {
  return static_cast<std::size_t>(std::stoull(database.query_text(sql)));
}

/// Attaches another store as `other`; the destructor detaches it.
class AttachedDatabase {
 public:
  AttachedDatabase(Database& database, const std::filesystem::path& file) : database_(database) {
    database_.prepare("ATTACH ? AS other").bind(1, file.string()).run();
  }
  ~AttachedDatabase() {
    try {
      database_.run("DETACH other");
    } catch (const InputError&) {
      // Closing the database detaches it.
    }
  }
  AttachedDatabase(const AttachedDatabase&) = delete;
  AttachedDatabase& operator=(const AttachedDatabase&) = delete;

 private:
  Database& database_;
};

}  // namespace

RunCounts Store::counts() const {
  const std::lock_guard lock(mutex_);
  RunCounts counts;
  counts.points = count(database_, "SELECT count(*) FROM points");
  Statement asked = database_.prepare(
      "SELECT status, count(*) FROM runs WHERE hash IN (SELECT hash FROM points) GROUP BY status");
  while (asked.step()) {
    const auto n = static_cast<std::size_t>(asked.integer(1));
    const std::string status = asked.text(0);
    (status == "done" ? counts.done : status == "failed" ? counts.failed : counts.waiting) = n;
  }
  return counts;
}

std::vector<RunHash> Store::without_folder(const std::filesystem::path& place) const {
  const std::lock_guard lock(mutex_);
  std::vector<RunHash> lost;
  Statement asked =
      database_.prepare("SELECT hash, folder FROM runs WHERE status = 'done' AND folder <> ''");
  std::error_code none;
  while (asked.step())
    if (!std::filesystem::exists(place / asked.text(1), none)) lost.push_back(hash_in(asked, 0));
  return lost;
}

std::string Store::title() const {
  const std::lock_guard lock(mutex_);
  return database_.query_text("SELECT value FROM campaign WHERE key = 'title'");
}

std::string Store::planned() const {
  const std::lock_guard lock(mutex_);
  return database_.query_text("SELECT value FROM campaign WHERE key = 'planned'");
}

std::filesystem::path Store::case_file() const {
  const std::lock_guard lock(mutex_);
  return database_.query_text("SELECT value FROM campaign WHERE key = 'case_file'");
}

std::vector<cases::Override> Store::overrides() const {
  const std::lock_guard lock(mutex_);
  std::vector<cases::Override> list;
  Statement asked = database_.prepare("SELECT key, value FROM overrides ORDER BY position");
  while (asked.step())
    list.push_back({.key = asked.text(0), .value = asked.text(1), .unset = asked.is_null(1)});
  return list;
}

std::vector<std::string> Store::keys() const {
  const std::lock_guard lock(mutex_);
  std::vector<std::string> list;
  for (const SweptColumn& s : swept()) list.push_back(s.key);
  return list;
}

bool Store::follows(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const std::vector<SweptColumn> keys = swept();
  const auto found = std::ranges::find(keys, key, &SweptColumn::key);
  return found != keys.end() && found->follows;
}

std::vector<results::Quantity> Store::quantities() const {
  const std::lock_guard lock(mutex_);
  return known_quantities();
}

void Store::read(const std::vector<std::string>& quantities,
                 const std::function<void(const Point&)>& take) const {
  const std::lock_guard lock(mutex_);
  const std::vector<SweptColumn> keys = swept();
  std::string columns =
      "p.point, r.status, r.engine, r.regime, r.folder, r.message, r.wall_seconds, r.cpu_seconds, "
      "r.warnings";
  for (const SweptColumn& s : keys) columns += ", p." + quoted_name(s.column);
  Statement named =
      database_.prepare("SELECT \"column\", ci95_column FROM quantities WHERE name = ?");
  for (const std::string& name : quantities) {
    std::string pair = ", NULL, NULL";
    named.bind(1, name);
    while (named.step())
      pair = fmt::format(", s.{}, s.{}", quoted_name(named.text(0)), quoted_name(named.text(1)));
    columns += pair;
  }
  Statement asked = database_.prepare(
      fmt::format("SELECT {} FROM points p JOIN runs r ON r.hash = p.hash LEFT JOIN summary s ON "
                  "s.hash = p.hash ORDER BY p.point",
                  columns));
  constexpr int fixed = 9;
  while (asked.step()) {
    Point point;
    point.number = static_cast<std::size_t>(asked.integer(0));
    const std::string status = asked.text(1);
    point.state = status == "done"     ? RunState::done
                  : status == "failed" ? RunState::failed
                                       : RunState::waiting;
    point.engine = asked.text(2);
    point.regime = asked.text(3);
    point.folder = asked.text(4);
    if (point.state == RunState::failed) point.failure = asked.text(5);
    point.wall_seconds = asked.number(6);
    point.cpu_seconds = asked.number(7);
    point.warnings = asked.text(8);
    int at = fixed;
    for (const SweptColumn& s : keys) {
      if (!s.numeric || asked.is_null(at))
        point.values.push_back(asked.text(at));
      else
        point.values.push_back(s.unit.empty()
                                   ? shortest(asked.number(at))
                                   : fmt::format("{} {}", shortest(asked.number(at)), s.unit));
      ++at;
    }
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      point.value.push_back(asked.number(at++));
      point.ci95.push_back(asked.number(at++));
    }
    take(point);
  }
}

void Store::write_csv(std::ostream& out) const {
  const std::lock_guard lock(mutex_);
  Statement asked = database_.prepare(query_of_results());
  std::vector<std::string> cells;
  for (int i = 0; i < asked.columns(); ++i) cells.push_back(results::csv_cell(asked.name(i)));
  out << results::csv_line(cells);
  while (asked.step()) {
    cells.clear();
    for (int i = 0; i < asked.columns(); ++i)
      cells.push_back(asked.is_text(i) ? results::csv_cell(asked.text(i))
                                       : results::csv_cell(asked.number(i)));
    out << results::csv_line(cells);
  }
}

/// Throws InputError if both the plan and that of `other`, attached, have points and share none.
void Store::refuse_other_campaign(const std::filesystem::path& other) const {
  if (count(database_, "SELECT count(*) FROM main.points") > 0 &&
      count(database_, "SELECT count(*) FROM other.points") > 0 &&
      count(database_,
            "SELECT count(*) FROM other.points WHERE hash IN (SELECT hash FROM main.points)") == 0)
    throw InputError(Fault{other.generic_string(), "this is a shard of another campaign",
                           "remove it, or merge it in a folder of its own", "store"});
}

/// Takes the plan of the store attached as `other` if it is newer: the case has changed since.
void Store::take_newer_plan() {
  const auto made = [&](const std::string& store) {
    return database_.query_text("SELECT value FROM " + store + ".campaign WHERE key = 'planned'");
  };
  const bool none = count(database_, "SELECT count(*) FROM main.points") == 0;
  if (!none && made("other") <= made("main")) return;
  const std::string points =
      database_.query_text("SELECT sql FROM other.sqlite_master WHERE name = 'points'");
  database_.run(fmt::format(
      "DROP VIEW IF EXISTS main.results; DROP TABLE main.points; {}; INSERT INTO main.points "
      "SELECT * FROM other.points; DELETE FROM main.swept; INSERT INTO main.swept SELECT * FROM "
      "other.swept; DELETE FROM main.overrides; INSERT INTO main.overrides SELECT * FROM "
      "other.overrides; INSERT OR REPLACE INTO main.campaign SELECT * FROM other.campaign",
      points));
  make_view();
}

std::size_t Store::merge(const std::filesystem::path& other) {
  const Store source(other, Access::read);  // throws if `other` is not a store
  const std::vector<results::Quantity> quantities = source.quantities();
  const std::lock_guard lock(mutex_);
  const AttachedDatabase attached(database_, other);
  Transaction all(database_);
  refuse_other_campaign(other);
  take_newer_plan();
  database_.run(
      "INSERT OR IGNORE INTO main.runs(hash, status) SELECT hash, 'waiting' FROM other.runs");
  summary_.reset();
  add_columns_of_other(quantities);
  const std::string better =
      "hash IN (SELECT o.hash FROM other.runs o JOIN main.runs m ON m.hash = o.hash WHERE "
      "(o.status = 'done' AND m.status <> 'done') OR (o.status = 'failed' AND m.status = "
      "'waiting'))";
  std::string columns = "hash";
  for (const results::Quantity& q : quantities) {
    const auto [column, ci95] = columns_of(q);
    columns += fmt::format(", {}, {}", quoted_name(column), quoted_name(ci95));
  }
  database_.run(fmt::format(
      "INSERT OR REPLACE INTO main.summary({0}) SELECT {0} FROM other.summary WHERE {1}", columns,
      better));
  database_.run(
      fmt::format("DELETE FROM main.notices WHERE {0}; INSERT INTO main.notices SELECT * "
                  "FROM other.notices WHERE {0}",
                  better));
  database_.run(
      fmt::format("INSERT OR REPLACE INTO main.runs SELECT * FROM other.runs WHERE {}", better));
  const std::size_t taken = count(database_, "SELECT changes()");
  all.commit();
  return taken;
}

}  // namespace mahlwerk::campaign
