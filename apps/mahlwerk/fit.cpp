// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// fit: numbers of a case, found from what was measured of the powder.
#include "mahlwerk/campaign/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "command.hpp"
#include "compute.hpp"
#include "fit_report.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/results/files/writer.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;
using Overrides = std::vector<cases::Override>;

/// What [fit] leaves open, but for what the command line gives.
std::vector<std::string> open_keys(const fs::path& file, const Overrides& set,
                                   Overrides& anywhere) {
  std::vector<std::string> held;
  for (const auto& [key, range] : cases::fit_ranges(file))
    if (std::ranges::find(set, key, &cases::Override::key) != set.end())
      held.push_back(key);
    else
      anywhere.push_back({key, range[1]});  // so that the case can be read
  return held;
}

/// Faults of a value that stands in for one to be found are told of [fit], too; those of a
/// condition are the table's.
std::vector<Fault> told_by(std::vector<Fault> faults, const Overrides& anywhere,
                           const Overrides& condition, const std::string& data_file) {
  const auto of = [](const Fault& fault, const Overrides& set) {
    return std::ranges::any_of(
        set, [&](const cases::Override& o) { return fault.where == "--set " + o.key; });
  };
  for (Fault& fault : faults)
    if (of(fault, condition))
      fault.where = fmt::format("{}, column {}", data_file, fault.where.substr(6));
  std::vector<Fault> left = faults;
  std::erase_if(left, [&](const Fault& fault) { return of(fault, anywhere); });
  return left.empty() ? faults : left;
}

cases::Case read(const fs::path& file, const cases::Catalogue& known, const Overrides& set,
                 const Overrides& anywhere, const Overrides& condition,
                 const std::string& data_file) {
  Overrides all = set;
  all.insert(all.end(), anywhere.begin(), anywhere.end());
  all.insert(all.end(), condition.begin(), condition.end());
  try {
    return cases::read(file, known, all);
  } catch (const InputError& error) {
    throw InputError(told_by(error.faults(), anywhere, condition, data_file));
  }
}

/// The case under each condition; each asks for no more than its engine can do.
std::vector<cases::Case> under_conditions(const FitJob& job, const fs::path& file,
                                          const cases::Catalogue& known, const Overrides& set,
                                          const Overrides& anywhere) {
  std::vector<cases::Case> made;
  std::vector<Fault> wrong;
  const auto add = [&](const std::vector<Fault>& faults) {  // conditions may share them
    for (const Fault& fault : faults)
      if (std::ranges::none_of(wrong, [&](const Fault& other) {
            return other.where == fault.where && other.what == fault.what;
          }))
        wrong.push_back(fault);
  };
  for (const Overrides& condition : job.data.conditions) try {
      made.push_back(read(file, known, set, anywhere, condition, job.data_file));
      add(campaign::run_faults(made.back()));
    } catch (const InputError& error) {
      add(error.faults());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

FitJob prepare(const Request& request, const fs::path& file) {
  const cases::Catalogue known = catalogue();
  const Overrides set = overrides(request);
  Overrides anywhere;
  const std::vector<std::string> held = open_keys(file, set, anywhere);
  FitJob job;
  job.base = read(file, known, set, anywhere, {}, request.data);
  job.data_file = request.data;
  job.data = campaign::read_measurements(request.data);
  if (!job.base.sweep.empty())
    throw InputError(Fault{job.base.file, "the case has a [sweep], fit takes a single case",
                           "take the section [sweep] away; columns of the data may change the case",
                           "one-case"});
  job.numbers = campaign::free_numbers(job.base, held);
  if (auto wrong = campaign::fit_faults(job.base, job.data, job.numbers, job.data_file);
      !wrong.empty())
    throw InputError(std::move(wrong));
  job.mills = under_conditions(job, file, known, set, anywhere);
  campaign::fill_times(job.data, job.mills);
  for (std::size_t i = 0; i < job.mills.size(); ++i)
    job.mills[i] = campaign::for_fit(std::move(job.mills[i]), i, job.data, job.numbers);
  return job;
}

/// Each mill, once; what it writes besides is not wanted.
std::vector<results::Outcome> run_mills(const Request& request, const FitJob& job,
                                        const results::Folder& folder) {
  campaign::Streams streams(version());
  for (const cases::Case& mill : job.mills) streams.add(mill, folder, "");
  return compute(request, job.mills, streams, nullptr);
}

campaign::Fit find(const Request& request, const FitJob& job,
                   const std::vector<results::Outcome>& mills) {
  ProgressLine line(request.quiet);
  return campaign::fit(mills, job.data, job.numbers,
                       {.threads = request.threads, .stop = &stop_wanted(), .progress = [&](int n) {
                          line.show(fmt::format("fitting: the powder was milled {} times", n));
                        }});
}

void write(results::Folder& folder, const FitJob& job, const report::FitReport& found) {
  folder.write("fit.json", fit_json(found, version()).text(2) + '\n');
  folder.write("fit.csv", report::fit_csv(found));
  folder.write("fit.html", report::fit_page(found, version()));
  results::write_case(folder, fitted_case(job, found), "fitted.toml");
  folder.commit();
}

void tell(const report::FitReport& found, const fs::path& place) {
  to_stdout(fmt::format("{}\n\n{}\n", found.title, report::fit_table(found)));
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / "fit.html").string());
  fmt::print("numbers:  {}\n", (place / "fit.json").string());
  fmt::print("case:     {}\n", (place / "fitted.toml").string());
}

int tell_interrupted() {
  return tell_end(interrupted, "interrupted: nothing was fitted.",
                  {Fault{"", "interrupted", "nothing was fitted", "interrupted"}});
}

/// A fit needs all of its mills, to their ends.
int cut_short(const std::vector<results::Outcome>& mills) {
  if (std::ranges::all_of(mills, results::complete)) return fine;
  for (const results::Outcome& mill : mills)
    for (const results::Replicate& r : mill.replicates)
      if (!r.stopped.empty())
        return tell_end(stopped_by_physics,
                        fmt::format("stopped: {}\nNothing was fitted.", r.stopped),
                        {Fault{"", r.stopped, "nothing was fitted", "stopped"}});
  return tell_interrupted();
}

int fit(const Request& request) {
  const fs::path file = one_case_file(request.target, "fit");
  const FitJob job = prepare(request, file);
  const fs::path usual = default_place(request.target, file, false).string() + "-fit";
  results::Folder folder(request.out.value_or(usual), request.force);

  catch_ctrl_c();
  const std::vector<results::Outcome> mills = run_mills(request, job, folder);
  if (const int code = cut_short(mills); code != fine) return code;
  try {
    const campaign::Fit found = find(request, job, mills);
    const report::FitReport report = fit_report(job, mills, found);
    write(folder, job, report);
    if (request.json) json_to_stdout(fit_json(report, version()));
    if (!request.json && !request.quiet) tell(report, folder.wanted());
  } catch (const Interrupted&) {
    return tell_interrupted();
  }
  return fine;
}

}  // namespace

Command fit_command() {
  return {"fit", "find numbers of a case from what was measured of the powder, with intervals",
          joined({{one_case(),
                   {.name = "DATA",
                    .target = &Request::data,
                    .about = "a table of measurements: CSV, see docs/formats.md",
                    .required = true}},
                  changes(),
                  running(", with -fit"),
                  {json()}}),
          fit};
}

}  // namespace mahlwerk::app
