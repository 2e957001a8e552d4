// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reference/estimate_text.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/engine_choice.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/settling.hpp"

namespace mahlwerk::commands {
namespace {

/// [s]
double time_to_count(cases::Case mill_case) {
  constexpr double most_cost = 30;  // [s] of a core
  const double period = cases::mill_period(mill_case);
  const double usual = std::isfinite(period) ? std::clamp(100 * period, 1.0, 3.0) : 1.0,
               least = std::isfinite(period) ? 3 * period : 0.1;
  mill_case.run.time = usual;
  const double cost =
      campaign::soft_work(mill_case) * campaign::ball_step_cost *
      static_cast<double>(mill_case.run.replicates) *
      (1 + campaign::assumed_values_cost(mill_case, cases::least_settling(mill_case)));
  return std::max(usual * std::min(1.0, most_cost / cost), least);
}

}  // namespace

std::string estimate_text(const EstimateWords& words, const cases::Catalogue& catalogue,
                          const CaseReader& read) {
  const double time = time_to_count(read(estimate_case(words, catalogue, "1 s")));
  return estimate_case(words, catalogue, show_rounded(time, "s", 2));
}

std::string saved_estimate(const std::string& text, const std::string& set) {
  std::string comment = set.empty() ? "" : "# The estimate had also:" + set;
  std::ranges::replace(comment, '\n', ' ');
  return "# A case by `mahlwerk estimate`; `mahlwerk check` shows every value that it assumes.\n" +
         comment + '\n' + text;
}

}  // namespace mahlwerk::commands
