// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Status of a campaign, and merging of its shards.
#include "mahlwerk/campaign/sweep/shards.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/campaigns/slurm.hpp"
#include "mahlwerk/commands/campaigns/sweep_case.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/manifest.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;
using campaign::ShardProgress;
using campaign::ShardsProgress;

/// Says which runs failed, and why: the first of all stores.
void print_failures(const std::vector<fs::path>& stores) {
  constexpr std::size_t most = 20;
  std::size_t found = 0;
  for (const fs::path& file : stores) {
    const campaign::Store store(file, campaign::Store::Access::read);
    const std::vector<std::string> keys = store.keys();
    store.read({}, [&](const campaign::Point& point) {
      if (point.state != campaign::RunState::failed || ++found > most) return;
      std::string values;
      for (std::size_t k = 0; k < keys.size(); ++k)
        values += fmt::format("{}{} = {}", k > 0 ? ", " : "", keys[k], point.values[k]);
      to_stdout(fmt::format("\npoint {}: {}\n  {}\n", point.number, values, point.failure));
    });
  }
  if (found > most)
    fmt::print("\nand {} more: see the column `message` of the store\n", found - most);
}

void print_warnings(const campaign::Store& store) {
  const std::string warned = report::notice_lines(store.notices(), store.counts().points, "point");
  if (!warned.empty()) to_stdout("\n" + warned);
}

/// Whether the case of a campaign, or a file that it names, is no longer what Slurm was given.
bool changed_since_submission(const ShardsProgress& progress, const fs::path& place) {
  const std::string then = submitted_fingerprint(place);
  if (then.empty() || progress.case_file.empty()) return false;
  try {
    return campaign::campaign_fingerprint(swept_case(progress.case_file, progress.overrides)) !=
           then;
  } catch (const InputError&) {
    return true;
  }
}

std::string_view state_of_shard(const ShardProgress& shard) {
  return shard.store.empty()                              ? "not begun"
         : shard.at_work                                  ? "a process is running it"
         : shard.points > 0 && shard.done == shard.points ? "done"
         : shard.points > shard.done + shard.failed       ? "ended, with runs left"
                                                          : "ended";
}

std::vector<fs::path> stores_of(const ShardsProgress& progress) {
  std::vector<fs::path> stores;
  for (const ShardProgress& shard : progress.shards)
    if (shard.failed > 0 && !shard.store.empty()) stores.push_back(shard.store);
  return stores;
}

/// Says what each shard has done; of many, those that are not done.
void print_shards(const ShardsProgress& progress) {
  constexpr std::size_t few = 20;
  const auto ended = [](const ShardProgress& s) { return s.points > 0 && s.done == s.points; };
  to_stdout(fmt::format("\n  shards   {}, {} done\n", progress.shards.size(),
                        std::ranges::count_if(progress.shards, ended)));
  std::size_t printed = 0;
  for (const ShardProgress& shard : progress.shards) {
    if (progress.shards.size() > few && (ended(shard) || ++printed > few)) continue;
    to_stdout(fmt::format(
        "  {:>7}  {} of {} points done{}: {}\n",
        fmt::format("{}/{}", shard.shard.number, shard.shard.of), shard.done, shard.points,
        shard.failed > 0 ? fmt::format(", {} failed", shard.failed) : "", state_of_shard(shard)));
  }
  if (printed > few) to_stdout(fmt::format("  and {} more\n", printed - few));
}

std::string next_step(const ShardsProgress& progress, const fs::path& place) {
  const std::string merge = "mahlwerk sweep merge " + shell_word(place.string());
  if (progress.points == 0)
    return "no runs are planned yet: a process is reading the case, or was ended while reading it";
  if (progress.complete())
    return fs::exists(place / "campaign.sqlite") ? "all runs have ended"
                                                 : fmt::format("all runs have ended: `{}`", merge);
  if (std::ranges::any_of(progress.shards, &ShardProgress::at_work))
    return "processes are running it";
  return fmt::format(
      "no process is running it; {} resumes it, `{}` collects what is there",
      fs::exists(place / "campaign.slurm")
          ? fmt::format("`sbatch {}`", shell_word((place / "campaign.slurm").string()))
          : std::string("`mahlwerk sweep` with its case and --shard"),
      merge);
}

results::Json as_json(const ShardProgress& shard) {
  return results::Json::object({{"shard", shard.shard.number},
                                {"of", shard.shard.of},
                                {"points", shard.points},
                                {"done", shard.done},
                                {"failed", shard.failed},
                                {"begun", !shard.store.empty()},
                                {"at_work", shard.at_work}});
}

int status_of_shards(const Running& running, const ShardsProgress& progress,
                     const fs::path& place) {
  const fs::path merged = place / "campaign.sqlite";
  const bool is_merged = fs::exists(merged), changed = changed_since_submission(progress, place);
  const std::size_t waiting = progress.points - progress.done - progress.failed;
  if (running.json) {
    results::Json shards = results::Json::array();
    for (const ShardProgress& shard : progress.shards) shards.push_back(as_json(shard));
    results::Json said = results::Json::object({{"results", place.string()},
                                                {"points", progress.points},
                                                {"done", progress.done},
                                                {"failed", progress.failed},
                                                {"waiting", waiting},
                                                {"merged", is_merged},
                                                {"case_changed", changed},
                                                {"shards", std::move(shards)}});
    if (is_merged) said["notices"] = results::notices_json(campaign::open_store(place).notices());
    json_to_stdout(said);
    return success;
  }
  title_to_stdout(progress.title);
  to_stdout(fmt::format("\n  points   {}\n  done     {}\n  failed   {}\n  waiting  {}\n",
                        progress.points, progress.done, progress.failed, waiting));
  print_shards(progress);
  to_stdout(fmt::format("\n{}\n", next_step(progress, place)));
  if (changed)
    to_stdout(fmt::format(
        "\nWarning: {} or a file that it names has changed since it was submitted; its shards "
        "refuse it. Submit it again with --slurm, or restore the file.\n",
        progress.case_file.string()));
  if (is_merged) print_warnings(campaign::open_store(place));
  print_failures(is_merged ? std::vector{merged} : stores_of(progress));
  return success;
}

}  // namespace

int campaign_status(const Running& running, const fs::path& place) {
  if (const auto shards = campaign::shards_progress(place))
    return status_of_shards(running, *shards, place);
  const campaign::Store store = campaign::open_store(place);
  const campaign::RunCounts counts = store.counts();
  if (running.json) {
    print_campaign(store, place, nullptr);
    return success;
  }
  const bool at_work = campaign::CampaignLock::held(place / "campaign.lock");
  title_to_stdout(store.title());
  to_stdout(fmt::format(
      "\n  points   {}\n  done     {}\n  failed   {}\n  waiting  {}\n\n{}\n", counts.points,
      counts.done, counts.failed, counts.waiting,
      counts.points == 0
          ? "no runs are planned yet: a process is reading the case, or was ended while reading it"
      : at_work            ? "a process is running it"
      : counts.waiting > 0 ? "no process is running it; `mahlwerk sweep` with its case resumes it"
                           : "all runs have ended"));
  print_warnings(store);
  print_failures({place / "campaign.sqlite"});
  return success;
}

int merge_shards(const Running& running, const fs::path& place) {
  const std::vector<fs::path> shards = campaign::shard_stores(place);
  if (shards.empty())
    throw InputError(Fault{place.string(), "the folder holds no shards of a campaign",
                           "name the folder that `mahlwerk sweep --shard` was given as --out",
                           "no-campaign"});
  const campaign::CampaignLock lock(place / "campaign.lock", campaign::CampaignLock::Mode::shared);
  results::list_files(place, {merge_lock});
  const campaign::CampaignLock alone(place / merge_lock);
  campaign::Store store(place / "campaign.sqlite", campaign::Store::Access::write);
  std::size_t taken = 0;
  for (const fs::path& shard : shards) taken += store.merge(shard);
  const campaign::RunCounts counts = store.counts();
  const campaign::Campaign campaign = campaign::campaign_of(store, catalogue());
  write_pages(store, campaign, place);
  if (running.json) {
    print_campaign(store, place, nullptr);
  } else if (!running.quiet) {
    to_stdout(fmt::format(
        "{}\n\n{}{} merged from {}: {} of {} done, {} failed, {} waiting\nreport:   {}\n",
        campaign.title, table_with_warnings(campaign), counted(taken, "run"),
        counted(shards.size(), "shard"), counts.done, counts.done + counts.failed + counts.waiting,
        counts.failed, counts.waiting, (place / "campaign.html").string()));
  }
  return counts.failed > 0 ? stopped_by_physics : success;
}

}  // namespace mahlwerk::commands
