// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/measure/next.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/report/estimate.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

/// A value with a range, and what the range does to the energies.
struct Candidate {
  std::string key;
  std::array<std::string, 2> ends;
  std::array<double, 2> energy;  ///< at each end, over that at the value
  bool measured = false;

  double reach() const { return std::max(std::abs(energy[0] - 1), std::abs(energy[1] - 1)); }
};

constexpr double small_reach = 0.05;  // of the energy, below which others matter more

/// Energy of hits, or the part that they lose, up to a factor; none if the key has no known power.
std::optional<double> energy_by(std::string_view key, double value) {
  static constexpr std::array<std::string_view, 8> squared{
      "mill.frequency", "mill.speed",  "mill.arm",          "mill.swing",
      "mill.amplitude", "mill.radius", "mill.orbit_radius", "mill.arc_amplitude"};
  if (std::ranges::find(squared, key) != squared.end()) return value * value;
  if (key == "contact.restitution") return 1 - value * value;
  return std::nullopt;
}

void add(std::string_view key, double value, std::array<double, 2> ends,
         std::array<std::string, 2> texts, bool measured, std::vector<Candidate>& all) {
  const auto at = energy_by(key, value), low = energy_by(key, ends[0]),
             high = energy_by(key, ends[1]);
  if (!at || !(*at > 0) || std::ranges::find(all, key, &Candidate::key) != all.end()) return;
  all.push_back({std::string(key), std::move(texts), {*low / *at, *high / *at}, measured});
}

/// The same from texts of a case or entry.
void add_text(std::string_view key, const std::string& value,
              const std::array<std::string, 2>& range, std::vector<Candidate>& all) {
  if (range[0].empty()) return;
  try {
    const auto number = [](const std::string& text) { return parse_quantity(text).value; };
    add(key, number(value), {number(range[0]), number(range[1])}, range, false, all);
  } catch (const UnitError&) {  // a ratio such as 1:-2, which has no known power
  }
}

/// The measured values first: a key is added once.
std::vector<Candidate> candidates(const Measured& measured,
                                  const std::optional<cases::Case>& mill_case) {
  std::vector<Candidate> all;
  for (const measure::Finding& one : measured.found.list) {
    const double low = one.value.mean - one.value.ci95, high = one.value.mean + one.value.ci95;
    if (one.value.ci95 > 0)
      add(one.key, one.value.mean, {low, high},
          {measured_text(low, one.value, one.unit), measured_text(high, one.value, one.unit)}, true,
          all);
  }
  const auto given = [&](std::string_view key) {
    return std::ranges::any_of(measured.found.list,
                               [&](const measure::Finding& f) { return f.key == key; });
  };
  if (mill_case) {
    for (const cases::Origin& one : mill_case->origins)
      if (!given(one.key)) add_text(one.key, one.value, one.range, all);
    return all;
  }
  if (measured.entry)
    for (const auto& [key, value] : measured.entry->values)
      if (value.assumed) add_text("mill." + key, value.text, value.range, all);
  if (!given("contact.restitution"))
    add_text("contact.restitution", "0.8", {"0.3", "0.9"}, all);  // as a case assumes it
  return all;
}

std::string_view command_for(std::string_view key) {
  if (key.starts_with("mill.")) return "mahlwerk measure film";
  if (key.starts_with("jar.")) return "mahlwerk measure jar";
  return "mahlwerk measure drop";
}

}  // namespace

std::string next_by_powers(const Measured& measured, const std::optional<cases::Case>& mill_case) {
  const std::vector<Candidate> all = candidates(measured, mill_case);
  if (all.empty()) return "";
  const Candidate& widest = *std::ranges::max_element(all, {}, &Candidate::reach);
  if (widest.reach() < small_reach)
    return "Next: no value that is known to the program changes the energy of hits by more than 5 "
           "%.\n"
           "mahlwerk measure ... --case CASE --next ranks the others, such as friction, by runs.\n";
  return fmt::format(
      "Next, {} {}: between {} and {} the energy of hits changes by {:+.0f} to {:+.0f} % "
      "({}).\n",
      widest.measured ? "measure again and better" : "measure", widest.key, widest.ends[0],
      widest.ends[1], 100 * (std::min(widest.energy[0], widest.energy[1]) - 1),
      100 * (std::max(widest.energy[0], widest.energy[1]) - 1), command_for(widest.key));
}

cases::Case case_with(const MeasureOutput& given, const Measured& measured,
                      const std::vector<cases::Override>& more) {
  std::vector<cases::Override> set = given.set;
  for (const measure::Finding& one : measured.found.list)
    if (!one.key.empty())
      set.push_back({one.key, measured_text(one.value.mean, one.value, one.unit)});
  set.insert(set.end(), more.begin(), more.end());
  const std::filesystem::path file = one_case_file(given.case_target, "measure");
  try {
    cases::Case made = cases::read(file, catalogue(), set);
    if (!made.sweep.empty())
      throw InputError(Fault{file.string(), "the case has a campaign, [sweep]",
                             "give a case without it", "one-case"});
    return made;
  } catch (const InputError& e) {
    std::vector<Fault> faults = e.faults();
    for (Fault& fault : faults)
      for (const measure::Finding& one : measured.found.list)
        if (!one.key.empty() && fault.where == "--set " + one.key)
          fault.where = fmt::format("{}, with the measured {}", file.string(), one.key);
    throw InputError(std::move(faults));
  }
}

std::string next_by_runs(const MeasureOutput& given, const Measured& measured) {
  const auto with_value = [&](const std::string& key, const std::string& value) {
    return case_with(given, measured, {{key, value}});
  };
  catch_ctrl_c();
  ProgressLine line(given.running.quiet);
  campaign::RunOptions options = run_options(given.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  const cases::Case mill_case = case_with(given, measured, {{"run.sensitivity", "on"}});
  if (std::vector<Fault> wrong = campaign::run_faults(mill_case); !wrong.empty())
    throw InputError(std::move(wrong));
  results::Outcome outcome = campaign::run(mill_case, options);
  if (!stop_wanted())
    outcome.summary.sensitivity = campaign::sensitivity_to_assumed(outcome, with_value, options);
  if (stop_wanted()) return "";
  return report::estimate_words(outcome);
}

}  // namespace mahlwerk::commands
