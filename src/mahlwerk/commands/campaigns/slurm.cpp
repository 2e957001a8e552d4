// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A campaign on a cluster: its shards as a Slurm job array.
#include "mahlwerk/commands/campaigns/slurm.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/commands/campaigns/child_process.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

std::string shell_path(const fs::path& path) {
  return shell_word(fs::absolute(path).lexically_normal().string());
}

fs::path this_program() {
  std::error_code failed;
  const fs::path found = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path("mahlwerk") : found;
}

/// The path with "%" doubled: Slurm replaces patterns that begin with "%" in file names.
std::string slurm_path(const fs::path& path) {
  std::string text;
  for (const char c : fs::absolute(path).lexically_normal().string())
    text += c == '%' ? "%%" : std::string(1, c);
  return text;
}

/// `text` in double quotes, for an #SBATCH line.
std::string option_string(const std::string& text) {
  std::string made = "\"";
  for (const char c : text)
    made += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return made + "\"";
}

std::string more_options(const std::vector<std::string>& options) {
  std::string lines;
  for (const std::string& option : options)
    lines += fmt::format("#SBATCH {}{}\n", option.starts_with("-") ? "" : "--", option);
  return lines;
}

/// The output of a command without trailing line ends. Throws InputError if it failed.
std::string output_of(const std::string& command, const fs::path& script) {
  auto [text, exit_code] = shell_output(command);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (exit_code == 0) return text;
  const bool missing = exit_code == 127;
  throw InputError(Fault{
      "--slurm",
      missing ? "there is no sbatch on this machine" : fmt::format("sbatch refused: {}", text),
      fmt::format(
          "the script is written: submit it with sbatch {}, or start each shard with --shard i/n",
          shell_word(script.string())),
      "slurm"});
}

}  // namespace

void refuse_control(const std::string& where, const std::string& text) {
  if (has_control(text))
    throw InputError(Fault{
        where, "it contains a line end or another control character",
        "write one option for each --slurm-option, and paths without control characters", "slurm"});
}

std::string slurm_script(const SweepArguments& given, const fs::path& case_file,
                         const fs::path& place) {
  for (const std::string& option : given.slurm_options)
    refuse_control("--slurm-option " + option, option);
  refuse_control(place.string(), place.string());
  std::string set;
  for (const cases::Override& one : given.changes.overrides())
    set += " --set " + shell_word(one.key + "=" + one.value);
  if (!given.part.results.empty()) set += " --results " + given.part.results;
  const std::string environment = std::getenv("MAHLWERK_CATALOGUE") != nullptr
                                      ? fmt::format("export MAHLWERK_CATALOGUE={}\n",
                                                    shell_path(std::getenv("MAHLWERK_CATALOGUE")))
                                      : "";
  return fmt::format(
      "#!/bin/bash\n"
      "# A campaign of Mahlwerk as {0} shards. Submitting it again runs what is left.\n"
      "#SBATCH --job-name=mahlwerk\n"
      "#SBATCH --array=1-{0}\n"
      "#SBATCH --cpus-per-task={1}\n"
      "#SBATCH --output={2}\n"
      "{3}"
      "{4}"
      "exec {5} sweep {6} --out {7} --shard \"$SLURM_ARRAY_TASK_ID\"/{0} --jobs "
      "\"${{SLURM_CPUS_PER_TASK:-1}}\"{8}\n",
      given.shards, given.running.threads > 0 ? given.running.threads : 1,
      option_string(slurm_path(place) + "/slurm-%A_%a.out"), more_options(given.slurm_options),
      environment, shell_path(this_program()), shell_path(case_file), shell_path(place), set);
}

int submit_to_slurm(const SweepArguments& given, const fs::path& case_file, const fs::path& place) {
  const fs::path script = place / "campaign.slurm";
  const std::string text = slurm_script(given, case_file, place);
  campaign::prepare_folder(place);
  results::list_campaign_files(place);
  results::list_files(place, {script.filename().string()});
  results::write_whole(script, text);
  const std::string array = output_of("sbatch --parsable " + shell_path(script), script);
  const std::string job = array.substr(0, array.find(';'));
  const std::string merge =
      output_of(fmt::format("sbatch --parsable --dependency=afterany:{} --job-name=mahlwerk-merge "
                            "--output={} --wrap {}",
                            job, shell_word(slurm_path(place) + "/slurm-%j.out"),
                            shell_word(fmt::format("{} sweep merge {}", shell_path(this_program()),
                                                   shell_path(place)))),
                script);
  const std::string last = merge.substr(0, merge.find(';'));
  std::vector<std::string> said{fmt::format("slurm-{}.out", last)};
  for (int task = 1; task <= given.shards; ++task)
    said.push_back(fmt::format("slurm-{}_{}.out", job, task));
  results::list_files(place, said);  // files that Slurm will write
  if (given.running.quiet) return success;
  fmt::print("submitted {} shards as job {}; job {} merges them at the end\nscript:   {}\n",
             given.shards, job, last, script.string());
  return success;
}

}  // namespace mahlwerk::commands
