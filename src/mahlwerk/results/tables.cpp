// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/tables.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::results {
namespace {

using observe::LogHistogram;
using observe::Tally;
using Chosen = std::vector<const Replicate*>;

/// First and one past the last bin that any replicate filled in any of the histograms.
template <std::size_t N>
std::array<int, 2> filled(const Chosen& chosen, const std::array<LogHistogram Tally::*, N>& parts) {
  int first = LogHistogram::bins, last = 0;
  for (const Replicate* r : chosen)
    for (const auto part : parts) {
      const auto [low, high] = (r->tally.*part).filled();
      if (low == high) continue;
      first = std::min(first, low);
      last = std::max(last, high);
    }
  return {first, last};
}

/// The first bin holds everything below its upper edge, 0 included.
double lower_edge(int bin) {
  return bin == 0 ? 0 : LogHistogram::lower(bin);
}

/// The mean over replicates of a number per second of each.
template <class Of>
double mean_rate(const Chosen& chosen, const Of& of) {
  double sum = 0;
  for (const Replicate* r : chosen) sum += of(*r) / r->time();
  return sum / static_cast<double>(chosen.size());
}

template <class Of>
double mean(const Chosen& chosen, std::size_t window, const Of& of) {
  double sum = 0, count = 0;
  for (const Replicate* r : chosen) {
    if (window >= r->windows.size()) continue;
    sum += of(r->windows[window]);
    ++count;
  }
  return sum / count;
}

}  // namespace

Table spectrum(const Outcome& outcome) {
  static constexpr std::array parts{&Tally::energy_normal, &Tally::energy_contact_point,
                                    &Tally::energy_centre, &Tally::energy_lost};
  Table table{{"energy_low_J", "energy_high_J", "rate_normal_per_s", "rate_contact_point_per_s",
               "rate_centre_per_s", "rate_lost_per_s", "power_normal_W", "power_contact_point_W",
               "power_centre_W", "power_lost_W"},
              {}};
  const Chosen chosen = averaged(outcome);
  const auto [first, last] = filled(chosen, parts);
  for (int bin = first; bin < last; ++bin) {
    std::vector<double> row{lower_edge(bin), LogHistogram::lower(bin + 1)};
    for (const auto part : parts)
      row.push_back(mean_rate(chosen, [&](const Replicate& r) {
        return static_cast<double>((r.tally.*part).count(bin));
      }));
    for (const auto part : parts)
      row.push_back(
          mean_rate(chosen, [&](const Replicate& r) { return (r.tally.*part).sum(bin); }));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table speeds(const Outcome& outcome) {
  Table table{{"speed_low_m_per_s", "speed_high_m_per_s", "rate_per_s"}, {}};
  const Chosen chosen = averaged(outcome);
  const auto [first, last] = filled(chosen, std::array{&Tally::approach});
  for (int bin = first; bin < last; ++bin)
    table.rows.push_back(
        {lower_edge(bin), LogHistogram::lower(bin + 1), mean_rate(chosen, [&](const Replicate& r) {
           return static_cast<double>(r.tally.approach.count(bin));
         })});
  return table;
}

Table angles(const Outcome& outcome) {
  Table table{{"angle_low_deg", "angle_high_deg", "rate_per_s", "rate_above_threshold_per_s"}, {}};
  const Chosen chosen = averaged(outcome);
  if (chosen.empty()) return table;
  for (std::size_t bin = 0; bin < Tally::angle_bins; ++bin) {
    const auto rate = [&](const auto part) {
      return mean_rate(
          chosen, [&](const Replicate& r) { return static_cast<double>((r.tally.*part)[bin]); });
    };
    const auto low = static_cast<double>(bin);
    table.rows.push_back({low, low + 1, rate(&Tally::angle_all), rate(&Tally::angle_above)});
  }
  return table;
}

Table time_series(const Outcome& outcome) {
  Table table{{"time_s", "collision_rate_per_s", "collision_rate_above_threshold_per_s",
               "energy_normal_mean_J", "dissipated_power_W", "drawn_power_W", "contact_time_share",
               "kinetic_energy_J"},
              {}};
  const Chosen chosen = averaged(outcome);
  double balls = 0;
  for (const cases::BallSet& set : outcome.what.balls) balls += static_cast<double>(set.count);
  std::size_t most = 0;
  for (const Replicate* r : chosen) most = std::max(most, r->windows.size());
  for (std::size_t i = 0; i < most; ++i) {
    const auto of = [&](double Window::*what) {
      return mean(chosen, i, [&](const Window& w) { return w.*what; });
    };
    const auto rate = [&](double Window::*what) {
      return mean(chosen, i, [&](const Window& w) { return w.*what / w.length; });
    };
    table.rows.push_back({of(&Window::time), rate(&Window::collisions), rate(&Window::above),
                          of(&Window::energy_normal) / of(&Window::collisions), rate(&Window::lost),
                          rate(&Window::wall_work), rate(&Window::contact_time) / balls,
                          of(&Window::kinetic)});
  }
  return table;
}

Table replicates(const Outcome& outcome) {
  Table table{{"replicate", "complete"}, {}};
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i) {
    const Replicate& r = outcome.replicates[i];
    if (!(r.time() > 0)) continue;
    const std::vector<Quantity> quantities = summarise(outcome, r);
    std::vector<double> row{static_cast<double>(i + 1), r.complete ? 1.0 : 0.0};
    for (const Quantity& q : quantities) row.push_back(q.value);
    if (table.rows.empty())
      for (const Quantity& q : quantities) table.columns.push_back(column_name(q.name, q.unit));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table balls_at_stop(const Replicate& replicate) {
  Table table{
      {"ball", "kind", "radius_m", "x_m", "y_m", "z_m", "velocity_x_m_per_s", "velocity_y_m_per_s",
       "velocity_z_m_per_s", "spin_x_rad_per_s", "spin_y_rad_per_s", "spin_z_rad_per_s"},
      {}};
  double number = 0;
  for (const scene::Ball& b : replicate.at_stop)
    table.rows.push_back({++number, b.kind + 1.0, b.radius, b.position.x, b.position.y,
                          b.position.z, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x,
                          b.spin.y, b.spin.z});
  return table;
}

std::string stopped_name(int replicate) {
  return "stopped-" + std::to_string(replicate + 1) + ".csv";
}

}  // namespace mahlwerk::results
