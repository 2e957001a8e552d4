// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/shards.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <unordered_map>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/cases/write.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view shard_name = "campaign.shard-";

/// The shard of a store's name, "campaign.shard-2-of-8.sqlite".
std::optional<Shard> shard_of_name(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(shard_name) || file.extension() != ".sqlite") return std::nullopt;
  Shard shard;
  const char* const end = name.data() + name.size();
  const auto number = std::from_chars(name.data() + shard_name.size(), end, shard.number);
  constexpr std::string_view between = "-of-";
  const auto rest = [&](const char* from) {
    return std::string_view(from, static_cast<std::size_t>(end - from));
  };
  if (number.ec != std::errc{} || !rest(number.ptr).starts_with(between)) return std::nullopt;
  const auto of = std::from_chars(number.ptr + between.size(), end, shard.of);
  if (of.ec != std::errc{} || rest(of.ptr) != ".sqlite" || shard.number < 1 ||
      shard.number > shard.of)
    return std::nullopt;
  return shard;
}

/// What the stores of a folder tell together.
class Stores {
 public:
  void add(const fs::path& file) try {
    const Store store(file, Store::Access::read);
    for (const auto& [run, state] : store.states()) {
      RunState& known = states_.try_emplace(run, RunState::waiting).first->second;
      if (known == RunState::waiting || state == RunState::done) known = state;
    }
    if (std::string planned = store.planned(); planned > planned_) {
      planned_ = std::move(planned);
      runs_ = store.runs();
      progress_.title = store.title();
      progress_.case_file = store.case_file();
      progress_.overrides = store.overrides();
    }
  } catch (const InputError&) {
    // The store is being made, or is damaged: `merge` says so.
  }

  ShardsProgress progress(std::map<std::size_t, ShardProgress> shards) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto found = states_.find(runs_[i]);
      const RunState state = found == states_.end() ? RunState::waiting : found->second;
      count(progress_, state);
      if (!shards.empty()) count(shards.at(1 + i % shards.size()), state);
    }
    for (auto& [number, shard] : shards) progress_.shards.push_back(std::move(shard));
    return std::move(progress_);
  }

 private:
  template <class Counts>
  static void count(Counts& counts, RunState state) {
    ++counts.points;
    counts.done += state == RunState::done;
    counts.failed += state == RunState::failed;
  }

  std::unordered_map<RunHash, RunState> states_;
  std::vector<RunHash> runs_;  // of the latest plan
  std::string planned_;
  ShardsProgress progress_;
};

}  // namespace

std::vector<fs::path> shard_stores(const fs::path& place) {
  std::vector<fs::path> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(place, none))
    if (shard_of_name(entry.path())) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

/// Of several divisions of one campaign, the one that was worked on last.
std::optional<ShardsProgress> shards_progress(const fs::path& place) {
  const std::vector<fs::path> files = shard_stores(place);
  if (files.empty()) return std::nullopt;
  std::error_code none;
  const fs::path last = *std::ranges::max_element(
      files, {}, [&](const fs::path& file) { return fs::last_write_time(file, none); });
  std::map<std::size_t, ShardProgress> shards;
  const std::size_t of = shard_of_name(last)->of;
  for (std::size_t number = 1; number <= of; ++number)
    shards[number].shard = {.number = number, .of = of};
  Stores stores;
  for (const fs::path& file : files) {
    stores.add(file);
    if (const Shard shard = *shard_of_name(file); shard.of == of) {
      shards.at(shard.number).store = file;
      shards.at(shard.number).at_work =
          CampaignLock::held(fs::path(file).replace_extension(".lock"));
    }
  }
  if (fs::exists(place / "campaign.sqlite", none)) stores.add(place / "campaign.sqlite");
  return stores.progress(std::move(shards));
}

std::string campaign_fingerprint(const cases::Case& mill_case) {
  cases::Case bare = mill_case;
  bare.origins.clear();
  return hash_text(fingerprint(cases::write(bare) + cases::input_files_fingerprint(mill_case)));
}

}  // namespace mahlwerk::campaign
