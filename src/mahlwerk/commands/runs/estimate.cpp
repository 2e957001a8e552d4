// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// estimate: the first answers for a mill in a few words, with bands.
#include "mahlwerk/report/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/runs/estimate_case.hpp"
#include "mahlwerk/results/files/folder.hpp"

namespace mahlwerk::commands {
namespace {

constexpr std::string_view no_file = "estimate";  // cited where a case file would be

struct EstimateArguments {
  EstimateWords words;
  std::vector<cases::Override> set;
  Running running;
  std::optional<std::filesystem::path> save;
};

/// The case that is run, and what it is read from.
struct EstimateJob {
  std::string text;
  cases::Case mill_case;
};

/// The fault for somebody who has no file: without its line, and with the option that mends it.
Fault without_file(Fault fault) {
  static constexpr std::array<std::array<std::string_view, 2>, 4> options{
      {{"`frequency`", "--frequency 30Hz"},
       {"`speed`", "--speed 400rpm"},
       {"`density`", "--material steel-1.4034, or another name from mahlwerk list materials"},
       {"`kind`", "--jar NAME, or --set jar.kind=cylinder and its sizes"}}};
  if (!fault.where.starts_with(no_file)) return fault;
  fault.where = no_file;
  if (fault.code != "missing-value") return fault;
  for (const auto& [key, option] : options)
    if (fault.what.find(key) != std::string::npos) fault.remedy = fmt::format("give {}", option);
  return fault;
}

cases::Case read(const EstimateArguments& given, const std::string& text,
                 const cases::Catalogue& known, const std::vector<cases::Override>& more = {}) {
  std::vector<cases::Override> set = given.set;
  set.insert(set.end(), more.begin(), more.end());
  cases::Case made;
  try {
    made = cases::read_text(text, std::string(no_file), known, set);
  } catch (const InputError& e) {
    std::vector<Fault> faults;
    std::ranges::transform(e.faults(), std::back_inserter(faults), without_file);
    throw InputError(std::move(faults));
  }
  if (!made.sweep.empty())
    throw InputError(Fault{"--set sweep", "an estimate has no campaign",
                           "save the case with --save, and sweep it", "bad-command-line"});
  return made;
}

/// [s] of a core for one replicate of a decided case, about, on any machine.
double cost_of_replicate(const cases::Case& decided, double simulated) {
  constexpr double event_cost = 0.02;  // of a ball and simulated second, in a bed in motion
  if (cases::in_time_steps(decided.run.engine))
    return campaign::soft_work(decided) * campaign::ball_step_cost;
  double balls = 0;
  for (const cases::BallSet& set : decided.balls) balls += static_cast<double>(set.count);
  return balls * simulated * event_cost;
}

/// [s] Counted time: a hundred periods of the mill between one and five seconds, at least three
/// periods; less where many balls would take more than about half a minute of a core. It follows
/// from the case alone, so that an estimate is the same on any machine.
double time_to_count(const cases::Case& mill_case) {
  constexpr double most_cost = 30;  // [s] of a core
  const double period = cases::mill_period(mill_case);
  const double usual = std::isfinite(period) ? std::clamp(100 * period, 1.0, 5.0) : 1.0,
               least = std::isfinite(period) ? 3 * period : 0.1;
  cases::Case decided = campaign::decided_case(mill_case, campaign::choose_engine(mill_case));
  decided.run.time = usual;
  const double settling = cases::least_settling(decided);
  const double cost = cost_of_replicate(decided, settling + usual) *
                      static_cast<double>(decided.run.replicates) *
                      (1 + campaign::assumed_values_cost(decided, settling));
  return std::max(usual * std::min(1.0, most_cost / cost), least);
}

EstimateJob prepare(const EstimateArguments& given, const cases::Catalogue& known) {
  std::string text = estimate_case(given.words, known, "1 s");
  const double time = time_to_count(read(given, text, known));
  text = estimate_case(given.words, known, show_rounded(time, "s", 2));
  EstimateJob job{text, read(given, text, known)};
  if (std::vector<Fault> wrong = campaign::run_faults(job.mill_case); !wrong.empty())
    throw InputError(std::move(wrong));
  return job;
}

/// The case as a file: with the values of --set, as comments that say where it is from.
std::string saved_text(const EstimateArguments& given, const EstimateJob& job) {
  std::string text =
      "# A case by `mahlwerk estimate`; `mahlwerk check` shows every value that it assumes.\n";
  for (const cases::Override& one : given.set)
    text += fmt::format("# run it with --set {}\n", shell_word(one.key + "=" + one.value));
  return text + job.text;
}

int estimate(const EstimateArguments& given) {
  catch_ctrl_c();
  const cases::Catalogue known = catalogue();
  const EstimateJob job = prepare(given, known);
  if (given.save) {
    refuse_existing(*given.save, given.running.force);
    results::write_whole(*given.save, saved_text(given, job));
  }
  ProgressLine line(given.running.quiet);
  campaign::RunOptions options = run_options(given.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  results::Outcome outcome = campaign::run(job.mill_case, options);
  if (!stop_wanted())
    outcome.summary.sensitivity = campaign::sensitivity_to_assumed(
        outcome,
        [&](const std::string& key, const std::string& value) {
          return read(given, job.text, known, {{key, value}});
        },
        options);
  if (const int ended = report_exit_status({outcome}); ended != success) return ended;
  if (given.running.json)
    json_to_stdout(report::estimate_json(outcome, job.text, version()));
  else
    to_stdout(report::estimate_words(outcome));
  if (given.running.prints_text())
    to_stdout(given.save
                  ? fmt::format("\nMore: mahlwerk run {}\n", shell_word(given.save->string()))
                  : "\nMore: --save FILE writes the case, mahlwerk run FILE gives everything.\n");
  return success;
}

}  // namespace

Command estimate_command() {
  const auto given = std::make_shared<EstimateArguments>();
  EstimateWords& words = given->words;
  return {"estimate",
          "the first answers for a mill in a few words: power, hits and dose, each with its band",
          {{.name = "MILL",
            .target = &words.mill,
            .about = "mill of the catalogue, by its name or as people call it: \"MM 400\"",
            .required = true},
           {.name = "--jar",
            .target = &words.jar,
            .about = "jar of the mill by its volume, 25ml, or name (default: a middle one)"},
           {.name = "--material",
            .target = &words.material,
            .about = "material of balls and jar: steel-1.4034, ZrO2, ..."},
           {.name = "--balls",
            .target = &words.balls,
            .about = "number and diameter, 2x10mm; or mass or filling of the jar and diameter, "
                     "\"50 g x 3 mm\", \"30 % x 5 mm\"; or a ball set; may be repeated",
            .type = "BALLS"},
           {.name = "--frequency",
            .target = &words.frequency,
            .about = "of a mill that oscillates: 30Hz"},
           {.name = "--speed", .target = &words.speed, .about = "of a mill that turns: 400rpm"},
           {.name = "--powder",
            .target = &words.powder,
            .about = "its mass, 200mg, or the mass of the balls over it, 10:1"},
           {.name = "--time", .target = &words.time, .about = "how long the mill runs: 1h"},
           {"--set", &given->set,
            "value of any other key of the case: --set contact.restitution=0.6", "KEY=VALUE"},
           {.name = "--save", .target = &given->save, .about = "writes the case to this file"},
           {"--force", &given->running.force, "replace an existing file"},
           threads(given->running.threads),
           quiet(given->running.quiet),
           json(given->running.json)},
          [given] { return estimate(*given); }};
}

}  // namespace mahlwerk::commands
