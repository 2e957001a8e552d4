// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// sweep: the campaign of a case with [sweep]; how far it is, as a table, what failed, its shards.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <iostream>

#include "command.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/report/notices.hpp"
#include "output.hpp"
#include "slurm.hpp"
#include "sweep_case.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

int sweep(const Request& request) {
  const fs::path file = one_case_file(request.target, "sweep");
  const fs::path place = request.out ? *request.out : default_folder(request.target, file, false);
  if (request.slurm > 0) {
    swept_case(file, overrides(request));  // its faults are told here, not in the queue
    return submit_to_slurm(request, file, place);
  }
  return sweep_case(request, file, overrides(request), place);
}

int sweep_status(const Request& request) {
  const fs::path place = request.target;
  const campaign::Store store = campaign::open_store(place);
  const campaign::RunCounts counts = store.counts();
  if (request.json) {
    print_campaign(store, place, nullptr);
    return success;
  }
  const bool at_work = campaign::CampaignLock::held(place / "campaign.lock");
  to_stdout(fmt::format(
      "{}\n\n  points   {}\n  done     {}\n  failed   {}\n  waiting  {}\n\n{}\n", store.title(),
      counts.points, counts.done, counts.failed, counts.waiting,
      counts.points == 0
          ? "nothing is planned yet: a process reads its case, or was ended while it did"
      : at_work            ? "a process is at work on it"
      : counts.waiting > 0 ? "nobody is at work on it; `mahlwerk sweep` with its case goes on"
                           : "all has been run"));
  if (const std::string warned = report::notice_lines(store.notices(), counts.points, "point");
      !warned.empty())
    to_stdout("\n" + warned);
  constexpr std::size_t most = 20;
  std::size_t told_of = 0;
  const std::vector<std::string> keys = store.keys();
  store.read({}, [&](const campaign::StoredPoint& point) {
    if (point.state != campaign::RunState::failed || ++told_of > most) return;
    std::string values;
    for (std::size_t k = 0; k < keys.size(); ++k)
      values += fmt::format("{}{} = {}", k > 0 ? ", " : "", keys[k], point.values[k]);
    to_stdout(fmt::format("\npoint {}: {}\n  {}\n", point.number, values, point.message));
  });
  if (told_of > most)
    fmt::print("\nand {} more: the column `message` of the store\n", told_of - most);
  return success;
}

int sweep_export(const Request& request) {
  const fs::path place = request.target;
  const campaign::Store store = campaign::open_store(place);
  if (request.out) {
    if (fs::exists(*request.out) && !request.force)
      throw InputError(Fault{request.out->string(), "there is such a file already",
                             "give another name, or replace it with --force", "result-exists"});
    std::ofstream out(*request.out, std::ios::binary);
    store.write_csv(out);
    out.close();
    if (!out)
      throw InputError(Fault{request.out->string(), "cannot be written",
                             "check the folder, your rights and the space on the disk",
                             "cannot-write"});
    return success;
  }
  store.write_csv(std::cout);
  std::cout.flush();
  return success;
}

int sweep_retry(const Request& request) {
  const fs::path place = request.target;
  fs::path file;
  std::vector<cases::Override> set;
  {
    const campaign::Store store = campaign::open_store(place);
    file = store.case_file();
    set = store.overrides();
    swept_case(file, set);  // that it can be run, before anything is forgotten
  }
  {
    const campaign::CampaignLock lock(place / "campaign.lock");
    campaign::Store store(place / "campaign.sqlite", campaign::Store::Access::write);
    const std::size_t again = store.retry();
    if (!request.quiet && !request.json)
      fmt::print("{} to be tried again\n\n", counted(again, "run"));
  }
  return sweep_case(request, file, set, place);
}

int sweep_merge(const Request& request) {
  const fs::path place = request.target;
  std::vector<fs::path> shards;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(place, failed))
    if (entry.path().filename().string().starts_with("campaign.shard-") &&
        entry.path().extension() == ".sqlite")
      shards.push_back(entry.path());
  if (shards.empty())
    throw InputError(Fault{place.string(), "the folder holds no shards of a campaign",
                           "name the folder that was given to `mahlwerk sweep --shard` as --out",
                           "no-campaign"});
  std::ranges::sort(shards);
  const campaign::CampaignLock lock(place / "campaign.lock", campaign::CampaignLock::Mode::shared);
  campaign::Store store(place / "campaign.sqlite", campaign::Store::Access::write);
  std::size_t taken = 0;
  for (const fs::path& shard : shards) taken += store.merge(shard);
  const campaign::RunCounts counts = store.counts();
  const report::Campaign campaign = campaign_of(store);
  write_pages(store, campaign, place);
  if (request.json) {
    print_campaign(store, place, nullptr);
  } else if (!request.quiet) {
    to_stdout(fmt::format(
        "{}\n\n{}{} taken from {}: {} of {} done, {} failed, {} waiting\nreport:   {}\n",
        campaign.title, table_with_warnings(campaign), counted(taken, "run"),
        counted(shards.size(), "shard"), counts.done, counts.done + counts.failed + counts.waiting,
        counts.failed, counts.waiting, (place / "campaign.html").string()));
  }
  return counts.failed > 0 ? stopped_by_physics : success;
}

Options sharing() {
  return {{.name = "--results",
           .target = &Request::results,
           .about = "what is kept of each run: all (default up to 1000 points), or its summary in "
                    "the store alone",
           .values = {"all", "summary"}},
          {"--shard", &Request::shard, "do only this part of the runs: 2/8 is the second of eight"},
          {.name = "--slurm",
           .target = &Request::slurm,
           .about = "submit the campaign to Slurm as so many shards, and their merge",
           .type = "SHARDS",
           .range = {1, 10'000},
           .excludes = "--shard"},
          {.name = "--slurm-option",
           .target = &Request::slurm_options,
           .about = "a line for sbatch: --slurm-option partition=long; may be repeated",
           .needs = "--slurm"}};
}

std::vector<Command> subcommands() {
  const Option folder{.name = "FOLDER",
                      .target = &Request::target,
                      .about = "the campaign's folder",
                      .required = true};
  return {{"status", "how far a campaign is, and what failed", {folder, json()}, sweep_status},
          {"export",
           "the table of a campaign as CSV",
           {folder,
            {"--out", &Request::out, "file to write (default: the terminal)"},
            {"--force", &Request::force, "replace the file if it is there"}},
           sweep_export},
          {"retry", "run what failed once more", {folder, threads(), quiet(), json()}, sweep_retry},
          {"merge", "join the shards of a campaign", {folder, quiet(), json()}, sweep_merge}};
}

}  // namespace

Command sweep_command() {
  Option target = one_case();
  target.required = false;  // a part may be meant
  return {"sweep", "run the campaign of a case with [sweep], or go on with it",
          joined({{target}, changes(), running(), sharing(), {json()}}), sweep, subcommands()};
}

}  // namespace mahlwerk::app
