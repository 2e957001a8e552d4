// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/trial_store.hpp"

#include <fmt/format.h>

#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"

namespace mahlwerk::campaign {

namespace {

InputError damaged(const std::filesystem::path& file) {
  return InputError(Fault{file.generic_string(),
                          "the store of this search is damaged: outcomes of a setting are missing",
                          "remove it: the search begins again", "store"});
}

}  // namespace

TrialStore::TrialStore(const std::filesystem::path& file, std::string measure,
                       std::function<void(const Fault&)> on_write_error)
    : file_(file), measure_(std::move(measure)), on_write_error_(std::move(on_write_error)) {
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

std::optional<TrialResult> TrialStore::find(RunHash run) {
  const std::lock_guard lock(mutex_);
  if (!database_) return std::nullopt;
  try {
    return read(run);
  } catch (const InputError& e) {  // after a failed write: the trial is run again
    on_write_error_(e.faults().front());
    return std::nullopt;
  }
}

std::optional<TrialResult> TrialStore::read(RunHash run) const {
  const std::string name = name_of(run);
  Statement trial = database_->prepare("SELECT failure FROM trials WHERE run = ?");
  if (!trial.bind(1, name).step()) return std::nullopt;
  TrialResult result;
  result.failure = trial.text(0);
  Statement values = database_->prepare(
      "SELECT replicate, outcome, value FROM told WHERE run = ? ORDER BY replicate, outcome");
  values.bind(1, name);
  std::vector<std::vector<double>>& told = result.replicates;
  while (values.step()) {
    if (values.integer(0) == std::ssize(told)) told.emplace_back();
    if (told.empty() || values.integer(0) != std::ssize(told) - 1 ||
        values.integer(1) != std::ssize(told.back()))
      throw damaged(file_);
    told.back().push_back(values.number(2));
  }
  for (const std::vector<double>& one : told)
    if (one.size() != told.front().size()) throw damaged(file_);
  Statement notices = database_->prepare(
      "SELECT code, severity, text FROM notices WHERE run = ? ORDER BY position");
  notices.bind(1, name);
  while (notices.step())
    result.notices.push_back({notices.text(0), severity_of(notices.text(1)), notices.text(2)});
  return result;
}

void TrialStore::keep(RunHash run, const TrialResult& result) {
  const std::lock_guard lock(mutex_);
  const bool opened = database_.has_value();
  try {
    if (!opened) open();
    write(run, result);
  } catch (const InputError& e) {
    if (!opened) database_.reset();  // its tables may be missing
    on_write_error_(e.faults().front());
  }
}

void TrialStore::write(RunHash run, const TrialResult& result) {
  const std::string name = name_of(run);
  Transaction all(*database_);
  database_->prepare("INSERT OR REPLACE INTO trials VALUES(?, ?)")
      .bind(1, name)
      .bind(2, result.failure)
      .run();
  Statement value = database_->prepare("INSERT OR REPLACE INTO told VALUES(?, ?, ?, ?)");
  for (std::size_t r = 0; r < result.replicates.size(); ++r)
    for (std::size_t k = 0; k < result.replicates[r].size(); ++k)
      value.bind(1, name)
          .bind(2, static_cast<std::int64_t>(r))
          .bind(3, static_cast<std::int64_t>(k))
          .bind(4, result.replicates[r][k])
          .run();
  Statement notice = database_->prepare("INSERT OR REPLACE INTO notices VALUES(?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < result.notices.size(); ++i)
    notice.bind(1, name)
        .bind(2, static_cast<std::int64_t>(i))
        .bind(3, result.notices[i].code)
        .bind(4, mahlwerk::name_of(result.notices[i].severity))
        .bind(5, result.notices[i].text)
        .run();
  all.commit();
}

}  // namespace mahlwerk::campaign
