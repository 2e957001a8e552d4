// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// papers: runs the campaigns of a paper, draws its figures and tests its claims.
#include <fmt/format.h>

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/campaigns/paper_folders.hpp"
#include "mahlwerk/commands/campaigns/render.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/paper/figure_plot.hpp"
#include "mahlwerk/report/paper/overview.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct PapersArguments : CaseArguments {
  bool quick = false;                ///< without those that take long
  std::optional<double> checkpoint;  ///< [s]
};

/// A paper with the cases of its campaigns.
struct PaperJob {
  report::Paper paper;
  std::map<std::string, cases::Case> whole;                ///< by campaign: its case with [sweep]
  std::map<std::string, std::vector<cases::Case>> points;  ///< by campaign: its points
  std::unique_ptr<results::Folder> folder;
};

PaperJob prepare_paper(const PapersArguments& given, report::Paper paper, const fs::path& results,
                       const cases::Catalogue& catalogue) {
  PaperJob job;
  job.paper = std::move(paper);
  const std::vector<cases::Override> set = given.changes.overrides();
  std::vector<Fault> wrong;
  for (const std::string& name : job.paper.campaigns()) try {
      const fs::path file = job.paper.folder / (name + ".toml");
      job.whole[name] = cases::read(file, catalogue, set);
      job.points[name] = campaign::points(job.whole[name], catalogue, set);
      for (const cases::Case& point : job.points[name])
        for (Fault& fault : campaign::run_faults(point)) wrong.push_back(std::move(fault));
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (wrong.empty()) wrong = report::paper_faults(job.paper, job.whole);
  if (wrong.empty()) wrong = report::band_faults(job.paper, job.whole);
  if (!wrong.empty()) throw InputError(std::move(wrong));
  job.folder = std::make_unique<results::Folder>(results, given.running.force);
  return job;
}

/// The papers that are asked for. --quick leaves out those that take long.
std::vector<PaperJob> prepare_papers(const PapersArguments& given,
                                     const cases::Catalogue& catalogue) {
  std::vector<PaperJob> jobs;
  const std::vector<PaperFolder> folders = paper_folders(given.target);
  for (const PaperFolder& folder : folders) {
    report::Paper paper = report::read_paper(folder.place / "paper.toml");
    if (given.quick && !paper.quick) continue;
    const auto& out = given.running.out;
    const fs::path results = !out                 ? folder.results
                             : folders.size() > 1 ? *out / folder.results.filename()
                                                  : *out;
    jobs.push_back(prepare_paper(given, std::move(paper), results, catalogue));
  }
  if (jobs.empty())
    throw InputError(Fault{given.target, "--quick leaves out all of these papers",
                           "leave out --quick", "no-such-paper"});
  return jobs;
}

std::string below(const std::string& campaign, std::size_t point) {
  return fmt::format("{}/point-{:03}/", campaign, point + 1);
}

report::Campaign numbers_of(const cases::Case& mill_case,
                            const std::vector<results::Outcome>& outcomes) {
  const campaign::Plan plan(mill_case.sweep, mill_case.seed);
  const std::vector<std::string> own = campaign::base_values(plan, mill_case);
  report::Campaign made{.title = mill_case.title};
  for (const results::Outcome& outcome : outcomes) {
    const std::size_t i = made.points.size();
    report::add(made,
                {.number = i + 1,
                 .values = campaign::point_values(plan, i, own),
                 .regime = outcome.summary.regime,
                 .warnings = results::warning_codes(outcome.notices),
                 .folder = fmt::format("point-{:03}/", i + 1)},
                outcome.summary.quantities);
  }
  for (const results::Outcome& outcome : outcomes) results::count(made.notices, outcome.notices);
  results::sort(made.notices);
  made.keys = report::campaign_keys(plan.keys(), made.points);
  return made;
}

/// The points of all campaigns; points that campaigns share are stored once.
class UniquePoints {
 public:
  /// Adds a point unless an equal one is there. Returns its index in `points`.
  std::size_t add(const cases::Case& point) {
    cases::Case bare = point;
    bare.title.clear();
    const bool alone =
        point.observe.collisions || point.observe.frames;  // such a point writes its own files
    const std::string what = alone ? "" : cases::write(bare) + cases::input_files_fingerprint(bare);
    if (!alone) {
      const auto [known, fresh] = places_.try_emplace(what, points.size());
      if (!fresh) return known->second;
    }
    points.push_back(point);
    return points.size() - 1;
  }
  std::vector<cases::Case> points;

 private:
  std::map<std::string, std::size_t> places_;
};

/// Where a point stands in the paper.
struct PointPlace {
  std::string campaign;
  std::size_t point = 0;
};

/// Writes the results of points as they end and frees their statistics, unless a table of the paper
/// needs them.
class PointWriter {
 public:
  PointWriter(const PaperJob& job, std::vector<std::vector<PointPlace>> places)
      : job_(job), places_(std::move(places)) {
    for (const report::PaperTable& table : job.paper.tables)
      if (table.kind == report::PaperTable::Kind::captured) in_tables_.insert(table.campaign);
  }
  void operator()(std::size_t k, results::Outcome& ended) {
    if (ended.interrupted) return;  // nothing of the paper will be written
    const std::lock_guard<std::mutex> one_at_a_time(mutex_);
    bool needed = false;
    for (const auto& [campaign, i] : places_[k]) {
      ended.mill_case = job_.points.at(campaign)[i];
      report::write(*job_.folder, ended, version(), below(campaign, i), false);
      needed = needed || in_tables_.contains(campaign);
    }
    if (!needed) results::release_statistics(ended);
  }

 private:
  const PaperJob& job_;
  std::vector<std::vector<PointPlace>> places_;
  std::set<std::string> in_tables_;
  std::mutex mutex_;
};

/// Runs all points of all campaigns of the paper together, so that no core idles between campaigns.
std::map<std::string, report::RunCampaign> run_all(const PapersArguments& given,
                                                   const PaperJob& job,
                                                   campaign::ResumableRuns& kept) {
  UniquePoints unique;
  campaign::Streams streams(version());
  std::map<std::string, std::vector<std::size_t>> at;
  std::vector<std::vector<PointPlace>> places;
  for (const auto& [name, points] : job.points)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t k = unique.add(points[i]);
      at[name].push_back(k);
      if (k == places.size()) {
        places.emplace_back();
        streams.add(points[i], *job.folder, below(name, i));
      }
      places[k].push_back({name, i});
    }
  std::vector<std::size_t> uses;  // of each outcome, by campaigns
  for (const auto& one : places) uses.push_back(one.size());
  PointWriter write(job, std::move(places));
  std::vector<results::Outcome> outcomes =
      compute(given.running, unique.points, streams, kept, given.checkpoint, true, std::ref(write));
  streams.close();
  std::map<std::string, report::RunCampaign> run;
  std::vector<bool> counted(outcomes.size(), false);
  for (const auto& [name, points] : job.points) {
    report::RunCampaign& one = run[name];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t k = at[name][i];
      if (!counted[k]) one.seconds += outcomes[k].cpu_seconds;
      counted[k] = true;
      const bool last = --uses[k] == 0;
      one.outcomes.push_back(last ? std::move(outcomes[k]) : outcomes[k]);
      one.outcomes.back().mill_case = points[i];
    }
    one.numbers = numbers_of(job.whole.at(name), one.outcomes);
  }
  return run;
}

/// Writes the figures with their numbers. Returns why PDF or PNG files are missing.
std::optional<Fault> write_figures(const PaperJob& job, const report::PaperResult& result) {
  std::vector<fs::path> files;
  for (const report::PaperPicture& picture : result.pictures) {
    for (const auto& [name, text] : picture.tables) job.folder->write("figures/" + name, text);
    if (picture.svg.empty()) continue;
    const std::string name = "figures/" + picture.file + ".svg";
    job.folder->write(name, picture.svg);
    files.push_back(job.folder->file(name));
  }
  job.folder->write("figures/captions.md", report::captions_markdown(result));
  return render_figures(files);
}

/// Returns why PDF or PNG files of figures are missing.
std::optional<Fault> write(const PaperJob& job,
                           const std::map<std::string, report::RunCampaign>& run,
                           const report::PaperResult& result) {
  for (const auto& [name, one] : run) {
    job.folder->write(name + "/campaign.csv", report::campaign_csv(one.numbers));
    job.folder->write(name + "/campaign.html", report::campaign_page(one.numbers, version()));
  }
  std::optional<Fault> missing = write_figures(job, result);
  for (const report::MadeTable& table : result.tables) {
    const std::string name = "tables/" + table.table->name;
    job.folder->write(name + ".md", report::table_markdown(table));
    job.folder->write(name + ".csv", table.csv);
  }
  job.folder->write("claims.csv", report::claims_csv(result));
  job.folder->write("claims.md", report::claims_markdown(result));
  job.folder->write("paper.html", report::paper_page(result, version()));
  job.folder->commit();
  return missing;
}

void print_summary(const PaperJob& job, const report::PaperResult& result, double seconds,
                   bool written) {
  const fs::path place = job.folder->target();
  to_stdout(fmt::format("{}\n{}\n\n{}\n", job.paper.title, job.paper.source,
                        report::claims_text(result)));
  if (!written) return;
  fmt::print("page:     {}\n", (place / "paper.html").string());
  fmt::print("figures:  {}\n", (place / "figures").string());
  if (!result.tables.empty()) fmt::print("tables:   {}\n", (place / "tables").string());
  fmt::print("claims:   {}\n\n", (place / "claims.csv").string());
  fmt::print("done in {} s\n", two_digits(seconds));
}

results::Json as_json(const PaperJob& job, const report::PaperResult& result) {
  using results::Json;
  Json claims = Json::array();
  for (std::size_t i = 0; i < result.verdicts.size(); ++i)
    claims.push_back(Json::object({{"figure", job.paper.claims[i].figure},
                                   {"says", job.paper.claims[i].says},
                                   {"found", result.verdicts[i].finding},
                                   {"holds", report::word(result.verdicts[i].holds)}}));
  return Json::object({{"title", job.paper.title},
                       {"results", job.folder->target().string()},
                       {"claims", std::move(claims)},
                       {"notices", results::notices_json(result.notices)}});
}

/// The claims of all sets of measured data, written beside their results.
class Overview {
 public:
  explicit Overview(const Running& running)
      : running_(running),
        folder_(running.out.value_or(fs::path("results") / "validation") / "overview",
                running.force) {}

  void add(const PaperJob& job, const report::PaperResult& result) {
    for (report::OverviewRow& row :
         report::overview_rows(result, job.folder->target().filename().string()))
      rows_.push_back(std::move(row));
  }
  void write() {
    folder_.write("validation.md", report::overview_markdown(rows_));
    folder_.write("validation.csv", report::overview_csv(rows_));
    folder_.write("validation.html", report::overview_page(rows_, version()));
    folder_.commit();
    if (!running_.prints_text()) return;
    to_stdout(fmt::format("{}\n", report::overview_score(rows_)));
    fmt::print("overview: {}\n", (folder_.target() / "validation.html").string());
  }

 private:
  const Running& running_;
  results::Folder folder_;
  std::vector<report::OverviewRow> rows_;
};

int papers(const PapersArguments& given) {
  const Running& running = given.running;
  const cases::Catalogue known = catalogue();
  catch_ctrl_c();
  const std::vector<PaperJob> jobs = prepare_papers(given, known);
  std::optional<Overview> overview;
  if (is_validation(given.target)) overview.emplace(running);
  int ended = success;
  bool warned = false;
  results::Json list = results::Json::array();
  for (const PaperJob& job : jobs) {
    const auto started = std::chrono::steady_clock::now();
    campaign::ResumableRuns kept(job.folder->target());
    const std::map<std::string, report::RunCampaign> run = run_all(given, job, kept);
    if (stop_wanted()) {
      ended = report_interrupted(running,
                                 "finished runs are kept; run the same command again to resume");
      break;
    }
    report::PaperResult result = report::paper_result(job.paper, run);
    for (const auto& [key, value, swept] : given.changes.overrides())
      result.changed.push_back(fmt::format("{} = {}", key, value));
    std::optional<Fault> missing;
    const std::vector<Fault> unwritten = write_result([&] { missing = write(job, run, result); });
    if (missing && !warned && running.prints_errors()) print_warning(*missing);
    warned = warned || missing;  // said once for all papers
    if (unwritten.empty()) kept.remove();
    if (overview) overview->add(job, result);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    if (running.json) list.push_back(as_json(job, result));
    const auto print = [&] {
      if (running.prints_text()) print_summary(job, result, seconds, unwritten.empty());
    };
    ended = print_result(print, unwritten, ended);
    if (!unwritten.empty()) break;  // the others would meet the same disk
    for (const auto& [name, one] : run)
      if (const int how = report_exit_status(one.outcomes); how != success) ended = how;
  }
  if (overview && ended != interrupted && ended != bad_input) overview->write();
  if (running.json) json_to_stdout(list);
  return ended;
}

}  // namespace

Command papers_command() {
  const auto given = std::make_shared<PapersArguments>();
  return {
      "papers", "regenerate every figure of a paper and test its claims",
      joined({{{"PAPER", &given->target,
                "a folder of papers/ or validation/, any folder with a paper.toml, or "
                "\"validation\": all "
                "sets of measured data (default: all papers)"}},
              options_of(given->changes),
              {{"--quick", &given->quick, "leave out the papers whose file says quick = false"}},
              options_of(given->running, "; papers in results/papers"),
              {resumable_checkpoint(given->checkpoint), json(given->running.json)}}),
      [given] { return papers(*given); }};
}

}  // namespace mahlwerk::commands
