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

constexpr double clearly_best = 0.995;  // probability of being the best setting tried

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

/// Adds sentences on the location of the optimum along a key.
void describe_key(const OptimumKey& k, const std::string& quantity, std::vector<std::string>& all) {
  if (k.flat)
    all.push_back(
        fmt::format("The optimum is flat in {}: any value from {} to {} gives {} within 2 %, with "
                    "the other keys fixed",
                    k.key, k.good_low, k.good_high, quantity));
  if (k.at_low_end || k.at_high_end)
    all.push_back(fmt::format(
        "The best {} lies at the {} end of its range, {}: a wider range may contain a better value",
        k.key, k.at_low_end ? "lower" : "upper", k.at_low_end ? k.from : k.to));
}

}  // namespace

std::string OptimumKey::range_text() const {
  if (low != high) return fmt::format("{} to {}", low, high);
  return at_low_end || at_high_end ? "at the end of its range" : low;
}

bool OptimumReport::certain() const {
  return best && settings[*best].probability_best > clearly_best && !settings[*best].invalid;
}

bool OptimumReport::disagrees() const {
  if (!best || !check || !check->failure.empty()) return false;
  const observe::Estimate &found = settings[*best].observed, &other = check->value;
  const double apart = std::abs(found.mean - other.mean);
  if (std::isfinite(found.ci95) && std::isfinite(other.ci95))
    return apart > found.ci95 + other.ci95;
  constexpr double much = 0.1;  // of the value, if there is no interval
  return apart > much * std::abs(other.mean);
}

std::string chance_sentence(const OptimumReport& found) {
  const double chance = found.settings[*found.best].probability_best;
  if (found.certain()) return "The best setting tried is distinguished from all others tried";
  if (found.settings[*found.best].invalid)
    return fmt::format(
        "By these runs the best setting tried has a probability of {} of being the best of those "
        "tried",
        percent(chance));
  return fmt::format(
      "The best setting tried has a probability of {} of being the best of those tried; if it is "
      "not, the expected loss is {}",
      percent(chance), readable(found.expected_loss, NAN, found.unit).text());
}

std::vector<std::string> validity_sentences(const OptimumReport& found) {
  if (!found.best) return {};
  const OptimumSetting& best = found.settings[*found.best];
  std::vector<std::string> all;
  if (best.invalid)
    all.push_back(
        fmt::format("The optimum is not certain: the runs of the best setting lie outside the "
                    "validity of their engine ({})",
                    best.warnings));
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
      name_of(check.engine), label(found.quantity), text_of(check.value, found.unit),
      check.replicates, check.replicates == 1 ? "" : "s", text_of(best.observed, found.unit),
      found.disagrees() ? "disagree, and the search is unreliable there" : "agree"));
  return all;
}

int OptimumReport::runs() const {
  int sum = 0;
  for (const OptimumSetting& s : settings) sum += s.replicates;
  return sum;
}

std::vector<std::string> sentences(const OptimumReport& found) {
  std::vector<std::string> all;
  const std::string quantity = label(found.quantity);
  if (!found.best) {
    all.emplace_back(found.failed == static_cast<int>(found.settings.size())
                         ? "No setting that was tried could be run"
                         : "No setting that was tried is likely to satisfy the limits");
  } else {
    all = validity_sentences(found);
    all.push_back(chance_sentence(found));
    if (std::ranges::any_of(found.keys, [](const OptimumKey& k) { return k.model != k.best; }))
      all.push_back(fmt::format("The model's best, {} of {}, is a prediction: it was not run",
                                quantity, text_of(found.model_value, found.unit)));
    for (const OptimumKey& k : found.keys) describe_key(k, quantity, all);
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
                              found.failed, found.settings.size()));
  if (!found.stop_reason.empty()) all.push_back(found.stop_reason);
  return all;
}

std::string optimum_table(const OptimumReport& found) {
  std::string text;
  if (found.best) {
    Lines lines{{"key", "best tried", "optimum (95 % interval)", "model's optimum"}};
    for (const OptimumKey& k : found.keys)
      lines.push_back({k.key, k.best, k.range_text(), k.model});
    text = aligned(lines) + '\n';
    const OptimumSetting& best = found.settings[*found.best];
    Lines values{{label(found.quantity), text_of(best.model, found.unit),
                  fmt::format("by the model; mean of its own {} replicates: {}", best.replicates,
                              text_of(best.observed, found.unit))}};
    for (std::size_t i = 0; i < found.limits.size(); ++i)
      values.push_back({label(found.limits[i].quantity),
                        text_of(best.limit_values[i], found.limits[i].unit),
                        "limit: " + found.limits[i].text});
    text += aligned(values) + '\n';
  }
  for (const std::string& sentence : sentences(found)) text += sentence + ".\n";
  const std::string warned = notice_lines(found.notices, found.settings.size(), "setting");
  return text + fmt::format("{} settings tried, {} runs.\n{}{}", found.settings.size(),
                            found.runs(), warned.empty() ? "" : "\n", warned);
}

std::string optimum_csv(const OptimumReport& found) {
  std::vector<std::string> head{"setting", "round", "replicates"};
  for (const OptimumKey& k : found.keys) head.push_back(k.key);
  for (const char* what : {"", "_ci95", "_model", "_model_ci95"})
    head.push_back(found.quantity + what);
  for (const OptimumLimit& limit : found.limits) {
    head.push_back(limit.quantity);
    head.push_back(limit.quantity + "_ci95");
  }
  for (const char* what : {"allowed", "chance_best", "failure", "warnings"})
    head.emplace_back(what);
  std::string text = results::csv_line(head);
  for (std::size_t i = 0; i < found.settings.size(); ++i) {
    const OptimumSetting& s = found.settings[i];
    std::vector<std::string> cells{std::to_string(i + 1), std::to_string(s.round),
                                   std::to_string(s.replicates)};
    for (const std::string& value : s.values)
      cells.push_back(results::csv_cell(std::string_view(value)));
    for (const observe::Estimate& t : {s.observed, s.model})
      for (const double number : {t.mean, t.ci95}) cells.push_back(results::csv_cell(number));
    for (std::size_t k = 0; k < found.limits.size(); ++k) {
      const observe::Estimate t =
          k < s.limit_values.size() ? s.limit_values[k] : observe::Estimate{};
      cells.push_back(results::csv_cell(t.mean));
      cells.push_back(results::csv_cell(t.ci95));
    }
    cells.push_back(results::csv_cell(s.probability_feasible));
    cells.push_back(results::csv_cell(s.probability_best));
    cells.push_back(results::csv_cell(std::string_view(s.failure)));
    cells.push_back(results::csv_cell(std::string_view(s.warnings)));
    text += results::csv_line(cells);
  }
  return text;
}

}  // namespace mahlwerk::report
