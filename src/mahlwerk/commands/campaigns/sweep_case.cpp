// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/campaigns/sweep_case.hpp"

#include <fmt/format.h>

#include <charconv>
#include <functional>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/forecast.hpp"
#include "mahlwerk/campaign/sweep/checked_points.hpp"
#include "mahlwerk/campaign/sweep/shards.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/report/film.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// Parses "2/8", the second of eight shards. Throws InputError.
campaign::Shard shard_of(const std::string& text) {
  campaign::Shard shard;
  if (text.empty()) return shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.number);
  const bool slash = first.ec == std::errc{} && first.ptr != end && *first.ptr == '/';
  const auto second = slash ? std::from_chars(first.ptr + 1, end, shard.of) : first;
  const bool sound = slash && second.ec == std::errc{} && second.ptr == end && shard.of >= 1 &&
                     shard.of <= 100'000 && shard.number >= 1 && shard.number <= shard.of;
  if (!sound)
    throw InputError(Fault{"--shard " + text, "this is not a shard i/n",
                           "write --shard 1/4 for the first of four", "bad-shard"});
  return shard;
}

/// Prints the summary of a finished campaign.
void print_summary(const campaign::CampaignFolder& folder, const campaign::RunCounts& counts,
                   const campaign::Campaign& campaign, const campaign::WorkSummary& worked) {
  title_to_stdout(campaign.title);
  to_stdout('\n' + table_with_warnings(campaign));
  const fs::path& place = folder.path();
  places_to_stdout({{"results", place},
                    {"report", place / "campaign.html"},
                    {"numbers", place / "campaign.csv"},
                    {"store", place / "campaign.sqlite"}});
  to_stdout("\n");
  if (worked.already_done > 0) fmt::print("{} already done\n", counted(worked.already_done, "run"));
  fmt::print("{} in {:.3g} s", counted(worked.done, "run"), worked.seconds);
  if (counts.failed > 0) fmt::print(", {} failed", counts.failed);
  fmt::print("\n");
}

int ending(const Running& running, const campaign::WorkSummary& worked,
           const campaign::RunCounts& counts, const fs::path& place) {
  if (worked.interrupted) {
    const std::string kept =
        fmt::format("{} of {} runs are done and kept; run the same command again to resume",
                    counts.done, counts.done + counts.failed + counts.waiting);
    return report_interrupted(running, kept);
  }
  if (counts.failed == 0) return success;
  const std::string
      failed = counted(counts.failed, "run") + " failed",
      word = shell_word(place.string()),
      remedy = fmt::format(
          "`mahlwerk sweep status {}` shows the reasons, `mahlwerk sweep retry {}` runs them again",
          word, word);
  if (running.prints_errors())
    report_end(stopped_by_physics, failed + ": " + remedy,
               {Fault{place.string(), failed, remedy, "runs-failed"}});
  return stopped_by_physics;
}

/// Refuses a case that is not the one that was submitted: its shards would be parts of another
/// campaign.
void refuse_changed_case(const CampaignPart& part, const cases::Case& mill_case) {
  if (part.fingerprint.empty() || part.fingerprint == campaign::campaign_fingerprint(mill_case))
    return;
  throw InputError(Fault{
      mill_case.file, "the case, or a file that it names, has changed since it was submitted",
      "submit it again (mahlwerk sweep CASE --slurm SHARDS), which keeps what still holds, or "
      "restore the file",
      "case-changed"});
}

/// Merges all shards if this was the last one. Where two end together, one of them does it.
void merge_after_last(const Running& running, const fs::path& place) {
  const auto progress = campaign::shards_progress(place);
  if (!progress || !progress->complete()) return;
  try {
    merge_shards(running, place);
  } catch (const InputError& e) {
    if (e.faults().front().code != "campaign-at-work") throw;
  }
}

/// Reports the end of a shard. Results are reported after all shards are merged.
int end_shard(const Running& running, campaign::CampaignFolder& folder,
              const campaign::Shard& shard, const campaign::WorkSummary& worked) {
  const campaign::RunCounts counts = folder.store().counts();
  if (running.prints_text())
    to_stdout(
        fmt::format("shard {}/{}: {} done, {} failed, {} before, in {:.3g} s\nmerge all shards:  "
                    "mahlwerk sweep merge {}\n",
                    shard.number, shard.of, worked.done, worked.failed, worked.already_done,
                    worked.seconds, shell_word(folder.path().string())));
  if (running.json) print_campaign(folder.store(), folder.path(), &worked);
  return worked.interrupted ? interrupted : counts.failed > 0 ? stopped_by_physics : success;
}

campaign::CampaignSettings settings_of(const Running& running, const CampaignPart& part,
                                       std::optional<ProgressLine>& line,
                                       WriteErrorReporter& not_kept) {
  const auto write = [films = part.films](const results::Folder& folder,
                                          const results::Outcome& outcome) {
    report::write(folder, outcome, version(), "", false);
    if (films) folder.write("film.json", report::film_json(outcome));
  };
  const auto show = [&](const campaign::WorkProgress& p) {
    line->show(fmt::format("{:3.0f} %  {} of {} runs done{}  {}", 100 * p.share, p.done, p.of,
                           p.failed > 0 ? fmt::format(", {} failed", p.failed) : "",
                           line->left(p.share)));
  };
  std::optional<bool> folders;
  if (!part.results.empty()) folders = part.results == "all";
  return {.version = std::string(version()),
          .catalogue = catalogue(),
          .threads = running.threads,
          .force = running.force,
          .folders = folders,
          .checkpoint_every = part.checkpoint.value_or(60),
          .films = part.films,
          .stop = &stop_wanted(),
          .write = write,
          .progress = show,
          .on_write_error = std::ref(not_kept)};
}

}  // namespace

cases::Case swept_case(const fs::path& file, const std::vector<cases::Override>& set) {
  cases::Case mill_case = cases::read(file, catalogue(), set);
  if (mill_case.sweep.empty())
    throw InputError(Fault{file.generic_string(), "the case has no [sweep]: no key varies",
                           "add, for instance, [sweep] and \"mill.speed\" = [\"300 rpm\", \"400 "
                           "rpm\"] below it, or use `mahlwerk run`",
                           "no-sweep"});
  return mill_case;
}

std::string counted(std::size_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

void print_campaign(const campaign::Store& store, const fs::path& place,
                    const campaign::WorkSummary* worked) {
  const campaign::RunCounts counts = store.counts();
  results::Json said = results::Json::object({{"results", place.string()},
                                              {"points", counts.points},
                                              {"done", counts.done},
                                              {"failed", counts.failed},
                                              {"waiting", counts.waiting},
                                              {"notices", results::notices_json(store.notices())}});
  if (worked != nullptr) said["seconds"] = worked->seconds;
  json_to_stdout(said);
}

std::string table_with_warnings(const campaign::Campaign& campaign) {
  const std::string warned =
      report::notice_lines(campaign.notices, campaign.points.size(), "point");
  return report::campaign_table(campaign) + '\n' + warned + (warned.empty() ? "" : "\n");
}

int sweep_case(const Running& running, const CampaignPart& part, const fs::path& file,
               const std::vector<cases::Override>& set, const fs::path& place) {
  const campaign::Shard shard = shard_of(part.shard);
  if (!shard.whole() && running.force)
    throw InputError(Fault{"--force",
                           "a shard cannot replace a folder that other shards may be using",
                           "remove the folder before the first shard starts", "bad-shard"});
  const cases::Case mill_case = swept_case(file, set);
  refuse_changed_case(part, mill_case);
  if (mill_case.observe.collisions || mill_case.observe.frames)
    campaign::check_disk(campaign::CheckedPoints(mill_case, file, catalogue(), set).good(), place);
  catch_ctrl_c();
  std::optional<ProgressLine> line;
  WriteErrorReporter not_kept;
  std::optional<campaign::CampaignFolder> opened;
  campaign::CampaignFolder& folder =
      opened.emplace(settings_of(running, part, line, not_kept), file, set, place, shard);
  folder.plan(campaign::Plan(mill_case.sweep, mill_case.seed));
  if (stop_wanted()) return report_interrupted(running, "no run has started");
  line.emplace(running.quiet);
  const campaign::WorkSummary worked = folder.work();
  not_kept.repeat();
  line.reset();  // clears the line on the terminal
  if (!shard.whole()) {
    const int code = end_shard(running, folder, shard, worked);
    opened.reset();
    if (part.merge && !worked.interrupted) merge_after_last(running, place);
    return code;
  }
  const campaign::RunCounts counts = folder.store().counts();
  if (!fs::exists(place / "campaign.sqlite"))
    throw InputError(Fault{place.string(), "the folder was removed while the campaign ran",
                           "start it again", "cannot-write"});
  const campaign::Campaign campaign = campaign::campaign_of(folder.store(), catalogue());
  write_pages(folder.store(), campaign, place);
  if (running.json) print_campaign(folder.store(), place, &worked);
  if (running.prints_text()) print_summary(folder, counts, campaign, worked);
  return ending(running, worked, counts, place);
}

}  // namespace mahlwerk::commands
