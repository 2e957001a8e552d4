// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A campaign on a cluster: its shards as a job array of Slurm.
#include "slurm.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <memory>

#include "campaign_folder.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/results/folder.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// As one word of a shell, whatever stands in it.
std::string shell_word(std::string_view text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string shell_path(const fs::path& path) {
  return shell_word(fs::absolute(path).lexically_normal().string());
}

fs::path this_program() {
  std::error_code failed;
  const fs::path found = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path("mahlwerk") : found;
}

std::string more_options(const Request& request) {
  std::string lines;
  for (const std::string& option : request.slurm_options)
    lines += fmt::format("#SBATCH {}{}\n", option.starts_with("-") ? "" : "--", option);
  return lines;
}

/// What a command printed, without the end of its line; throws InputError if it failed.
std::string said_by(const std::string& command, const fs::path& script) {
  struct Close {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  std::unique_ptr<std::FILE, Close> pipe(popen((command + " 2>&1").c_str(), "r"));
  std::string text;
  for (int c; pipe && (c = std::fgetc(pipe.get())) != EOF;) text += static_cast<char>(c);
  const int status = pipe ? pclose(pipe.release()) : -1;
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (status == 0) return text;
  const bool missing = WIFEXITED(status) && WEXITSTATUS(status) == 127;
  throw InputError(Fault{
      "--slurm",
      missing ? "there is no sbatch on this machine" : fmt::format("sbatch refused: {}", text),
      fmt::format("the script is written: submit it yourself with sbatch {}, or "
                  "start each shard with --shard i/n",
                  script.string()),
      "slurm"});
}

}  // namespace

std::string slurm_script(const Request& request, const fs::path& case_file, const fs::path& place) {
  std::string set;
  for (const cases::Override& one : overrides(request))
    set += " --set " + shell_word(one.key + "=" + one.value);
  if (!request.results.empty()) set += " --results " + request.results;
  const std::string environment = std::getenv("MAHLWERK_CATALOGUE") != nullptr
                                      ? fmt::format("export MAHLWERK_CATALOGUE={}\n",
                                                    shell_path(std::getenv("MAHLWERK_CATALOGUE")))
                                      : "";
  return fmt::format(
      "#!/bin/bash\n"
      "# A campaign of Mahlwerk as {0} shards. Submitting it again does what is left.\n"
      "#SBATCH --job-name=mahlwerk\n"
      "#SBATCH --array=1-{0}\n"
      "#SBATCH --cpus-per-task={1}\n"
      "#SBATCH --output=\"{2}/slurm-%A_%a.out\"\n"
      "{3}"
      "{4}"
      "exec {5} sweep {6} --out {7} --shard \"$SLURM_ARRAY_TASK_ID\"/{0} --jobs "
      "\"${{SLURM_CPUS_PER_TASK:-1}}\"{8}\n",
      request.slurm, request.threads > 0 ? request.threads : 1,
      fs::absolute(place).lexically_normal().string(), more_options(request), environment,
      shell_path(this_program()), shell_path(case_file), shell_path(place), set);
}

int submit_to_slurm(const Request& request, const fs::path& case_file, const fs::path& place) {
  prepare_place(place);
  const fs::path script = place / "campaign.slurm";
  results::write_text(script, slurm_script(request, case_file, place));
  const std::string array = said_by("sbatch --parsable " + shell_path(script), script);
  const std::string job = array.substr(0, array.find(';'));
  const std::string merge =
      said_by(fmt::format("sbatch --parsable --dependency=afterany:{} --job-name=mahlwerk-merge "
                          "--output={} --wrap {}",
                          job, shell_word(fs::absolute(place).string() + "/slurm-%j.out"),
                          shell_word(fmt::format("{} sweep merge {}", shell_path(this_program()),
                                                 shell_path(place)))),
              script);
  if (request.quiet) return fine;
  fmt::print("submitted {} shards as job {}; job {} joins them at the end\nscript:   {}\n",
             request.slurm, job, merge.substr(0, merge.find(';')), script.string());
  return fine;
}

}  // namespace mahlwerk::app
