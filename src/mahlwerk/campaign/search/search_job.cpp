// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/search_job.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"

namespace mahlwerk::campaign {
namespace {

std::string place_of_quantity(const cases::Case& mill_case, const cases::Optimise& wanted,
                              const std::string& name) {
  const char* goal = wanted.maximise ? "optimise.maximise" : "optimise.minimise";
  return cases::location_of(mill_case, name == wanted.quantity ? goal : "optimise.limits." + name);
}

/// Known names that extend `name`: for "wear_rate" those of balls and of the jar.
std::vector<std::string> longer(const std::string& name, const std::vector<std::string>& known) {
  std::vector<std::string> found;
  for (const std::string& one : known)
    if (one.starts_with(name + "_")) found.push_back(one);
  return found;
}

/// Remedy for a quantity that the case does not have.
std::string instead_of(const std::string& name, std::vector<std::string> known,
                       const std::vector<results::MissingQuantity>& missing) {
  const auto section_of = [&](const std::string& of) {
    const auto at = std::ranges::find(missing, of, &results::MissingQuantity::name);
    return at == missing.end() ? std::string() : at->section;
  };
  if (const std::string section = section_of(name); !section.empty())
    return fmt::format("it needs {}: add that to the case", section);
  for (const results::MissingQuantity& one : missing) known.push_back(one.name);
  std::vector<std::string> meant = longer(name, known);
  if (const std::string near = nearest_word(name, known); !near.empty()) meant = {near};
  if (meant.empty()) return "choose a quantity of summary.json: docs/formats.md lists them";
  std::string words;
  for (const std::string& one : meant)
    words += fmt::format("{}\"{}\"", words.empty() ? "" : " or ", one);
  const std::string section = section_of(meant.front());
  return fmt::format("did you mean {}?{}", words,
                     section.empty() ? "" : fmt::format(" It needs {}", section));
}

/// Outcomes of a search: the objective, then the limited quantities.
std::vector<SearchOutcome> search_outcomes(const cases::Case& mill_case,
                                           const cases::Optimise& wanted) {
  const std::vector<results::Measure> known = results::measures(mill_case);
  std::vector<std::string> names{wanted.quantity}, all;
  for (const cases::Limit& limit : wanted.limits) names.push_back(limit.quantity);
  for (const results::Measure& q : known) all.push_back(q.name);
  std::vector<SearchOutcome> made;
  std::vector<Fault> wrong;
  for (const std::string& name : names) {
    const auto q = std::ranges::find(known, name, &results::Measure::name);
    if (q != known.end()) {
      made.push_back({q->name, q->unit, q->about});
      continue;
    }
    wrong.push_back({place_of_quantity(mill_case, wanted, name),
                     fmt::format("a run of this case has no quantity \"{}\"", name),
                     instead_of(name, all, results::missing_quantities(mill_case)),
                     "no-such-quantity"});
  }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

double bound_of(const cases::Case& mill_case, const cases::Limit& limit,
                const SearchOutcome& of) try {
  return parse_in(limit.bound, of.unit == "1" ? "" : of.unit);
} catch (const UnitError& error) {
  const std::string unit =
      of.unit == "1" ? "give a number without a unit" : fmt::format("give it in {}", of.unit);
  throw InputError(Fault{cases::location_of(mill_case, "optimise.limits." + limit.quantity),
                         fmt::format("the limit of {}: {}", limit.quantity, error.what()), unit,
                         "bad-limit"});
}

}  // namespace

void check_keys(const cases::Case& mill_case, const std::vector<cases::SweptKey>& over,
                std::string_view section) {
  constexpr std::size_t most = 8;
  std::vector<Fault> wrong;
  if (over.size() > most)
    wrong.push_back(
        {fmt::format("{}: {}", mill_case.file, section),
         fmt::format("{} keys are too many for a search of the best setting", over.size()),
         fmt::format("give at most {}; design = \"morris\" shows which keys matter", most),
         "too-many-keys"});
  if (!mill_case.sweep.empty())
    wrong.push_back({mill_case.file, "the case has both a [sweep] and " + std::string(section),
                     "remove the section [sweep]", "one-case"});
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

Goal goal_of(const TrialRuns& runs, std::int64_t settings, std::int64_t replicates, bool maximise) {
  return {.keys = runs.ranges().size(),
          .maximise = maximise,
          .bounds = {},
          .settings = static_cast<int>(settings),
          .replicates = static_cast<int>(replicates),
          .seed = runs.base().seed,
          .snap = [&runs](const DesignPoint& point) { return runs.snap(point); }};
}

SearchJob optimise_job(const TrialRuns& runs) {
  const cases::Case& base = runs.base();
  const cases::Optimise& wanted = *base.optimise;
  SearchJob job{.runs = &runs,
                .goal = goal_of(runs, wanted.settings, wanted.replicates, wanted.maximise),
                .outcomes = search_outcomes(base, wanted),
                .limits = wanted.limits,
                .measure = {}};
  for (std::size_t i = 0; i < wanted.limits.size(); ++i)
    job.goal.bounds.push_back({.below = wanted.limits[i].below,
                               .value = bound_of(base, wanted.limits[i], job.outcomes[i + 1])});
  std::vector<std::string> names;
  for (const SearchOutcome& j : job.outcomes) {
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

}  // namespace mahlwerk::campaign
