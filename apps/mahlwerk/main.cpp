// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <span>
#include <system_error>

#include "commands.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "messages.hpp"
#include "output.hpp"

namespace mahlwerk::app {
namespace {

/// "mill.speed=500 rpm" becomes a key and a value.
cases::Override override_of(const std::string& text) {
  const auto at = text.find('=');
  if (at == 0 || at == std::string::npos)
    throw InputError(Fault{"--set " + text, "this is no key=value",
                           "write for instance --set mill.frequency=\"12 Hz\"", "bad-override"});
  return {text.substr(0, at), text.substr(at + 1)};
}

/// What a command writes beside results/NAME.
std::string_view beside(Takes takes) {
  switch (takes) {
    case Takes::compare:
      return ", with -compare";
    case Takes::fit:
      return ", with -fit";
    case Takes::search:
      return ", with -optimise";
    case Takes::match:
      return " of mill B, with -match";
    case Takes::papers:
      return "; papers in results/papers";
    default:
      return "";
  }
}

/// The case, or cases, that a command is about.
void add_target(CLI::App& sub, const Command& command, Request& request) {
  if (command.takes == Takes::match) {
    sub.add_option("CASE", request.target,
                   "the mill A that is to be matched: a case file or folder")
        ->required();
    sub.add_option("--in", request.data,
                   "the mill B whose settings are looked for: a case with [match]")
        ->type_name("CASE")
        ->required();
    return;
  }
  if (command.takes == Takes::papers) {
    sub.add_option("PAPER", request.target,
                   "a folder of papers/, or any with a paper.toml (default: all papers)");
    return;
  }
  const bool one = command.takes == Takes::compare || command.takes == Takes::fit ||
                   command.takes == Takes::sweep || command.takes == Takes::search;
  auto* target = sub.add_option("CASE", request.target,
                                one ? "a case file, or a folder with one case"
                                    : "a case file, or a folder with a case.toml or several cases");
  if (command.takes != Takes::sweep) target->required();  // else a part of it may be meant
}

void add_case_options(CLI::App& sub, const Command& command, Request& request,
                      std::vector<std::string>& set) {
  add_target(sub, command, request);
  if (command.takes == Takes::fit)
    sub.add_option("DATA", request.data, "a table of measurements: CSV, see docs/formats.md")
        ->required();
  sub.add_option("--set", set, "change one value: --set mill.frequency=\"12 Hz\"; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  sub.add_option("--seed", request.seed, "seed of the random numbers, instead of the case's");
}

void add_run_options(CLI::App& sub, const Command& command, Request& request) {
  sub.add_option(
      "--out", request.out,
      fmt::format("folder for the results (default: results/ and the name of the case{})",
                  beside(command.takes)));
  sub.add_flag("--force", request.force, "replace results that are there");
  sub.add_option("--jobs,--threads", request.threads,
                 "how many replicates run at a time (default: all cores)")
      ->check(CLI::Range(1, 4096));
  sub.add_flag("--quiet", request.quiet, "no progress, no table: only errors");
}

void add_checkpoint_options(CLI::App& sub, const Command& command, Request& request) {
  const bool always = command.takes == Takes::papers || command.takes == Takes::match;
  sub.add_option("--checkpoint", request.checkpoint,
                 always
                     ? "keep the states of runs every so many seconds, for the same command to go "
                       "on from (default 1)"
                     : "keep the state of the run every so many seconds, beside the results, so "
                       "that --resume can go on from there")
      ->type_name("SECONDS")
      ->check([](const std::string& text) -> std::string {
        double seconds = 0;
        if (CLI::detail::lexical_cast(text, seconds) && seconds > 0 && seconds < 1e9) return {};
        return "'" + text + "' is no number of seconds above 0; write for instance --checkpoint 60";
      });
  if (always) return;  // it goes on unasked
  sub.add_flag("--resume", request.resume,
               "go on with a run that was ended, from its last kept state");
}

void add_campaign_options(CLI::App& sub, const Command& command, Request& request) {
  sub.add_option("FOLDER", request.target, "the campaign's folder")->required();
  if (command.name == "export") {
    sub.add_option("--out", request.out, "file to write (default: the terminal)");
    sub.add_flag("--force", request.force, "replace the file if it is there");
  }
  if (command.name == "retry")
    sub.add_option("--jobs,--threads", request.threads,
                   "how many replicates run at a time (default: all cores)")
        ->check(CLI::Range(1, 4096));
  if (command.name == "retry" || command.name == "merge")
    sub.add_flag("--quiet", request.quiet, "no progress, no table: only errors");
}

void add_sweep_options(CLI::App& sub, Request& request) {
  sub.add_option("--results", request.results,
                 "what is kept of each run: all (default up to 1000 points), or its summary in the "
                 "store alone")
      ->check(CLI::IsMember({"all", "summary"}));
  auto* shard = sub.add_option("--shard", request.shard,
                               "do only this part of the runs: 2/8 is the second of eight");
  auto* slurm = sub.add_option("--slurm", request.slurm,
                               "submit the campaign to Slurm as so many shards, and their merge")
                    ->type_name("SHARDS")
                    ->check(CLI::Range(1, 10'000));
  slurm->excludes(shard);
  sub.add_option("--slurm-option", request.slurm_options,
                 "a line for sbatch: --slurm-option partition=long; may be repeated")
      ->allow_extra_args(false)
      ->needs(slurm);
}

void add_options(CLI::App& sub, const Command& command, Request& request,
                 std::vector<std::string>& set) {
  const bool runs = command.takes == Takes::run || command.takes == Takes::sweep ||
                    command.takes == Takes::compare || command.takes == Takes::fit ||
                    command.takes == Takes::search || command.takes == Takes::match ||
                    command.takes == Takes::papers;
  if (runs || command.takes == Takes::case_file) add_case_options(sub, command, request, set);
  if (runs) add_run_options(sub, command, request);
  if (command.takes == Takes::run || command.takes == Takes::papers ||
      command.takes == Takes::match)
    add_checkpoint_options(sub, command, request);
  if (command.takes == Takes::sweep) add_sweep_options(sub, request);
  if (command.takes == Takes::campaign) add_campaign_options(sub, command, request);
  if (command.takes == Takes::room)
    sub.add_option("ROOM", request.target, "mills, jars, materials or media (default: all)");
  if (command.takes == Takes::name)
    sub.add_option("NAME", request.target, "a name from 'mahlwerk list'")->required();
  if (command.takes == Takes::shell)
    sub.add_option("SHELL", request.target, "bash or zsh")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh"}));
  if (command.takes != Takes::shell && command.name != "export")
    sub.add_flag("--json", request.json, "print JSON instead of a table");
}

/// Adds what may be typed after each command, and after its parts.
void add_words(const CLI::App& app, const std::string& command, std::vector<CommandWords>& all) {
  CommandWords one{command, {}};
  for (const CLI::App* part : app.get_subcommands({})) one.words.push_back(part->get_name());
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) one.words.push_back("--" + name);
  all.push_back(std::move(one));
  for (const CLI::App* part : app.get_subcommands({}))
    add_words(*part, command + (command.empty() ? "" : " ") + part->get_name(), all);
}

/// Words that users of other programs type.
constexpr std::array<std::array<std::string_view, 2>, 8> synonyms{{{"simulate", "run"},
                                                                   {"start", "run"},
                                                                   {"solve", "run"},
                                                                   {"validate", "check"},
                                                                   {"info", "describe"},
                                                                   {"show", "describe"},
                                                                   {"calibrate", "fit"},
                                                                   {"campaign", "sweep"}}};

/// Refuses a first word that is no command, with the one that was most likely meant.
void check_command(std::string_view word) {
  std::vector<std::string> known;
  for (const Command& command : commands)
    if (command.of.empty()) known.emplace_back(command.name);
  if (word.starts_with("-") || std::ranges::find(known, word) != known.end()) return;
  std::string meant = nearest_word(word, known);
  for (const auto& [other, ours] : synonyms)
    if (word == other) meant = ours;
  throw InputError(Fault{"mahlwerk", fmt::format("unknown command '{}'", word),
                         (meant.empty() ? "" : fmt::format("did you mean 'mahlwerk {}'? ", meant)) +
                             "mahlwerk --help lists all commands",
                         "bad-command-line"});
}

int perform(int argc, char** argv) {
  if (argc > 1) check_command(argv[1]);
  CLI::App app{
      "Mahlwerk simulates ball mills: it takes a mill, a jar and balls, and answers with what\n"
      "their collisions do. Start with:  mahlwerk run examples/01-one-ball"};
  app.name("mahlwerk");
  app.set_version_flag("--version", "mahlwerk " + std::string(version()));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 fine, 1 internal error, 2 bad input, 3 a run stopped by physics, 4 output "
      "lost, 130 interrupted.");
  Request request;
  std::vector<std::string> set;
  const Command* chosen = nullptr;
  for (const Command& command : commands) {
    CLI::App* above = command.of.empty() ? &app : app.get_subcommand(std::string(command.of));
    CLI::App* sub = above->add_subcommand(std::string(command.name), std::string(command.about));
    add_options(*sub, command, request, set);
    sub->callback([&chosen, &command] {
      if (chosen == nullptr || chosen->of != command.name) chosen = &command;
    });
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0 || !json_messages()) return app.exit(e) == 0 ? fine : bad_input;
    return tell_end(bad_input,
                    {Fault{"mahlwerk", e.what(), "see mahlwerk --help", "bad-command-line"}});
  }
  if (chosen->takes == Takes::sweep && request.target.empty())
    throw InputError(Fault{"mahlwerk sweep", "no case is named",
                           "write mahlwerk sweep case.toml, or see mahlwerk sweep --help",
                           "no-such-case"});
  for (const std::string& one : set) request.set.push_back(override_of(one));
  if (chosen->takes == Takes::shell) add_words(app, "", request.commands);
  return chosen->perform(request);
}

/// The command, and how it ended: whatever goes wrong is said.
int perform_and_tell(int argc, char** argv) try {
  return perform(argc, argv);
} catch (const InputError& e) {
  return tell_end(bad_input, e.faults());
} catch (const RunError& e) {
  return tell_end(stopped_by_physics, e.what(), {Fault{"", e.what(), "", "stopped"}});
} catch (const std::bad_alloc&) {
  return tell_end(
      bad_input,
      "there is not enough memory for this case: give fewer balls, or fewer "
      "replicates at a time (--threads)",
      {Fault{"", "there is not enough memory for this case",
             "give fewer balls, or fewer replicates at a time (--threads)", "not-enough-memory"}});
} catch (const std::exception& e) {
  const auto* system = dynamic_cast<const std::system_error*>(&e);
  if (output_failed(system != nullptr ? system->code().value() : 0))
    return fine;  // told at the end
  return tell_end(
      internal_error,
      fmt::format("internal error: {}\nPlease report this, with the case file.", e.what()),
      {Fault{"", e.what(), "report this, with the case file", "internal-error"}});
}

}  // namespace
}  // namespace mahlwerk::app

int main(int argc, char** argv) {
  using namespace mahlwerk::app;
  const std::span words(argv, static_cast<std::size_t>(argc));
  if (std::ranges::any_of(words, [](std::string_view word) { return word == "--json"; }))
    set_json_messages();
  guard_output();
  return finish_output(perform_and_tell(argc, argv));
}
