// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::array state_quantities{"dissipated_power", "collision_rate_above_threshold",
                                      "energy_normal_mean_above_threshold", "contact_time_share"};

using Line = std::array<std::string, 3>;

/// The table: heads, then a line for each quantity.
std::vector<Line> lines(const results::TwoStates& found) {
  const auto [one, other] = std::array{&found.states[0], &found.states[1]};
  const std::size_t all = one->replicates.size() + other->replicates.size();
  std::vector<Line> list{{"two states"}};
  for (std::size_t i = 0; i < 2; ++i)
    list[0][i + 1] =
        fmt::format("{} of {} replicates ({:.0f} %)", found.states[i].replicates.size(), all,
                    100 * found.share(found.states[i]));
  for (const char* name : state_quantities)
    list.push_back({label(named(one->quantities, name)),
                    readable(named(one->quantities, name)).text(),
                    readable(named(other->quantities, name)).text()});
  return list;
}

}  // namespace

std::string states_table(const results::Outcome& outcome) {
  const auto& found = outcome.summary.two_states;
  return found ? aligned(lines(*found)) + '\n' : "";
}

std::string states_section(const results::Outcome& outcome) {
  const auto& found = outcome.summary.two_states;
  if (!found) return "";
  const std::vector<Line> all = lines(*found);
  std::string rows;
  for (std::size_t i = 1; i < all.size(); ++i)
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
        escaped(all[i][0]), escaped(all[i][1]), escaped(all[i][2]));
  return fmt::format(
      "<h2>Two states</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th "
      "class=\"n\">{}</th><th class=\"n\">{}</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>"
      "\n<p><small>Replicates grouped by their dissipated power; ± is the 95 % confidence "
      "half-width over those of a state. A single normal distribution splits as clearly with a "
      "probability of {:.2g} %.</small></p>\n",
      escaped(all[0][1]), escaped(all[0][2]), rows, 100 * found->p_value);
}

}  // namespace mahlwerk::report
