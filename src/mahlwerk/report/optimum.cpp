// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/optimum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string text_of(const observe::Estimate& t, const std::string& unit) {
  return readable(t.mean, t.ci95, unit).text();
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Adds sentences on the location of the optimum along a key.
void describe_key(const KeyOptimum& k, const std::string& quantity, std::vector<std::string>& all) {
  if (k.flat)
    all.push_back(
        fmt::format("The optimum is flat in {}: any value from {} to {} gives {} within 2 %, with "
                    "the other keys fixed",
                    k.key, k.text.good_low, k.text.good_high, quantity));
  if (k.at_low_end || k.at_high_end)
    all.push_back(fmt::format(
        "The best {} lies at the {} end of its range, {}: a wider range may contain a better value",
        k.key, k.at_low_end ? "lower" : "upper", k.at_low_end ? k.text.from : k.text.to));
}

/// Why the search ended; empty if no setting gave an outcome.
std::string stop_sentence(const Optimum& found) {
  switch (found.stop_reason) {
    case campaign::StopReason::settings:
      return fmt::format("The search ended because the maximum of {} settings was reached",
                         found.trials.size());
    case campaign::StopReason::converged:
      return fmt::format(
          "The search ended because the expected gain of one more setting, {}, is below the noise",
          readable(found.expected_gain, NAN, found.outcome.unit).text());
    case campaign::StopReason::failed:
      break;
  }
  return "";
}

}  // namespace

std::string chance_sentence(const Optimum& found) {
  const double chance = found.trials[*found.best].probability_best;
  if (found.certain()) return "The best setting tried is distinguished from all others tried";
  if (found.trials[*found.best].invalid())
    return fmt::format(
        "By these runs the best setting tried has a probability of {} of being the best of those "
        "tried",
        percent(chance));
  return fmt::format(
      "The best setting tried has a probability of {} of being the best of those tried; if it is "
      "not, the expected loss is {}",
      percent(chance), readable(found.expected_loss, NAN, found.outcome.unit).text());
}

std::vector<std::string> validity_sentences(const Optimum& found) {
  if (!found.best) return {};
  const Trial& best = found.trials[*found.best];
  std::vector<std::string> all;
  if (best.invalid())
    all.push_back(
        fmt::format("The optimum is not certain: the runs of the best setting lie outside the "
                    "validity of their engine ({})",
                    results::warning_codes(best.notices)));
  if (!found.check) return all;
  const OptimumCheck& check = *found.check;
  if (!check.failure.empty()) {
    all.push_back(fmt::format("The best setting was not checked by the {} engine: {}",
                              name_of(check.engine), check.failure));
    return all;
  }
  all.push_back(fmt::format(
      "At the best setting the {} engine gives a {} of {} ({} replicate{}), the search gave {}: "
      "the two {}",
      name_of(check.engine), label(found.outcome.name), text_of(check.value, found.outcome.unit),
      check.replicates, check.replicates == 1 ? "" : "s",
      text_of(best.outcome(0), found.outcome.unit),
      found.disagrees() ? "disagree, and the search is unreliable there" : "agree"));
  return all;
}

std::vector<std::string> sentences(const Optimum& found) {
  std::vector<std::string> all;
  const std::string quantity = label(found.outcome.name);
  if (!found.best) {
    all.emplace_back(found.failed == static_cast<int>(found.trials.size())
                         ? "No setting that was tried could be run"
                         : "No setting that was tried is likely to satisfy the limits");
  } else {
    all = validity_sentences(found);
    all.push_back(chance_sentence(found));
    if (std::ranges::any_of(found.keys,
                            [](const KeyOptimum& k) { return k.text.model != k.text.best; }))
      all.push_back(fmt::format("The model's best, {} of {}, is a prediction: it was not run",
                                quantity, text_of(found.model_value, found.outcome.unit)));
    for (const KeyOptimum& k : found.keys) describe_key(k, quantity, all);
    for (const OptimumLimit& limit : found.limits)
      all.push_back(
          limit.binds
              ? fmt::format(
                    "The limit \"{} {}\" is active: without it the optimum would lie elsewhere",
                    label(limit.quantity), limit.text)
              : fmt::format("The limit \"{} {}\" is not active", label(limit.quantity),
                            limit.text));
  }
  if (found.failed > 0)
    all.push_back(fmt::format("{} of {} settings could not be run; their reasons are in the table",
                              found.failed, found.trials.size()));
  if (const std::string reason = stop_sentence(found); !reason.empty()) all.push_back(reason);
  return all;
}

std::string optimum_table(const Optimum& found) {
  std::string text;
  if (found.best) {
    Lines lines{{"key", "best tried", "optimum (95 % interval)", "model's optimum"}};
    for (const KeyOptimum& k : found.keys)
      lines.push_back({k.key, k.text.best, k.range_text(), k.text.model});
    text = aligned(lines) + '\n';
    const Trial& best = found.trials[*found.best];
    Lines values{
        {label(found.outcome.name), text_of(best.model, found.outcome.unit),
         fmt::format("by the model; mean of its own {} replicates: {}", best.replicates.size(),
                     text_of(best.outcome(0), found.outcome.unit))}};
    for (std::size_t i = 0; i < found.limits.size(); ++i)
      values.push_back({label(found.limits[i].quantity),
                        text_of(best.outcome(i + 1), found.limits[i].unit),
                        "limit: " + found.limits[i].text});
    text += aligned(values) + '\n';
  }
  for (const std::string& sentence : sentences(found)) text += sentence + ".\n";
  const std::string warned = notice_lines(found.notices, found.trials.size(), "setting");
  return text + fmt::format("{} settings tried, {} runs.\n{}{}", found.trials.size(), found.runs(),
                            warned.empty() ? "" : "\n", warned);
}

std::string optimum_csv(const Optimum& found) {
  std::vector<std::string> head{"setting", "round", "replicates"};
  for (const KeyOptimum& k : found.keys) head.push_back(k.key);
  for (const char* what : {"", "_ci95", "_model", "_model_ci95"})
    head.push_back(found.outcome.name + what);
  for (const OptimumLimit& limit : found.limits) {
    head.push_back(limit.quantity);
    head.push_back(limit.quantity + "_ci95");
  }
  for (const char* what : {"allowed", "chance_best", "failure", "warnings"})
    head.emplace_back(what);
  std::string text = results::csv_line(head);
  for (std::size_t i = 0; i < found.trials.size(); ++i) {
    const Trial& s = found.trials[i];
    std::vector<std::string> cells{std::to_string(i + 1), std::to_string(s.round),
                                   std::to_string(s.replicates.size())};
    for (const std::string& value : s.values)
      cells.push_back(results::csv_cell(std::string_view(value)));
    for (const observe::Estimate& t : {s.outcome(0), s.model})
      for (const double number : {t.mean, t.ci95}) cells.push_back(results::csv_cell(number));
    for (std::size_t k = 0; k < found.limits.size(); ++k) {
      const observe::Estimate t = s.outcome(k + 1);
      cells.push_back(results::csv_cell(t.mean));
      cells.push_back(results::csv_cell(t.ci95));
    }
    cells.push_back(results::csv_cell(s.probability_feasible));
    cells.push_back(results::csv_cell(s.probability_best));
    cells.push_back(results::csv_cell(std::string_view(s.failure)));
    cells.push_back(results::csv_cell(results::warning_codes(s.notices)));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
