// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run: one case, a sweep, or every case of a folder, to result folders.
#include "mahlwerk/campaign/run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/soft_settings.hpp"
#include "mahlwerk/report/campaign.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/folder.hpp"
#include "mahlwerk/results/hdf5.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// A case file with everything it takes to run it: its points, and where they go.
struct Job {
  cases::Case what;
  std::vector<cases::Case> points;  ///< one unless the case sweeps
  std::unique_ptr<results::Folder> folder;
  std::vector<std::unique_ptr<results::CollisionFile>> kept;

  bool sweeps() const { return !what.sweep.empty(); }
  std::string below(std::size_t point) const {
    return sweeps() ? fmt::format("point-{:03}/", point + 1) : "";
  }
};

/// results/ and the name of the folder or file the user gave, with each case's name if there are
/// several.
fs::path default_place(const std::string& target, const fs::path& file, bool several) {
  const fs::path whole = fs::weakly_canonical(fs::path(target));
  const bool by_file = !fs::is_directory(whole) && file.stem() != "case";
  const fs::path name =
      by_file ? file.stem() : (fs::is_directory(whole) ? whole : whole.parent_path()).filename();
  return several ? fs::path("results") / name / file.stem() : fs::path("results") / name;
}

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
  for (std::size_t i = 0; i < job.points.size(); ++i)
    job.kept.push_back(job.points[i].observe.collisions
                           ? std::make_unique<results::CollisionFile>(
                                 job.folder->file(job.below(i) + "collisions.h5"),
                                 cases::write(job.points[i]), version())
                           : nullptr);
  return job;
}

report::Campaign campaign_of(const Job& job, const std::vector<results::Outcome>& outcomes) {
  std::vector<std::string> keys;
  for (const auto& [key, values] : job.what.sweep) keys.push_back(key);
  report::Campaign made{.title = job.what.title, .swept = {}, .points = {}};
  for (const results::Outcome& outcome : outcomes) {
    const std::size_t i = made.points.size();
    report::Point point{
        .values = {}, .quantities = results::summarise(outcome), .folder = job.below(i)};
    // The product of all values, the last key running fastest, as campaign::points makes it.
    std::size_t rest = i;
    for (auto key = job.what.sweep.rbegin(); key != job.what.sweep.rend(); ++key) {
      point.values.insert(point.values.begin(), key->second[rest % key->second.size()]);
      rest /= key->second.size();
    }
    made.points.push_back(std::move(point));
  }
  made.swept = report::swept(keys, made.points);
  return made;
}

void write(const Job& job, const std::vector<results::Outcome>& outcomes) {
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (job.kept[i]) job.kept[i]->close();
    report::write(*job.folder, outcomes[i], version(), job.below(i));
  }
  if (job.sweeps()) {
    const report::Campaign campaign = campaign_of(job, outcomes);
    job.folder->write("campaign.csv", report::campaign_csv(campaign));
    job.folder->write("campaign.html", report::campaign_page(campaign, version()));
    for (const auto& [name, picture] : report::campaign_figures(campaign))
      job.folder->write(name, picture);
  }
  job.folder->commit();
}

/// Which runs did not end as asked, in words; empty if all did.
std::string trouble(const std::vector<results::Outcome>& outcomes) {
  for (const results::Outcome& outcome : outcomes)
    for (const results::Replicate& r : outcome.replicates)
      if (!r.stopped.empty()) return r.stopped;
  return "";
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
  fmt::print("{}\n\n{}\n{}", job.what.title, table, uncalibrated(job.points.front()));
  if (!sweeps)
    for (const std::string& note : outcomes.front().notes) fmt::print("{}\n\n", note);
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
      if (point.observe.collisions)
        throw InputError(Fault{
            point.file, "a run that keeps every collision cannot be gone on with",
            "write collisions = false, or leave out --checkpoint and --resume", "bad-checkpoint"});
      what += cases::write(point);
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

/// The points of all jobs, in order, computed together.
std::vector<results::Outcome> compute(const Request& request, const std::vector<Job>& jobs,
                                      campaign::Checkpoint* checkpoint) {
  std::vector<cases::Case> points;
  std::vector<results::CollisionFile*> kept;
  for (const Job& job : jobs) {
    points.insert(points.end(), job.points.begin(), job.points.end());
    for (const auto& file : job.kept) kept.push_back(file.get());
  }
  ProgressLine line(request.quiet);
  campaign::Options options;
  options.threads = request.threads;
  options.stop = &stop_wanted();
  options.checkpoint = checkpoint;
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  options.records = [&](std::size_t point, int replicate) -> std::unique_ptr<scene::Observer> {
    if (kept[point] == nullptr) return nullptr;
    return std::make_unique<results::CollisionLog>(*kept[point], replicate);
  };
  return campaign::run(points, options);
}

int how_it_ended(const std::vector<results::Outcome>& outcomes) {
  if (const std::string why = trouble(outcomes); !why.empty()) {
    fmt::print(stderr, "stopped: {}\nWhat was computed until then is kept.\n", why);
    return stopped_by_physics;
  }
  if (stop_wanted()) {
    fmt::print(stderr,
               "interrupted: what was computed until then is kept, and marked incomplete.\n");
    return interrupted;
  }
  return fine;
}

}  // namespace

int run(const Request& request) {
  const std::vector<Job> jobs = prepare_all(request);
  const auto kept = checkpoint(request, jobs);
  catch_ctrl_c();
  const std::vector<results::Outcome> outcomes = compute(request, jobs, kept.get());
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
