// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/trial_store.hpp"

#include <fmt/format.h>

#include "mahlwerk/base/fingerprint.hpp"

namespace mahlwerk::campaign {

TrialStore::TrialStore(const std::filesystem::path& file, std::string measure,
                       std::function<void(const Fault&)> trouble)
    : file_(file), measure_(std::move(measure)), trouble_(std::move(trouble)) {
  if (std::filesystem::exists(file_)) open();
}

void TrialStore::open() {
  database_.emplace(file_, Database::Access::write);
  database_->run(
      "PRAGMA journal_mode=DELETE; PRAGMA synchronous=NORMAL;"
      "CREATE TABLE IF NOT EXISTS trials(run TEXT PRIMARY KEY, failure TEXT) WITHOUT ROWID;"
      "CREATE TABLE IF NOT EXISTS notices(run TEXT, position INTEGER, code TEXT, severity TEXT,"
      " text TEXT, PRIMARY KEY(run, position)) WITHOUT ROWID;"
      "CREATE TABLE IF NOT EXISTS told(run TEXT, replicate INTEGER, outcome INTEGER, value REAL,"
      " PRIMARY KEY(run, replicate, outcome)) WITHOUT ROWID");
}

std::string TrialStore::name_of(RunHash run) const {
  return hash_text(run) + hash_text(fingerprint(measure_));
}

std::optional<Told> TrialStore::find(RunHash run) {
  const std::lock_guard lock(mutex_);
  if (!database_) return std::nullopt;
  const std::string name = name_of(run);
  Statement trial = database_->prepare("SELECT failure FROM trials WHERE run = ?");
  if (!trial.bind(1, name).step()) return std::nullopt;
  Told told;
  told.failure = trial.text(0);
  Statement values = database_->prepare(
      "SELECT replicate, value FROM told WHERE run = ? ORDER BY replicate, outcome");
  values.bind(1, name);
  while (values.step()) {
    const auto replicate = static_cast<std::size_t>(values.whole(0));
    if (told.replicates.size() <= replicate) told.replicates.resize(replicate + 1);
    told.replicates[replicate].push_back(values.number(1));
  }
  Statement notices = database_->prepare(
      "SELECT code, severity, text FROM notices WHERE run = ? ORDER BY position");
  notices.bind(1, name);
  while (notices.step())
    told.notices.push_back({notices.text(0), severity_of(notices.text(1)), notices.text(2)});
  return told;
}

void TrialStore::keep(RunHash run, const Told& told) {
  const std::lock_guard lock(mutex_);
  const bool opened = database_.has_value();
  try {
    if (!opened) open();
    write(run, told);
  } catch (const InputError& e) {
    if (!opened) database_.reset();  // it may lack its tables
    trouble_(e.faults().front());
  }
}

void TrialStore::write(RunHash run, const Told& told) {
  const std::string name = name_of(run);
  Transaction all(*database_);
  database_->prepare("INSERT OR REPLACE INTO trials VALUES(?, ?)")
      .bind(1, name)
      .bind(2, told.failure)
      .run();
  Statement value = database_->prepare("INSERT OR REPLACE INTO told VALUES(?, ?, ?, ?)");
  for (std::size_t r = 0; r < told.replicates.size(); ++r)
    for (std::size_t k = 0; k < told.replicates[r].size(); ++k)
      value.bind(1, name)
          .bind(2, static_cast<std::int64_t>(r))
          .bind(3, static_cast<std::int64_t>(k))
          .bind(4, told.replicates[r][k])
          .run();
  Statement notice = database_->prepare("INSERT OR REPLACE INTO notices VALUES(?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < told.notices.size(); ++i)
    notice.bind(1, name)
        .bind(2, static_cast<std::int64_t>(i))
        .bind(3, told.notices[i].code)
        .bind(4, mahlwerk::name_of(told.notices[i].severity))
        .bind(5, told.notices[i].text)
        .run();
  all.commit();
}

}  // namespace mahlwerk::campaign
