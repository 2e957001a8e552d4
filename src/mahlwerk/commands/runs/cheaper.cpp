// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/runs/cheaper.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/results/notices/warnings.hpp"

namespace mahlwerk::commands {
namespace {

constexpr double a_long_run = 60;  // [s]
/// Overlap over a ball's radius up to which a softening is proposed: half of what the laws bear.
constexpr double deepest_advised = 0.1;

/// "47 s", "12 min", "3.2 h".
std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600;
  if (seconds < 2 * minute) return two_digits(seconds) + " s";
  return seconds < 2 * hour ? two_digits(seconds / minute) + " min"
                            : two_digits(seconds / hour) + " h";
}

/// Lines on a smaller softening, as long as the overlap at the highest expected speed is advisable.
/// The cost follows the number of time steps.
std::string softenings(const cases::Case& mill_case, double now) {
  std::string lines;
  if (!cases::in_time_steps(mill_case.run.engine) || mill_case.run.time_step) return lines;
  const double step = campaign::soft_settings(mill_case).rules.time_step;
  for (const double factor : {0.1, 0.01, 0.001}) {
    cases::Case softer = mill_case;
    softer.contact.softening = factor;
    if (!(factor < mill_case.contact.softening)) continue;
    const campaign::SoftSettings settings = campaign::soft_settings(softer);
    if (settings.steps.overlap > deepest_advised) break;
    lines += fmt::format(
        "  contact.softening = {:<6} {:<8} impacts last {} times longer, overlaps of {} %{}\n",
        two_digits(factor), duration(now * step / settings.rules.time_step),
        two_digits(math::pow(mill_case.contact.softening / factor, 0.4)),
        two_digits(100 * settings.steps.overlap),
        settings.steps.overlap > results::soft_overlap ? ", with a warning" : "");
  }
  return lines;
}

/// Lines on fewer replicates.
std::string fewer_replicates(const cases::Case& mill_case, double now) {
  std::string lines;
  const std::int64_t given = mill_case.run.replicates;
  // Half of the replicates in each sense of rotation, where both senses are run.
  using Counts = std::array<std::int64_t, 2>;
  for (const std::int64_t count : cases::needs_both_senses(mill_case) ? Counts{4, 2} : Counts{3, 1})
    if (count < given)
      lines += fmt::format("  run.replicates = {:<9} {:<8} {}\n", count,
                           duration(now * static_cast<double>(count) / static_cast<double>(given)),
                           count > 1 ? "wider intervals" : "intervals from the scatter over time");
  return lines;
}

}  // namespace

std::string cheaper(const cases::Case& mill_case, double seconds) {
  if (!(seconds > a_long_run)) return "";
  const std::string lines = softenings(mill_case, seconds) + fewer_replicates(mill_case, seconds);
  return lines.empty() ? ""
                       : fmt::format("The run takes about {}. It would take\n{}", duration(seconds),
                                     lines.substr(0, lines.size() - 1));
}

}  // namespace mahlwerk::commands
