// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// sweep: runs the campaign of a case with [sweep]; export and retry.
#include <fmt/format.h>

#include <cstdio>
#include <iostream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/campaigns/slurm.hpp"
#include "mahlwerk/commands/campaigns/sweep_case.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/report/notices.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

int sweep(const SweepArguments& given) {
  if (given.target.empty())
    throw InputError(Fault{"mahlwerk sweep", "no case is given",
                           "write mahlwerk sweep case.toml, or see mahlwerk sweep --help",
                           "no-such-case"});
  const std::vector<cases::Override> set = given.changes.overrides();
  const fs::path file = one_case_file(given.target, "sweep");
  const fs::path place = given.running.out.value_or(default_folder(given.target, file, false));
  if (given.shards > 0) {
    return submit_to_slurm(given, swept_case(file, set), file, place);
  }
  return sweep_case(given.running, given.part, file, set, place);
}

int sweep_export(const SweepArguments& given) {
  const campaign::Store store = campaign::open_store(given.target);
  if (const auto& file = given.running.out) {
    refuse_existing(*file, given.running.force);
    write_table(store, *file);
    return success;
  }
  store.write_csv(std::cout);
  std::cout.flush();
  return success;
}

int sweep_retry(const SweepArguments& given) {
  const fs::path place = given.target;
  fs::path file;
  std::vector<cases::Override> set;
  {
    const campaign::Store store = campaign::open_store(place);
    file = store.case_file();
    set = store.overrides();
    swept_case(file, set);  // throws if the case cannot be run, before any result is discarded
  }
  {
    const campaign::CampaignLock lock(place / "campaign.lock");
    campaign::Store store(place / "campaign.sqlite", campaign::Store::Access::write);
    const std::size_t again = store.retry();
    if (given.running.prints_text())
      fmt::print("{} will be tried again\n\n", counted(again, "run"));
  }
  return sweep_case(given.running, given.part, file, set, place);
}

Options sharing(SweepArguments& given) {
  return {{.name = "--results",
           .target = &given.part.results,
           .about = "what is kept of each run: all results (default up to 1000 points), or only "
                    "its summary in the store",
           .values = {"all", "summary"}},
          {"--films", &given.part.films,
           "keep the paths of the balls of each run in film.json, for pictures"},
          {"--shard", &given.part.shard,
           "run only this part of the campaign: 2/8 is the second of eight"},
          {.name = "--merge",
           .target = &given.part.merge,
           .about = "after the shard, merge all, if it was the last",
           .needs = "--shard"},
          {.name = "--case-fingerprint",
           .target = &given.part.fingerprint,
           .about = "refuse a case that has changed since this was written: for the scripts of "
                    "--slurm",
           .type = "FINGERPRINT",
           .needs = "--shard"},
          {.name = "--slurm",
           .target = &given.shards,
           .about = "submit the campaign to Slurm as this many shards, and a job that merges them",
           .type = "SHARDS",
           .range = {1, 10'000},
           .excludes = "--shard"},
          {.name = "--slurm-option",
           .target = &given.slurm_options,
           .about = "an option for sbatch: --slurm-option partition=long; may be repeated",
           .needs = "--slurm"}};
}

/// Those after `sweep`. They share its arguments: `sweep --json status FOLDER` is the same.
std::vector<Command> subcommands(const std::shared_ptr<SweepArguments>& given) {
  Running& running = given->running;
  const Option folder{.name = "FOLDER",
                      .target = &given->target,
                      .about = "the campaign's folder",
                      .required = true};
  return {{"status",
           "show the progress of a campaign and the runs that failed",
           {folder, json(running.json)},
           [given] { return campaign_status(given->running, given->target); }},
          {"export",
           "write the table of a campaign as CSV",
           {folder,
            {"--out", &running.out, "file to write (default: the terminal)"},
            {"--force", &running.force, "replace an existing file"}},
           [given] { return sweep_export(*given); }},
          {"retry",
           "run the failed runs again",
           {folder, threads(running.threads), quiet(running.quiet), json(running.json)},
           [given] { return sweep_retry(*given); }},
          {"merge",
           "merge the shards of a campaign",
           {folder, quiet(running.quiet), json(running.json)},
           [given] { return merge_shards(given->running, given->target); }}};
}

}  // namespace

Command sweep_command() {
  const auto given = std::make_shared<SweepArguments>();
  Option target = one_case(given->target);
  target.required = false;  // a subcommand may follow instead
  return {"sweep", "run or resume the campaign of a case with [sweep]",
          joined({{target},
                  options_of(given->changes),
                  options_of(given->running),
                  {checkpoint(given->part.checkpoint,
                              "seconds between two checkpoints of a run, from which the same "
                              "command resumes (default 60)")},
                  sharing(*given),
                  {json(given->running.json)}}),
          [given] { return sweep(*given); }, subcommands(given)};
}

}  // namespace mahlwerk::commands
