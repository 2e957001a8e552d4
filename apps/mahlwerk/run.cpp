// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run: one case, a sweep, or every case of a folder, to result folders.
#include "mahlwerk/campaign/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/plan.hpp"
#include "mahlwerk/campaign/soft_settings.hpp"
#include "mahlwerk/report/campaign.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/folder.hpp"
#include "mahlwerk/results/regime.hpp"
#include "mahlwerk/results/warnings.hpp"
#include "progress.hpp"
#include "streams.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// A case file with everything it takes to run it: its points, and where they go.
struct Job {
  cases::Case what;
  std::vector<cases::Case> points;  ///< one unless the case sweeps
  std::unique_ptr<results::Folder> folder;

  bool sweeps() const { return !what.sweep.empty(); }
  std::string below(std::size_t point) const {
    return sweeps() ? fmt::format("point-{:03}/", point + 1) : "";
  }
};

Job prepare(const Request& request, const fs::path& file, bool several,
            const cases::Catalogue& catalogue) {
  const std::vector<cases::Override> set = overrides(request);
  Job job;
  job.what = cases::read(file, catalogue, set);
  job.points = campaign::points(job.what, catalogue, set);
  for (const cases::Case& point : job.points)
    if (std::vector<Fault> wrong = campaign::run_faults(point); !wrong.empty())
      throw InputError(std::move(wrong));
  const fs::path place = !request.out ? default_place(request.target, file, several)
                         : several    ? *request.out / file.stem()
                                      : *request.out;
  job.folder = std::make_unique<results::Folder>(place, request.force || request.resume);
  return job;
}

report::Campaign campaign_of(const Job& job, const std::vector<results::Outcome>& outcomes) {
  const campaign::Plan plan(job.what.sweep, job.what.seed);
  report::Campaign made{.title = job.what.title};
  for (const results::Outcome& outcome : outcomes) {
    const std::size_t i = made.points.size();
    report::add(made,
                {.number = i + 1,
                 .values = plan.values(i),
                 .regime = results::regime(outcome),
                 .folder = job.below(i)},
                results::summarise(outcome));
  }
  made.swept = report::swept(plan.keys(), made.points);
  for (const std::vector<std::string>& list : job.what.sweep.together)
    for (report::Swept& key : made.swept)
      key.follows = key.follows || std::find(list.begin() + 1, list.end(), key.key) != list.end();
  return made;
}

void write(const Job& job, const std::vector<results::Outcome>& outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    report::write(*job.folder, outcomes[i], version(), job.below(i), !job.sweeps());
  if (job.sweeps()) {
    const report::Campaign campaign = campaign_of(job, outcomes);
    job.folder->write("campaign.csv", report::campaign_csv(campaign));
    job.folder->write("campaign.html", report::campaign_page(campaign, version()));
    for (const auto& [name, picture] : report::campaign_figures(campaign))
      job.folder->write(name, picture);
  }
  job.folder->commit();
}

/// The defaults nobody has calibrated, in a line; empty if the case rests on none.
std::string uncalibrated(const cases::Case& what) {
  std::string line;
  for (const cases::Origin& origin : what.origins)
    if (origin.assumed && origin.source.find("uncalibrated") != std::string::npos)
      line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", origin.key, origin.value);
  return line.empty() ? "" : "assumed, not calibrated: " + line + "\n\n";
}

void tell(const Job& job, const std::vector<results::Outcome>& outcomes) {
  const fs::path place = job.folder->wanted();
  const bool sweeps = job.sweeps();
  const std::string table =
      sweeps ? report::campaign_table(campaign_of(job, outcomes))
             : report::table(results::summarise(outcomes.front()), job.what.observe.threshold);
  fmt::print("{}\n\n{}\n", job.what.title, table);
  const std::string pairs =
      sweeps ? ""
             : report::pair_table(results::by_pair(outcomes.front()), job.what.observe.threshold);
  if (!pairs.empty()) fmt::print("{}\n", pairs);
  if (const std::string regime = results::regime(outcomes.front()); !sweeps && !regime.empty())
    fmt::print("{}: {}\n\n", regime, results::regime_reason(outcomes.front()));
  fmt::print("{}", uncalibrated(job.points.front()));
  if (sweeps) {
    const auto doubtful = std::ranges::count_if(
        outcomes, [](const results::Outcome& o) { return !results::warnings(o).empty(); });
    if (doubtful > 0)
      fmt::print("Warning: {} of {} points have a warning in their report.\n\n", doubtful,
                 outcomes.size());
  } else {
    for (const std::string& words : results::warnings(outcomes.front()))
      fmt::print("Warning: {}\n\n", words);
    for (const std::string& note : outcomes.front().notes) fmt::print("{}\n\n", note);
  }
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / (sweeps ? "campaign.html" : "report.html")).string());
  fmt::print("numbers:  {}\n\n", (place / (sweeps ? "campaign.csv" : "summary.json")).string());
}

void print_json(const std::vector<Job>& jobs) {
  auto list = nlohmann::ordered_json::array();
  for (const Job& job : jobs) {
    const fs::path place = job.folder->wanted();
    list.push_back(
        {{"title", job.what.title}, {"results", place.string()}, {"points", job.points.size()}});
  }
  fmt::print("{}\n", list.dump(2));
}

/// All cases read, and all their places found free, before anything is computed.
std::vector<Job> prepare_all(const Request& request) {
  const cases::Catalogue known = catalogue();
  const std::vector<fs::path> files = case_files(request.target);
  std::vector<Job> jobs;
  std::vector<Fault> wrong;
  for (const fs::path& file : files) try {
      jobs.push_back(prepare(request, file, files.size() > 1, known));
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return jobs;
}

/// Where the states of a run are kept: beside its results. Nothing if nobody asked for it.
std::unique_ptr<campaign::Checkpoint> checkpoint(const Request& request,
                                                 const std::vector<Job>& jobs) {
  if (!request.checkpoint && !request.resume) return nullptr;
  std::string what = fmt::format("version {}\n", version());
  std::size_t replicates = 0;
  for (const Job& job : jobs)
    for (const cases::Case& point : job.points) {
      if (point.observe.collisions || point.observe.frames)
        throw InputError(Fault{point.file,
                               fmt::format("a run that keeps {} cannot be gone on with",
                                           point.observe.frames ? "frames" : "every collision"),
                               fmt::format("{}, or leave out --checkpoint and --resume",
                                           point.observe.frames ? "leave out [observe] frames"
                                                                : "write collisions = false"),
                               "bad-checkpoint"});
      what += cases::write(point) + cases::contents_of_files(point);
      replicates += static_cast<std::size_t>(point.run.replicates);
    }
  fs::path place = jobs.front().folder->wanted();
  if (jobs.size() > 1) place = place.parent_path();
  constexpr double usual = 60;  // [s]
  auto made = std::make_unique<campaign::Checkpoint>(
      place.string() + ".checkpoint", what, replicates, request.checkpoint.value_or(usual));
  if (request.resume) made->load();
  return made;
}

}  // namespace

int run(const Request& request) {
  const std::vector<Job> jobs = prepare_all(request);
  const auto kept = checkpoint(request, jobs);
  std::vector<cases::Case> points;
  Streams streams;
  for (const Job& job : jobs)
    for (std::size_t i = 0; i < job.points.size(); ++i) {
      points.push_back(job.points[i]);
      streams.add(job.points[i], *job.folder, job.below(i));
    }
  catch_ctrl_c();
  const std::vector<results::Outcome> outcomes = compute(request, points, streams, kept.get());
  streams.close();
  const bool talks = !request.quiet && !request.json;
  auto next = outcomes.begin();
  for (const Job& job : jobs) {
    const auto end = next + static_cast<std::ptrdiff_t>(job.points.size());
    const std::vector<results::Outcome> mine(next, end);
    next = end;
    write(job, mine);
    if (talks) tell(job, mine);
  }
  if (request.json) print_json(jobs);
  if (talks) fmt::print("computed in {:.2g} s\n", outcomes.front().wall_seconds);
  const int ended = how_it_ended(outcomes);
  if (kept && !kept->written())
    fmt::print(stderr, "the checkpoint could not be written: check space and rights\n");
  if (kept && ended == interrupted && talks) fmt::print("go on with it:  --resume\n");
  if (kept && ended == fine) kept->remove();
  return ended;
}

}  // namespace mahlwerk::app
