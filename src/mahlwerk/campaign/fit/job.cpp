// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;
using Overrides = std::vector<cases::Override>;

/// Gives the free parameters of [fit] a value in `anywhere`; returns those that the command line
/// fixes.
std::vector<std::string> open_keys(const fs::path& file, const Overrides& set,
                                   Overrides& anywhere) {
  std::vector<std::string> held;
  for (const auto& [key, range] : cases::fit_ranges(file))
    if (cases::gives_value(set, key))
      held.push_back(key);
    else
      anywhere.push_back({key, range[1]});  // so that the case can be read
  return held;
}

/// Leaves out faults of the values in `anywhere` if there are others: [fit] has such faults, too.
/// Faults of a condition become those of the table.
std::vector<Fault> faults_to_show(std::vector<Fault> faults, const Overrides& anywhere,
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
    throw InputError(faults_to_show(error.faults(), anywhere, condition, data_file));
  }
}

/// The case under each condition. Throws InputError with all faults, including those of the engine.
std::vector<cases::Case> under_conditions(const FitJob& job, const fs::path& file,
                                          const cases::Catalogue& known, const Overrides& set,
                                          const Overrides& anywhere) {
  std::vector<cases::Case> made;
  std::vector<Fault> wrong;
  const auto add = [&](const std::vector<Fault>& faults) {  // each fault once
    for (const Fault& fault : faults)
      if (std::ranges::none_of(wrong, [&](const Fault& other) {
            return other.where == fault.where && other.what == fault.what;
          }))
        wrong.push_back(fault);
  };
  for (const Overrides& condition : job.data.conditions) try {
      made.push_back(read(file, known, set, anywhere, condition, job.data_file));
      add(run_faults(made.back()));
    } catch (const InputError& error) {
      add(error.faults());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

}  // namespace

FitJob fit_job(const fs::path& file, const std::string& data_file, const cases::Catalogue& known,
               const Overrides& set) {
  Overrides anywhere;
  const std::vector<std::string> held = open_keys(file, set, anywhere);
  FitJob job;
  job.base = read(file, known, set, anywhere, {}, data_file);
  job.data_file = data_file;
  job.data = read_measurements(data_file, run_quantities(job.base));
  if (!job.base.sweep.empty())
    throw InputError(Fault{
        job.base.file, "the case has a [sweep], but fit takes a single case",
        "remove the section [sweep]; columns of the data can vary keys of the case", "one-case"});
  job.parameters = free_parameters(job.base, held);
  if (auto wrong = fit_faults(job.base, job.data, job.parameters, job.data_file); !wrong.empty())
    throw InputError(std::move(wrong));
  job.mills = under_conditions(job, file, known, set, anywhere);
  fill_times(job.data, job.mills);
  for (std::size_t i = 0; i < job.mills.size(); ++i)
    job.mills[i] = case_for_fit(std::move(job.mills[i]), i, job.data, job.parameters);
  return job;
}

}  // namespace mahlwerk::campaign
