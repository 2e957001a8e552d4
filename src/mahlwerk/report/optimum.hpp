// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"

// Result of a search for the best settings: text for the terminal, CSV table, page.
namespace mahlwerk::report {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A key that the search varied. Texts are as in a case: "412 rpm".
struct OptimumKey {
  std::string key, unit = {};  ///< of `x`; empty: a plain number
  bool logarithmic = false;
  std::string from = {}, to = {};     ///< the range
  std::string best = {}, model = {};  ///< at the best setting tried, and at the model's optimum
  std::string low = {}, high = {};    ///< 95 % interval of the optimum's location
  std::string good_low = {}, good_high = {};  ///< this key varied alone: value within 2 %
  bool flat = false, at_low_end = false, at_high_end = false;
  std::vector<double> x = {};  ///< slice of the model through its optimum along this key
  std::vector<observe::Estimate> model_at = {};

  /// Location of the optimum as text: "12 Hz to 13 Hz", "at the end of its range".
  std::string range_text() const;
};

struct OptimumLimit {
  std::string quantity, unit, text;  ///< "below 1 mg/h"
  bool binds = false;
};

/// A setting that the search ran.
struct OptimumSetting {
  std::vector<std::string> values = {};  ///< for each key
  std::vector<double> x = {};            ///< the same as numbers, in the keys' units
  int round = 0, replicates = 0;
  observe::Estimate observed = {},
                    model = {};  ///< mean of its replicates; model prediction from all settings
  std::vector<observe::Estimate> limit_values = {};       ///< for each limit
  double probability_feasible = 1, probability_best = 0;  ///< [1]
  std::string failure = {};                               ///< reason of the failure; empty: none
  std::string warnings = {};                              ///< codes, separated by ";"
  bool invalid = false;  ///< outside the validity of the engine that ran it
};

/// The best setting, run with the recommended engine.
struct OptimumCheck {
  cases::EngineName engine = cases::EngineName::soft;
  observe::Estimate value = {};  ///< of the optimised quantity, by that engine
  int replicates = 0;
  std::string failure = {};  ///< reason why there is no value; empty: there is one
};

struct OptimumReport {
  std::string title, case_file, quantity, unit, about;
  bool maximise = true;
  std::vector<OptimumKey> keys = {};
  std::vector<OptimumLimit> limits = {};
  std::vector<OptimumSetting> settings = {};
  std::optional<std::size_t> best = std::nullopt;
  observe::Estimate model_value = {};
  double expected_gain = 0, expected_loss = 0;  ///< in the quantity's unit
  int failed = 0;
  std::string stop_reason = {};                      ///< sentence: why the search ended
  results::NoticeCounts notices = {};                ///< of the settings
  std::optional<OptimumCheck> check = std::nullopt;  ///< if the event engine ran the best

  int runs() const;  ///< total number of replicates
  /// Whether the best setting tried is distinguished from all others, by valid runs.
  bool certain() const;
  /// Whether check and search differ by more than their intervals.
  bool disagrees() const;
};

/// Probability that the best setting tried is the best of those tried, as a sentence. Requires
/// `found.best`.
std::string chance_sentence(const OptimumReport& found);
/// Sentences on the validity of the best setting's runs and the result of the check; empty if they
/// are valid.
std::vector<std::string> validity_sentences(const OptimumReport& found);
/// Sentences on the certainty of the result.
std::vector<std::string> sentences(const OptimumReport& found);

std::string optimum_table(const OptimumReport& found);  ///< for the terminal
std::string optimum_csv(const OptimumReport& found);    ///< settings.csv (docs/formats.md)
/// A self-contained page. `extra` (HTML) comes before the settings.
std::string optimum_page(const OptimumReport& found, std::string_view version,
                         std::string_view extra = "");
/// The plots of the page: history, then the quantity over each key.
std::vector<Plot> optimum_plots(const OptimumReport& found);

}  // namespace mahlwerk::report
