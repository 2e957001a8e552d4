// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// optimise: the settings of a mill for which a quantity is best.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/writer.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/summarise.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "searching.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

std::string place_of_quantity(const cases::Case& what, const cases::Optimise& wanted,
                              const std::string& name) {
  const char* goal = wanted.maximise ? "optimise.maximise" : "optimise.minimise";
  return cases::place_of(what, name == wanted.quantity ? goal : "optimise.limits." + name);
}

/// Names that mean the same with more behind: of "wear_rate" those of balls and of the jar.
std::vector<std::string> longer(const std::string& name, const std::vector<std::string>& known) {
  std::vector<std::string> found;
  for (const std::string& one : known)
    if (one.starts_with(name + "_")) found.push_back(one);
  return found;
}

/// What to write instead of a quantity that the case does not have.
std::string instead_of(const std::string& name, std::vector<std::string> known,
                       const std::vector<results::MissingQuantity>& lacking) {
  const auto section_of = [&](const std::string& of) {
    const auto at = std::ranges::find(lacking, of, &results::MissingQuantity::name);
    return at == lacking.end() ? std::string() : at->section;
  };
  if (const std::string section = section_of(name); !section.empty())
    return fmt::format("it comes with {}: add that to the case", section);
  for (const results::MissingQuantity& one : lacking) known.push_back(one.name);
  std::vector<std::string> meant = longer(name, known);
  if (const std::string near = nearest_word(name, known); !near.empty()) meant = {near};
  if (meant.empty()) return "choose one of summary.json: docs/formats.md lists them";
  std::string words;
  for (const std::string& one : meant)
    words += fmt::format("{}\"{}\"", words.empty() ? "" : " or ", one);
  const std::string section = section_of(meant.front());
  return fmt::format("did you mean {}?{}", words,
                     section.empty() ? "" : fmt::format(" It comes with {}", section));
}

/// Those that a search is judged by, in the order of their names here.
std::vector<Judged> judged(const cases::Case& what, const cases::Optimise& wanted) {
  const std::vector<results::Measure> known = results::measures(what);
  std::vector<std::string> names{wanted.quantity}, all;
  for (const cases::Limit& limit : wanted.limits) names.push_back(limit.quantity);
  for (const results::Measure& q : known) all.push_back(q.name);
  std::vector<Judged> made;
  std::vector<Fault> wrong;
  for (const std::string& name : names) {
    const auto q = std::ranges::find(known, name, &results::Measure::name);
    if (q != known.end()) {
      made.push_back({q->name, q->unit, q->about});
      continue;
    }
    wrong.push_back({place_of_quantity(what, wanted, name),
                     fmt::format("a run of this case has no quantity \"{}\"", name),
                     instead_of(name, all, results::missing_quantities(what)), "no-such-quantity"});
  }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

double bound_of(const cases::Case& what, const cases::Limit& limit, const Judged& of) try {
  return parse_in(limit.bound, of.unit == "1" ? "" : of.unit);
} catch (const UnitError& error) {
  const std::string unit =
      of.unit == "1" ? "give a number without a unit" : fmt::format("give it in {}", of.unit);
  throw InputError(Fault{cases::place_of(what, "optimise.limits." + limit.quantity),
                         fmt::format("the limit of {}: {}", limit.quantity, error.what()), unit,
                         "bad-limit"});
}

SearchJob prepare(const campaign::TrialRuns& runs) {
  const cases::Case& base = runs.base();
  const cases::Optimise& wanted = *base.optimise;
  SearchJob job{.runs = &runs,
                .goal = {},
                .outcomes = judged(base, wanted),
                .limits = wanted.limits,
                .measure = {}};
  job.goal = {.keys = runs.over().size(),
              .maximise = wanted.maximise,
              .bounds = {},
              .settings = static_cast<int>(wanted.settings),
              .replicates = static_cast<int>(wanted.replicates),
              .seed = base.seed,
              .snap = [&runs](const campaign::Place& place) { return runs.snap(place); }};
  for (std::size_t i = 0; i < wanted.limits.size(); ++i)
    job.goal.bounds.push_back({.below = wanted.limits[i].below,
                               .value = bound_of(base, wanted.limits[i], job.outcomes[i + 1])});
  std::vector<std::string> names;
  for (const Judged& j : job.outcomes) {
    names.push_back(j.name);
    job.measure_name += j.name + " ";
  }
  job.measure = [names](const results::Outcome& outcome, const results::Replicate& replicate) {
    std::vector<double> values;
    for (const std::string& name : names)
      values.push_back(results::value_of(outcome, replicate, name));
    return values;
  };
  return job;
}

void write(const results::Folder& folder, const report::OptimumReport& found) {
  folder.write("optimise.json", optimum_json(found, version()).text(2) + '\n');
  folder.write("settings.csv", report::optimum_csv(found));
  folder.write("optimise.html", report::optimum_page(found, version()));
}

void tell(const report::OptimumReport& found, const fs::path& place) {
  to_stdout(fmt::format("{}\n\n{}\n", found.title, report::optimum_table(found)));
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / "optimise.html").string());
  fmt::print("settings: {}\n", (place / "settings.csv").string());
  if (found.best) fmt::print("case:     {}\n", (place / "best.toml").string());
}

int optimise(const Request& request) {
  const fs::path file = one_case_file(request.target, "optimise");
  const cases::Catalogue known = catalogue();
  const std::vector<cases::Override> set = overrides(request);
  const cases::Case what = cases::read(file, known, set);
  if (!what.optimise)
    throw InputError(Fault{what.file, "the case has no [optimise]",
                           "say what is looked for: [optimise] with maximise = "
                           "\"dissipated_power\" and over = { \"mill.speed\" = { from = \"200 "
                           "rpm\", to = \"600 rpm\" } }",
                           "nothing-to-optimise"});
  check_keys(what, what.optimise->over, "[optimise]");
  const campaign::TrialRuns runs(file, known, set, cases::Giver::optimise);
  SearchJob job = prepare(runs);
  const fs::path usual = default_place(request.target, file, false).string() + "-optimise";
  results::Folder folder(request.out.value_or(usual), request.force);
  catch_ctrl_c();
  KeptSearch kept(folder.wanted());
  try {
    const campaign::Optimum found = look(request, job, kept);
    report::OptimumReport report = report_of(job, found);
    report.check = check_best(request, job, found, kept);
    write(folder, report);
    if (found.best) {
      const int count = static_cast<int>(runs.base().run.replicates);
      results::write_case(folder, runs.at(found.tried[*found.best].place, 0, count), "best.toml");
    }
    folder.commit();
    kept.remove();
    if (request.json) json_to_stdout(optimum_json(report, version()));
    if (!request.json && !request.quiet) tell(report, folder.wanted());
    return found.best ? fine : stopped_by_physics;
  } catch (const Interrupted&) {
    return kept.tell_interrupted();
  }
}

}  // namespace

Command optimise_command() {
  return {"optimise", "find the settings for which a quantity is best: [optimise] of the case",
          joined({{one_case()}, changes(), running(", with -optimise"), {json()}}), optimise};
}

}  // namespace mahlwerk::app
