// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <iterator>
#include <unordered_set>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/campaign/run/parallel.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/sweep/work.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_folders = 1000;  // of results; larger campaigns keep only the store

std::string name_of(const Shard& shard) {
  return shard.whole() ? "campaign"
                       : fmt::format("campaign.shard-{}-of-{}", shard.number, shard.of);
}

bool holds_campaign(const fs::path& place) {
  if (fs::exists(place / "campaign.sqlite")) return true;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(place, none))
    if (const std::string name = entry.path().filename().string();
        name.starts_with("campaign.shard-") || name == "campaign.slurm" || name == "campaign.lock")
      return true;
  return false;
}

bool is_free(const fs::path& place) {
  std::error_code none;
  return !fs::exists(place, none) || fs::is_empty(place, none);
}

void refuse_foreign_folder(const fs::path& place, bool force) {
  if (!is_free(place) && !holds_campaign(place)) const results::Folder tried(place, force);
}

/// Path of the lock file. The folder belongs to a campaign, or becomes that of one here.
fs::path opened(const fs::path& place, const Shard& shard, bool force) {
  const fs::path lock = place / (name_of(shard) + ".lock");
  if (is_free(place)) {
    results::make_folder(place);
  } else if (!holds_campaign(place) || force) {
    if (fs::exists(lock)) const CampaignLock last(lock);
    results::Folder fresh(place, force);
    fresh.write(lock.filename().string(), "");
    fresh.commit();
  }
  return lock;
}

}  // namespace

void prepare_folder(const fs::path& place) {
  refuse_foreign_folder(place, false);
  results::make_folder(place);
}

CampaignFolder::CampaignFolder(CampaignSettings settings, const fs::path& case_file,
                               std::vector<cases::Override> set, fs::path place, const Shard& shard)
    : settings_(std::move(settings)),
      file_(case_file),
      set_(std::move(set)),
      path_(std::move(place)),
      case_file_(fs::weakly_canonical(case_file)),
      shard_(shard) {
  refuse_foreign_folder(path_, settings_.force);
}

/// Called once the case is known to be valid; nothing is written before.
void CampaignFolder::open() {
  const fs::path own = opened(path_, shard_, settings_.force);
  own_lock_.emplace(own);
  if (!shard_.whole()) lock_.emplace(path_ / "campaign.lock", CampaignLock::Mode::shared);
  const std::string name = name_of(shard_);
  results::list_campaign_files(path_);
  results::list_files(path_, {"campaign.lock", name + ".lock", name + ".sqlite"});
  store_.emplace(path_ / (name + ".sqlite"),
                 shard_.whole() ? Store::Access::write : Store::Access::shard);
  refuse_other_case();
  remove_leftovers();
}

/// Two case files of one name would share a folder. A case file that was moved is the same.
void CampaignFolder::refuse_other_case() const {
  const fs::path last = store_->case_file();
  std::error_code none;
  if (last.empty() || last == case_file_ || !fs::exists(last, none) ||
      fs::equivalent(last, case_file_, none))
    return;
  throw InputError(Fault{path_.string(), "the folder holds the campaign of " + last.string(),
                         "give another folder with --out, or replace it with --force",
                         "other-campaign"});
}

/// Removes partial files of killed runs of this shard, and partial pages.
void CampaignFolder::remove_leftovers() const {
  std::error_code none;
  std::vector<fs::path> remains;
  const auto listed = results::listed_files(path_);
  for (const auto& entry : fs::directory_iterator(path_ / results::campaign_runs, none)) {
    const std::string name = entry.path().filename().string();
    std::size_t point = 0;
    const bool hidden = name.starts_with('.');
    std::from_chars(name.data() + (hidden ? 1 : 0), name.data() + name.size(), point);
    const bool mine = point > 0 && (point - 1) % shard_.of == shard_.number - 1;
    if (mine && (hidden || entry.path().extension() == ".part")) remains.push_back(entry.path());
  }
  if (shard_.whole() && listed)
    for (const std::string& name : *listed) remains.push_back(path_ / (name + ".part"));
  for (const fs::path& one : remains) fs::remove_all(one, none);
}

std::vector<cases::Override> CampaignFolder::settings(std::size_t point) const {
  std::vector<cases::Override> all = set_;
  std::ranges::move(plan_->overrides(point), std::back_inserter(all));
  return all;
}

CampaignFolder::Run CampaignFolder::read_run(std::size_t point) const {
  const cases::Case mill_case = file_.read(settings_.catalogue, settings(point));
  return {run_hash(mill_case, settings_.version), work_estimate(mill_case),
          cases::simulated_time(mill_case) * static_cast<double>(mill_case.run.replicates)};
}

void CampaignFolder::plan(Plan plan) {
  plan_ = std::move(plan);
  const cases::Case base = file_.read(settings_.catalogue, set_);
  runs_.assign(plan_->size(), {});
  std::optional<InputError> first;  // of the first point
  std::atomic<std::size_t> faulty = 0;
  in_parallel(thread_count(settings_.threads), runs_.size(), [&](std::size_t i) {
    if (stopped()) return;
    try {
      runs_[i] = read_run(i);
    } catch (const InputError& e) {
      std::string text(settings_.version);
      for (const cases::Override& one : settings(i))
        text +=
            one.unset ? fmt::format("\n-{}", one.key) : fmt::format("\n{}={}", one.key, one.value);
      runs_[i].hash = fingerprint(text);
      ++faulty;
      if (i == 0) first = e;
    }
  });
  if (stopped()) return;
  if (faulty == runs_.size() && first) throw *first;
  open();
  CampaignPlan planned;
  planned.title = base.title;
  planned.version = settings_.version;
  planned.case_file = case_file_;
  planned.overrides = set_;
  planned.keys = plan_->keys();
  planned.following_keys = plan_->following_keys();
  for (const Run& run : runs_) planned.runs.push_back(run.hash);
  planned.values = [&, own = base_values(*plan_, base)](std::size_t i) {
    return point_values(*plan_, i, own);
  };
  store_->plan(planned);
}

/// Points whose runs wait, the longest first so that all threads end at about the same time. Runs
/// that another shard or the whole campaign has done are left out.
std::vector<std::size_t> CampaignFolder::waiting_runs(WorkSummary& worked) const {
  auto states = store_->states();
  for (const auto& entry : fs::directory_iterator(path_)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("campaign") || entry.path().extension() != ".sqlite") continue;
    if (entry.path() == path_ / (name_of(shard_) + ".sqlite")) continue;
    try {
      for (const auto& [hash, state] : Store(entry.path(), Store::Access::read).states())
        if (state == RunState::done) states[hash] = state;
    } catch (const InputError&) {
      // The store of another shard is being made or cannot be read: it counts as empty.
    }
  }
  for (const RunHash hash : store_->without_folder(path_))
    states[hash] = RunState::waiting;  // its results were deleted
  std::vector<std::size_t> points;
  std::unordered_set<RunHash> met;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (i % shard_.of != shard_.number - 1 || !met.insert(runs_[i].hash).second) continue;
    if (states.at(runs_[i].hash) == RunState::waiting)
      points.push_back(i);
    else
      ++worked.already_done;
  }
  std::ranges::stable_sort(points, std::greater(), [&](std::size_t i) { return runs_[i].work; });
  return points;
}

bool CampaignFolder::keeps_folders() const {
  return settings_.folders.value_or(runs_.size() <= max_folders);
}

Store open_store(const fs::path& place) {
  const fs::path file = place / "campaign.sqlite";
  std::error_code none;
  if (!fs::exists(file, none))
    throw InputError(Fault{place.string(), "the folder holds no campaign",
                           "name the folder that `mahlwerk sweep` made; if it holds shards, merge "
                           "them first: mahlwerk sweep merge FOLDER",
                           "no-campaign"});
  return {file, Store::Access::read};
}

}  // namespace mahlwerk::campaign
