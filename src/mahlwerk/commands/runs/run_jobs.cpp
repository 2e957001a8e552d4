// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/runs/run_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/forecast.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reference/case_template.hpp"

namespace mahlwerk::commands {

namespace fs = std::filesystem;

fs::path lammps_root(const std::vector<RunJob>& jobs) {
  const auto plain = std::ranges::count_if(jobs, [](const RunJob& job) { return !job.sweeps(); });
  fs::path place = jobs.front().place;
  if (!place.has_filename()) place = place.parent_path();  // "out/"
  if (plain > 1) place = place.parent_path();
  return place.string() + ".lammps";
}

std::vector<cases::Case> cases_of(const std::vector<RunJob>& jobs) {
  std::vector<cases::Case> found;
  for (const RunJob& job : jobs) found.push_back(job.mill_case);
  return found;
}

namespace {

RunJob prepare_run(const RunArguments& given, cases::CaseFile source, const fs::path& file,
                   bool several, const cases::Catalogue& catalogue) {
  const auto& out = given.running.out;
  RunJob job{.source = std::move(source),
             .mill_case = {},
             .file = file,
             .place = !out      ? default_folder(given.target, file, several)
                      : several ? *out / file.stem()
                                : *out,
             .folder = nullptr};
  job.mill_case = job.source.read(catalogue, given.overrides());
  if (job.sweeps()) return job;
  if (std::vector<Fault> wrong = campaign::run_faults(cases::of_one_run(job.mill_case));
      !wrong.empty())
    throw InputError(std::move(wrong));
  if (given.lammps.writes_only() || job.evolves()) return job;
  job.folder =
      std::make_unique<results::Folder>(job.place, given.running.force || given.lammps.resume);
  job.folder->reserve();
  return job;
}

/// The cases without [sweep].
std::vector<cases::Case> plain_cases(const std::vector<RunJob>& jobs) {
  std::vector<cases::Case> found;
  for (const RunJob& job : jobs)
    if (!job.sweeps()) found.push_back(job.mill_case);
  return found;
}

/// The run of a mill that is given by its name alone, with the jar, the balls and the speed that
/// `mahlwerk new` proposes. It varies all assumed values.
RunJob prepare_mill(const RunArguments& given, const std::string& mill,
                    const cases::Catalogue& known) {
  CaseParts parts;
  parts.mill = mill;
  complete(parts, known);
  const std::string text = case_template(parts, known);
  RunArguments with_band = given;
  with_band.changes.set.insert(with_band.changes.set.begin(), {"run.sensitivity", "on"});
  RunJob job =
      prepare_run(with_band, cases::CaseFile(text, mill + ".toml"), mill + ".toml", false, known);
  job.mill_case.remarks.push_back(warning(
      "proposed-case",
      fmt::format("Only the mill is given. Its jar, balls and speed are those that `mahlwerk new "
                  "--mill {} FILE` writes, not yours: change them there, or use `mahlwerk "
                  "estimate`.",
                  mill)));
  return job;
}

}  // namespace

std::vector<RunJob> prepare_all(const RunArguments& given) {
  const cases::Catalogue known = catalogue();
  std::vector<RunJob> jobs;
  std::vector<Fault> wrong;
  if (const std::string mill = mill_named(given.target); !mill.empty()) {
    jobs.push_back(prepare_mill(given, mill, known));
  } else {
    const std::vector<fs::path> files = case_files(given.target);
    for (const fs::path& file : files) try {
        jobs.push_back(prepare_run(given, cases::CaseFile(file), file, files.size() > 1, known));
      } catch (const InputError& e) {
        wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
      }
  }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  if (!given.lammps.writes_only()) campaign::check_disk(plain_cases(jobs), jobs.front().place);
  check_lammps(given.lammps, given.running.force, cases_of(jobs), lammps_root(jobs));
  return jobs;
}

}  // namespace mahlwerk::commands
