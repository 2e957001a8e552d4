// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"

// The best settings of a mill as they were looked for: terminal, table, page.
namespace mahlwerk::report {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A number with its half-width.
struct ValueCi95 {
  double value = unknown, ci95 = unknown;
};

/// A key that was changed; texts are as the case says them, "412 rpm".
struct OptimumKey {
  std::string key, unit = {};  ///< of `x`; empty: a plain number
  bool logarithmic = false;
  std::string from = {}, to = {};             ///< the range
  std::string best = {}, model = {};          ///< at the best tried, and where the model is best
  std::string low = {}, high = {};            ///< where the optimum lies, with 95 %
  std::string good_low = {}, good_high = {};  ///< this key alone moved: within 2 %
  bool flat = false, at_low_end = false, at_high_end = false;
  std::vector<double> x = {};  ///< the model through its best, this key moved alone
  std::vector<ValueCi95> model_at = {};

  /// Where the optimum lies, in words: "12 Hz to 13 Hz", "at the end of its range".
  std::string range_text() const;
};

struct OptimumLimit {
  std::string quantity, unit, text;  ///< "below 1 mg/h"
  bool binds = false;
};

/// A setting that was tried.
struct OptimumSetting {
  std::vector<std::string> values = {};  ///< by key
  std::vector<double> x = {};            ///< the same as numbers, in the keys' units
  int round = 0, replicates = 0;
  ValueCi95 observed = {}, model = {};  ///< mean of its replicates; what all settings say of it
  std::vector<ValueCi95> limit_values = {};               ///< by limit
  double probability_feasible = 1, probability_best = 0;  ///< [1]
  std::string failure = {};                               ///< why it gave nothing; empty: it did
  std::string warnings = {};                              ///< codes, separated by ";"
  bool invalid = false;  ///< outside the validity of the engine that ran it
};

/// The best setting, run by the engine that is advised there.
struct OptimumCheck {
  cases::EngineName engine = cases::EngineName::soft;
  ValueCi95 value = {};  ///< of what is to be best, by that engine
  int replicates = 0;
  std::string failure = {};  ///< why there is no value; empty: there is
};

struct OptimumReport {
  std::string title, case_file, quantity, unit, about;
  bool maximise = true;
  std::vector<OptimumKey> keys = {};
  std::vector<OptimumLimit> limits = {};
  std::vector<OptimumSetting> settings = {};
  std::optional<std::size_t> best = std::nullopt;
  ValueCi95 model_value = {};
  double expected_gain = 0, expected_loss = 0;  ///< in the quantity's unit
  int failed = 0;
  std::string stop_reason = {};                      ///< a sentence: why the search ended
  results::NoticeCounts notices = {};                ///< of the settings
  std::optional<OptimumCheck> check = std::nullopt;  ///< where the best is invalid

  int runs() const;  ///< replicates in all
  /// The best tried is told from all others, by runs that are valid.
  bool certain() const;
  /// The check and the search differ by more than their intervals.
  bool disagrees() const;
};

/// How sure it is that the best tried is the best of those tried; there must be one.
std::string chance_sentence(const OptimumReport& found);
/// Whether the best lies where its engine is valid, and what the other engine gives there.
std::vector<std::string> validity_sentences(const OptimumReport& found);
/// What is sure and what is not: sentences.
std::vector<std::string> sentences(const OptimumReport& found);

std::string optimum_table(const OptimumReport& found);  ///< for the terminal
std::string optimum_csv(const OptimumReport& found);    ///< settings.csv (docs/formats.md)
/// One page that loads nothing. `extra` comes before the settings.
std::string optimum_page(const OptimumReport& found, std::string_view version,
                         std::string_view extra = "");
/// The plots of the page by name: history, and the quantity over each key.
std::vector<Plot> optimum_plots(const OptimumReport& found);

}  // namespace mahlwerk::report
