// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The store of a campaign and its surrogate.
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <sstream>

#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/campaign/search/trial_store.hpp"
#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/campaign/surrogate/campaign_surrogate.hpp"
#include "targets.hpp"

namespace mahlwerk::fuzz {
namespace {

namespace fs = std::filesystem;
using campaign::Store;

/// A store of a few settings with one quantity, one of them failed.
void make_store(const fs::path& file) {
  constexpr std::size_t settings = 9;
  Store store(file, Store::Access::shard);
  campaign::CampaignPlan plan;
  plan.title = "a mill";
  plan.version = "1";
  plan.keys = {"mill.speed"};
  for (std::size_t i = 0; i < settings; ++i) plan.runs.push_back(i + 1);
  plan.values = [](std::size_t i) {
    return std::vector<std::string>{std::to_string(100 * (i + 1)) + " rpm"};
  };
  store.plan(plan);
  for (std::size_t i = 0; i + 1 < settings; ++i) {
    campaign::RunRecord record;
    record.hash = i + 1;
    record.engine = "event";
    record.began = "2026-11-27T00:00:00Z";
    const auto x = static_cast<double>(i);
    record.quantities = {{"drawn_power", 1 + x * x, 0.1, "W", "power"},
                         {"replicates", 4, NAN, "1", "replicates"}};
    record.notices = {{"few-hits", Severity::warning, "few hits"}};
    store.keep(record);
  }
  store.fail(settings, "it has no room");
}

const std::string& store_bytes() {
  static const std::string bytes = [] {
    const fs::path file = scratch() / "made.sqlite";
    make_store(file);
    return contents(file);
  }();
  return bytes;
}

/// Statements that change what a store holds; none that reads other files or never ends.
int allowed(void*, int action, const char*, const char*, const char*, const char*) {
  constexpr std::array refused{SQLITE_ATTACH,   SQLITE_PRAGMA, SQLITE_RECURSIVE,
                               SQLITE_FUNCTION, SQLITE_DETACH, SQLITE_CREATE_VTABLE};
  return std::ranges::find(refused, action) == refused.end() ? SQLITE_OK : SQLITE_DENY;
}

void change(const fs::path& file, const std::string& sql) {
  sqlite3* opened = nullptr;
  sqlite3_open(file.c_str(), &opened);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  sqlite3_exec(opened, "PRAGMA synchronous=OFF", nullptr, nullptr, nullptr);
  sqlite3_set_authorizer(opened, allowed, nullptr);
  constexpr int most = 100'000;  // instructions of a statement
  sqlite3_progress_handler(
      opened, most, [](void*) { return 1; }, nullptr);
  sqlite3_exec(opened, sql.c_str(), nullptr, nullptr, nullptr);
}

void read_all(const Store& store) {
  store.counts();
  store.title();
  store.case_file();
  store.overrides();
  store.states();
  store.runs();
  store.without_folder(scratch());
  store.notices();
  std::vector<std::string> names;
  for (const results::Quantity& q : store.quantities()) names.push_back(q.name);
  for (const std::string& key : store.keys()) store.follows(key);
  store.read(names, [](const campaign::Point&) {});
  std::ostringstream text;
  store.write_csv(text);
}

/// The store of a search with one setting, damaged by the same statements.
void read_trials(const std::string& sql) {
  const fs::path file = scratch() / "trials.sqlite";
  const auto trouble = [](const Fault&) {};
  static const std::string made = [&] {
    campaign::TrialStore(file, "power", trouble)
        .keep(7, {.replicates = {{1.5, 2}, {3, 4}}, .failure = ""});
    return contents(file);
  }();
  fs::remove(file.string() + "-journal");
  write_file(file, made);
  change(file, sql);
  campaign::TrialStore(file, "power", trouble).find(7);
}

/// An input is a file, or statements of SQL that damage a good one: no mutation of bytes would
/// change a value and leave a database.
void read_store(const std::string& bytes) {
  const fs::path file = scratch() / "campaign.sqlite", other = scratch() / "other.sqlite";
  for (const char* ending : {"", "-journal", "-wal", "-shm"}) fs::remove(file.string() + ending);
  const bool whole = bytes.starts_with("SQLite format 3");
  write_file(file, whole ? bytes : store_bytes());
  if (!whole) change(file, bytes), read_trials(bytes);
  {
    const Store store(file, Store::Access::read);
    read_all(store);
  }
  Store store(file, Store::Access::shard);
  store.retry();
  write_file(other, store_bytes());
  store.merge(other);
  read_all(store);
  constexpr std::uint64_t seldom = 50;  // it takes as long as a thousand inputs
  if (fingerprint(bytes) % seldom == 0) campaign::surrogate_of(store, "c", {"drawn_power"}, "1");
}

std::vector<std::string> stores() {
  return {"", "UPDATE runs SET status = 'done' WHERE hash = '0000000000000009'",
          "UPDATE summary SET drawn_power_W = 5 WHERE hash = '0000000000000002'",
          "DELETE FROM notices; UPDATE campaign SET value = 'x' WHERE key = 'title'"};
}

void read_surrogate(const std::string& bytes) {
  const fs::path file = scratch() / "mill.json";
  write_file(file, bytes);
  const campaign::CampaignSurrogate read = campaign::read_surrogate(file);
  if (read.quantities.empty()) return;
  campaign::predict(read.quantities.front(), read.point({{"mill.speed", "300 rpm"}}));
}

std::vector<std::string> surrogates() {
  const fs::path file = scratch() / "seed.sqlite";
  write_file(file, store_bytes());
  const Store store(file, Store::Access::read);
  return {campaign::surrogate_text(campaign::surrogate_of(store, "c", {"drawn_power"}, "1"))};
}

}  // namespace

Target store_target() {
  return {"store", read_store, stores};
}
Target surrogate_target() {
  return {"surrogate", read_surrogate, surrogates};
}

}  // namespace mahlwerk::fuzz
