// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// estimate: the first answers for a mill in a few words, with bands.
#include "mahlwerk/report/estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reference/estimate_text.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
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

/// The key that a fault names: "[mill] lacks `ratio`" gives "mill.ratio"; empty: none.
std::string key_of(std::string_view what) {
  const auto between = [&](char open, char close) {
    const std::size_t begin = what.find(open), end = what.find(close, begin + 1);
    return begin == what.npos || end == what.npos ? std::string_view()
                                                  : what.substr(begin + 1, end - begin - 1);
  };
  const std::string_view section = between('[', ']'), key = between('`', '`');
  return section.empty() || key.empty() ? "" : fmt::format("{}.{}", section, key);
}

/// The fault for somebody who has no file: without its line, and with the option that mends it.
Fault without_file(Fault fault) {
  static constexpr std::array<std::array<std::string_view, 2>, 4> options{
      {{"`frequency`", "--frequency 30Hz"},
       {"`speed`", "--speed 400rpm"},
       {"`density`", "--material steel-1.4034, or another name from mahlwerk list materials"},
       {"`kind`", "--jar NAME, or --set jar.kind=cylinder and its sizes"}}};
  if (!fault.where.starts_with(no_file)) return fault;
  fault.where = no_file;
  for (const std::string_view option : {"frequency", "speed"})
    if (fault.code == "unknown-key" && key_of(fault.what) == fmt::format("mill.{}", option))
      fault.remedy = fmt::format("this mill has none: leave out --{}", option);
  if (fault.code != "missing-value") return fault;
  if (const std::string key = key_of(fault.what); !key.empty())
    fault.remedy = fmt::format("give --set {}=VALUE ({})", key, fault.remedy);
  for (const auto& [key, option] : options)
    if (fault.what.find(key) != std::string::npos) fault.remedy = fmt::format("give {}", option);
  return fault;
}
std::vector<Fault> without_file(const std::vector<Fault>& faults) {
  std::vector<Fault> told;
  std::ranges::transform(faults, std::back_inserter(told),
                         [](const Fault& fault) { return without_file(fault); });
  return told;
}

cases::Case read(const EstimateArguments& given, const std::string& text,
                 const cases::Catalogue& known, const std::vector<cases::Override>& more = {}) {
  std::vector<cases::Override> set = given.set;
  set.insert(set.end(), more.begin(), more.end());
  cases::Case made;
  try {
    made = cases::read_text(text, std::string(no_file), known, set);
  } catch (const InputError& e) {
    throw InputError(without_file(e.faults()));
  }
  if (!made.sweep.empty())
    throw InputError(Fault{"--set sweep", "an estimate has no campaign",
                           "save the case with --save, and sweep it", "bad-command-line"});
  return made;
}

EstimateJob prepare(const EstimateArguments& given, const cases::Catalogue& known) {
  const auto reader = [&](const std::string& text) { return read(given, text, known); };
  const std::string text = estimate_text(given.words, known, reader);
  EstimateJob job{text, read(given, text, known)};
  if (std::vector<Fault> wrong = campaign::run_faults(job.mill_case); !wrong.empty())
    throw InputError(without_file(wrong));
  return job;
}

/// Throws InputError if the case cannot be saved there.
void check_save(const std::filesystem::path& file, bool force) {
  std::error_code none;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const bool is_folder = std::filesystem::is_directory(file, none);
  if (file.empty() || is_folder || !std::filesystem::is_directory(folder, none))
    throw InputError(Fault{"--save " + file.string(),
                           is_folder ? "this is a folder" : "there is no folder for this file",
                           "name a file in a folder that exists: --save my-case.toml",
                           "bad-command-line"});
  refuse_existing(file, force);
}

/// The values of --set as the command line takes them, with a blank before each.
std::string set_words(const EstimateArguments& given) {
  std::string words;
  for (const cases::Override& one : given.set)
    words += " --set " + shell_word(one.key + "=" + one.value);
  return words;
}

/// The outcome with what its assumed values do; the runs for it may be stopped.
results::Outcome compute(const EstimateArguments& given, const EstimateJob& job,
                         const cases::Catalogue& known) {
  ProgressLine line(given.running.quiet);
  campaign::RunOptions options = run_options(given.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  results::Outcome outcome = campaign::run(job.mill_case, options);
  const auto with_value = [&](const std::string& key, const std::string& value) {
    return read(given, job.text, known, {{key, value}});
  };
  if (!stop_wanted())
    outcome.summary.sensitivity = campaign::sensitivity_to_assumed(outcome, with_value, options);
  return outcome;
}

int estimate(const EstimateArguments& given) {
  catch_ctrl_c();
  const cases::Catalogue known = catalogue();
  if (given.save) check_save(*given.save, given.running.force);
  const EstimateJob job = prepare(given, known);
  if (given.save) results::write_whole(*given.save, saved_estimate(job.text, set_words(given)));
  const results::Outcome outcome = compute(given, job, known);
  if (stop_wanted())
    return report_interrupted(given.running, "an estimate keeps no numbers; start it again.");
  if (const int ended = report_exit_status({outcome}); ended != success) return ended;
  if (given.running.json) json_to_stdout(report::estimate_json(outcome, job.text, version()));
  if (!given.running.prints_text()) return success;
  to_stdout(report::estimate_words(outcome));
  const std::string file = given.save ? shell_word(given.save->string()) : "FILE";
  to_stdout(fmt::format("\nMore: {}mahlwerk run {}{}\n",
                        given.save ? "" : "--save FILE writes the case; ", file, set_words(given)));
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
