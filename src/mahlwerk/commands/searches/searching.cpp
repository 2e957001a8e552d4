// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/searches/searching.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

using campaign::DesignPoint;
using results::Json;

report::OptimumKey key_of(const campaign::SearchJob& job, const campaign::Optimum& found,
                          std::size_t key) {
  const cases::SweptKey& range = job.runs->ranges()[key];
  const campaign::KeyOptimum& k = found.keys[key];
  constexpr int digits = 4;
  const auto text = [&](double position) {
    return campaign::value_in_range(range, position, digits);
  };
  report::OptimumKey made{.key = range.key,
                          .unit = campaign::unit_of_range(range),
                          .logarithmic = range.logarithmic,
                          .from = range.values[0],
                          .to = range.values[1]};
  if (!found.model_point.empty()) {
    made.model = job.runs->values(found.model_point)[key];
    made.low = text(k.low);
    made.high = text(k.high);
    made.good_low = text(k.good_low);
    made.good_high = text(k.good_high);
  }
  if (found.best) made.best = job.runs->values(found.trials[*found.best].point)[key];
  made.model_at = k.slice;
  made.flat = k.flat;
  made.at_low_end = k.at_low_end;
  made.at_high_end = k.at_high_end;
  for (std::size_t i = 0; i < k.slice.size(); ++i) {
    const double position = static_cast<double>(i) / static_cast<double>(k.slice.size() - 1);
    const double from = campaign::number_in(range.values[0], made.unit);
    const double to = campaign::number_in(range.values[1], made.unit);
    made.x.push_back(range.logarithmic ? from * math::pow(to / from, position)
                                       : std::lerp(from, to, position));
  }
  return made;
}

report::OptimumSetting setting_of(const campaign::SearchJob& job, const campaign::Trial& tried) {
  report::OptimumSetting made{.values = job.runs->values(tried.point),
                              .round = tried.round,
                              .replicates = static_cast<int>(tried.replicates.size()),
                              .model = tried.model,
                              .probability_feasible = tried.probability_feasible,
                              .probability_best = tried.probability_best,
                              .failure = tried.failure};
  for (std::size_t i = 0; i < made.values.size(); ++i)
    made.x.push_back(campaign::number_in(made.values[i], campaign::unit_of_range(job.runs->ranges()[i])));
  made.warnings = results::warning_codes(tried.notices);
  made.invalid = tried.invalid();
  for (std::size_t i = 0; i < tried.observed.size(); ++i)
    if (i == 0)
      made.observed = tried.observed[i];
    else
      made.limit_values.push_back(tried.observed[i]);
  return made;
}

std::string stop_reason_text(const campaign::SearchJob& job, const campaign::Optimum& found) {
  switch (found.stop_reason) {
    case campaign::StopReason::settings:
      return fmt::format("The search ended because the maximum of {} settings was reached",
                         found.trials.size());
    case campaign::StopReason::converged:
      return fmt::format(
          "The search ended because the expected gain of one more setting, {}, is below the noise",
          report::readable(found.expected_gain, NAN, job.outcomes.front().unit).text());
    case campaign::StopReason::failed:
      break;
  }
  return "";
}

/// null if the best setting was not checked.
Json check_json(const report::OptimumReport& found) {
  if (!found.check) return nullptr;
  const report::OptimumCheck& check = *found.check;
  if (!check.failure.empty())
    return Json::object({{"engine", name_of(check.engine)}, {"not_checked", check.failure}});
  return Json::object({{"engine", name_of(check.engine)},
                       {"value", check.value.mean},
                       {"ci95", check.value.ci95},
                       {"replicates", check.replicates},
                       {"disagrees", found.disagrees()}});
}

}  // namespace

ResumableSearch::ResumableSearch(const std::filesystem::path& results, const char* file,
                                 std::string what)
    : runs_(results), trials_(runs_.folder() / file), what_(std::move(what)) {}

ResumableSearch::~ResumableSearch() {
  if (!removed_ && !has_trials() && !has_states()) remove();
}

bool ResumableSearch::has_trials() const {
  std::error_code none;
  return std::filesystem::exists(trials_, none);
}

bool ResumableSearch::has_states() const {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(runs_.folder(), none))
    if (entry.path().extension() == ".checkpoint") return true;
  return false;
}

int ResumableSearch::report_interrupted(const std::string& found) const {
  const bool trials = has_trials(), states = has_states();
  std::string what = trials ? what_ : "";
  if (trials && states) what += " and ";
  if (states) what += "checkpoints of the mills' own runs";
  const std::string remedy =
      what.empty() ? "run the same command again to start over"
                   : fmt::format("{} are kept in {}; run the same command again to resume", what,
                                 runs_.folder().string());
  const std::string words =
      (what.empty() ? "interrupted before any run ended: " : "interrupted: ") + found + remedy;
  return report_end(interrupted, words, {Fault{"", "interrupted", found + remedy, "interrupted"}});
}

void ResumableSearch::remove() {
  removed_ = true;  // from here on another process may own the folder
  std::error_code none;
  std::filesystem::remove(trials_, none);
  runs_.remove();
}

campaign::Optimum run_search(const Running& running, const campaign::SearchJob& job,
                             const ResumableSearch& kept) {
  ProgressLine line(running.quiet);
  const campaign::RunOptions options = run_options(running.threads);
  int settings = 0, runs = 0;
  WriteErrorReporter not_kept;
  campaign::TrialStore store(kept.trials(), job.measure_name, std::ref(not_kept));
  campaign::Optimum found = campaign::optimise(job.goal, [&](const auto& asked) {
    line.show(fmt::format("{} settings tried, {} runs", settings, runs));
    for (const campaign::TrialRequest& one : asked) {
      settings += one.first == 0 ? 1 : 0;
      runs += one.count;
    }
    return job.runs->run(asked, job.measure, options, store, version());
  });
  not_kept.repeat();
  return found;
}

void print_found(const std::string& title, const std::string& table,
                 const std::filesystem::path& place, const char* case_name, bool written) {
  to_stdout(fmt::format("{}\n\n{}\n", title, table));
  if (!written) return;
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / "fit.html").string());
  fmt::print("numbers:  {}\n", (place / "fit.json").string());
  fmt::print("case:     {}\n", (place / case_name).string());
}

report::OptimumReport report_of(const campaign::SearchJob& job, const campaign::Optimum& found) {
  const campaign::SearchOutcome& best = job.outcomes.front();
  report::OptimumReport made{.title = job.runs->base().title,
                             .case_file = job.runs->base().file,
                             .quantity = best.name,
                             .unit = best.unit,
                             .about = best.about,
                             .maximise = job.goal.maximise,
                             .best = found.best,
                             .model_value = found.model_value,
                             .expected_gain = found.expected_gain,
                             .expected_loss = found.expected_loss,
                             .failed = found.failed,
                             .stop_reason = stop_reason_text(job, found)};
  for (std::size_t key = 0; key < job.goal.keys; ++key)
    made.keys.push_back(key_of(job, found, key));
  for (std::size_t i = 0; i < job.limits.size(); ++i)
    made.limits.push_back(
        {.quantity = job.limits[i].quantity,
         .unit = job.outcomes[i + 1].unit,
         .text = (job.limits[i].below ? "below " : "above ") + job.limits[i].bound,
         .binds = found.binds[i]});
  for (const campaign::Trial& tried : found.trials) {
    made.settings.push_back(setting_of(job, tried));
    results::count(made.notices, tried.notices);
  }
  results::sort(made.notices);
  return made;
}

results::Json optimum_json(const report::OptimumReport& found, std::string_view version) {
  const auto pair = [](const observe::Estimate& t) {
    return Json::object({{"value", t.mean}, {"ci95", t.ci95}});
  };
  Json keys = Json::object(), limits = Json::array();
  for (const report::OptimumKey& k : found.keys)
    keys[k.key] = Json::object({{"best", k.best},
                                {"low", k.low},
                                {"high", k.high},
                                {"model", k.model},
                                {"good_low", k.good_low},
                                {"good_high", k.good_high},
                                {"flat", k.flat},
                                {"at_low_end", k.at_low_end},
                                {"at_high_end", k.at_high_end}});
  for (const report::OptimumLimit& limit : found.limits)
    limits.push_back(Json::object(
        {{"quantity", limit.quantity}, {"limit", limit.text}, {"binds", limit.binds}}));
  Json best;
  if (found.best) {
    const report::OptimumSetting& s = found.settings[*found.best];
    best = Json::object({{"setting", *found.best + 1},
                         {"replicates", s.replicates},
                         {"mean", pair(s.observed)},
                         {"by_model", pair(s.model)},
                         {"chance", s.probability_best},
                         {"certain", found.certain()},
                         {"valid", !s.invalid},
                         {"check", check_json(found)}});
  }
  return Json::object({{"mahlwerk", version},
                       {"title", found.title},
                       {"case", found.case_file},
                       {"quantity", found.quantity},
                       {"unit", found.unit},
                       {"maximise", found.maximise},
                       {"best", best},
                       {"keys", keys},
                       {"limits", limits},
                       {"model_value", pair(found.model_value)},
                       {"expected_gain", found.expected_gain},
                       {"expected_loss", found.expected_loss},
                       {"settings", found.settings.size()},
                       {"failed", found.failed},
                       {"runs", found.runs()},
                       {"remarks", report::sentences(found)},
                       {"notices", results::notices_json(found.notices)}});
}

}  // namespace mahlwerk::commands
