// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A campaign on a cluster: its shards as a Slurm job array.
#include "mahlwerk/commands/campaigns/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/printable.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/campaign/sweep/shards.hpp"
#include "mahlwerk/commands/campaigns/child_process.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/manifest.hpp"
#include "mahlwerk/results/files/ownership.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* script_name = "campaign.slurm";
constexpr std::string_view fingerprint_option = "--case-fingerprint ";

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

/// The command that submits an array with the script. The script itself names that of the first.
std::string sbatch(const JobArray& array, const fs::path& script) {
  if (array.before == 0) return shell_path(script);
  return fmt::format("--array=1-{} {} {}", array.tasks, shell_path(script), array.before);
}

/// The number of the job that a command of sbatch submits. Throws InputError if it failed; `rest`
/// says what is left to do.
std::string submitted(const std::string& words, const std::string& rest) {
  auto [text, exit_code] = shell_output("sbatch --parsable " + words);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (exit_code == 0) return text.substr(0, text.find(';'));
  constexpr int no_such_command = 127;
  throw InputError(Fault{"--slurm",
                         exit_code == no_such_command ? "there is no sbatch on this machine"
                                                      : fmt::format("sbatch refused: {}", text),
                         rest + ", or start each shard with --shard i/n", "slurm"});
}

/// What remains to be submitted by hand from the array with this index on.
std::string left_to_submit(const std::vector<JobArray>& arrays, std::size_t from,
                           const fs::path& script) {
  std::string text = from == 0
                         ? "the script is written: submit it with "
                         : fmt::format("shards 1 to {} are submitted; submit the others with ",
                                       arrays[from].before);
  for (std::size_t i = from; i < arrays.size(); ++i)
    text += fmt::format("{}sbatch {}", i == from ? "" : " and ", sbatch(arrays[i], script));
  return text;
}

}  // namespace

void refuse_control(const std::string& where, const std::string& text) {
  if (has_control(text))
    throw InputError(Fault{
        where, "it contains a line end or another control character",
        "write one option for each --slurm-option, and paths without control characters", "slurm"});
}

int most_tasks(const std::string& configuration) {
  constexpr int usual = 1000;
  constexpr std::string_view name = "MaxArraySize";
  const std::size_t at = configuration.find(name);
  if (at == std::string::npos) return usual;
  const std::size_t digits = configuration.find_first_not_of(" \t=", at + name.size());
  int size = usual + 1;
  if (digits != std::string::npos)
    std::from_chars(configuration.data() + digits, configuration.data() + configuration.size(),
                    size);
  return size - 1;
}

std::vector<JobArray> job_arrays(int shards, int most) {
  std::vector<JobArray> arrays;
  for (int before = 0; before < shards; before += most)
    arrays.push_back({.before = before, .tasks = std::min(most, shards - before)});
  return arrays;
}

std::string slurm_script(const SweepArguments& given, const fs::path& case_file,
                         const fs::path& place, const std::string& fingerprint,
                         const std::vector<JobArray>& arrays) {
  for (const std::string& option : given.slurm_options)
    refuse_control("--slurm-option " + option, option);
  refuse_control(place.string(), place.string());
  std::string set;
  for (const cases::Override& one : given.changes.overrides())
    set += one.unset ? " --unset " + shell_word(one.key)
                     : " --set " + shell_word(one.key + "=" + one.value);
  if (!given.part.results.empty()) set += " --results " + given.part.results;
  if (given.part.films) set += " --films";
  if (given.part.checkpoint) set += fmt::format(" --checkpoint {:.6g}", *given.part.checkpoint);
  const std::string environment = std::getenv("MAHLWERK_CATALOGUE") != nullptr
                                      ? fmt::format("export MAHLWERK_CATALOGUE={}\n",
                                                    shell_path(std::getenv("MAHLWERK_CATALOGUE")))
                                      : "";
  std::string commands;
  for (const JobArray& array : arrays)
    commands += fmt::format("#     sbatch {}\n", sbatch(array, place / script_name));
  return fmt::format(
      "#!/bin/bash\n"
      "# A campaign of Mahlwerk as {0} shards. Submitting it again runs what is left, also single\n"
      "# tasks; the last shard that ends merges all. The number behind the script is that of the\n"
      "# shard before the first task of an array.\n"
      "{9}"
      "#SBATCH --job-name=mahlwerk\n"
      "#SBATCH --array=1-{10}\n"
      "#SBATCH --cpus-per-task={1}\n"
      "#SBATCH --output={2}\n"
      "{3}"
      "{4}"
      "exec {5} sweep {6} --out {7} --shard \"$((SLURM_ARRAY_TASK_ID + ${{1:-0}}))\"/{0} --merge "
      "{12}{11} --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\"{8}\n",
      given.shards, given.running.threads > 0 ? given.running.threads : 1,
      option_string(slurm_path(place) + "/slurm-%A_%a.out"), more_options(given.slurm_options),
      environment, shell_path(this_program()), shell_path(case_file), shell_path(place), set,
      commands, arrays.front().tasks, fingerprint, fingerprint_option);
}

std::string submitted_fingerprint(const fs::path& place) {
  std::ifstream file(place / script_name);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const std::size_t at = text.find(fingerprint_option);
  if (at == std::string::npos) return "";
  const std::size_t begin = at + fingerprint_option.size();
  return text.substr(begin, text.find(' ', begin) - begin);
}

int submit_to_slurm(const SweepArguments& given, const cases::Case& mill_case,
                    const fs::path& case_file, const fs::path& place) {
  const int most = most_tasks(shell_output("scontrol show config 2>/dev/null").text);
  if (most < 1)
    throw InputError(Fault{"--slurm", "this cluster has no job arrays (MaxArraySize)",
                           "start each shard as a job of its own with --shard i/n", "slurm"});
  const std::vector<JobArray> arrays = job_arrays(given.shards, most);
  const fs::path script = place / script_name;
  const std::string text =
      slurm_script(given, case_file, place, campaign::campaign_fingerprint(mill_case), arrays);
  campaign::prepare_folder(place);
  results::list_campaign_files(place);
  results::list_files(place, {script.filename().string()});
  results::write_whole(script, text);
  std::string jobs;
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const std::string job = submitted(sbatch(arrays[i], script), left_to_submit(arrays, i, script));
    jobs += (i == 0 ? "" : ":") + job;
    std::vector<std::string> said;  // files that Slurm will write
    for (int task = 1; task <= arrays[i].tasks; ++task)
      said.push_back(fmt::format("slurm-{}_{}.out", job, task));
    results::list_files(place, said);
  }
  const std::string last = submitted(
      fmt::format("--dependency=afterany:{} --job-name=mahlwerk-merge --output={} --wrap {}", jobs,
                  shell_word(slurm_path(place) + "/slurm-%j.out"),
                  shell_word(fmt::format("{} sweep merge {}", shell_path(this_program()),
                                         shell_path(place)))),
      "the shards are submitted, and the last that ends merges all: wait for it");
  results::list_files(place, {fmt::format("slurm-{}.out", last)});
  if (given.running.quiet) return success;
  std::ranges::replace(jobs, ':', ' ');
  fmt::print("submitted {} shards as {} {}; job {} merges them at the end\nscript:   {}\n",
             given.shards, arrays.size() == 1 ? "job" : "jobs", jobs, last, script.string());
  return success;
}

}  // namespace mahlwerk::commands
