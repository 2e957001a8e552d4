// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// papers: runs the campaigns of a paper, draws its figures and tests its claims.
#include <fmt/format.h>

#include <chrono>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/campaigns/paper_folders.hpp"
#include "mahlwerk/commands/campaigns/paper_runs.hpp"
#include "mahlwerk/commands/campaigns/render.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/paper/figure_plot.hpp"
#include "mahlwerk/report/paper/overview.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct PapersArguments : CaseArguments {
  bool quick = false;                ///< without those that take long
  std::optional<double> checkpoint;  ///< [s]
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
    const auto [run, lost] = run_paper(running, given.checkpoint, job, kept);
    if (stop_wanted()) {
      ended = report_interrupted(running,
                                 "finished runs are kept; run the same command again to resume");
      break;
    }
    report::PaperResult result = report::paper_result(job.paper, run);
    for (const auto& [key, value, swept] : given.changes.overrides())
      result.changed.push_back(fmt::format("{} = {}", key, value));
    std::optional<Fault> missing;
    std::vector<Fault> unwritten = lost;
    if (unwritten.empty())
      unwritten = write_result([&, &campaigns = run] { missing = write(job, campaigns, result); });
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
