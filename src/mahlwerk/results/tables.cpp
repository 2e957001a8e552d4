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
  Table table{{{"energy_low", "J", "lower edge of the bin, which belongs to it"},
               {"energy_high", "J", "upper edge of the bin"},
               {"rate_normal", "1/s", "collisions per second by m u_n^2/2, the normal motion"},
               {"rate_contact_point", "1/s", "by m (u_n^2 + u_t^2)/2, slip and spin included"},
               {"rate_centre", "1/s", "by the energy of the motion of the centres"},
               {"rate_lost", "1/s", "by the energy dissipated"},
               {"power_normal", "W", "the sum of those normal energies per second"},
               {"power_contact_point", "W", "the sum of those energies at contact points"},
               {"power_centre", "W", "the sum of those energies of the centres"},
               {"power_lost", "W", "the sum of what is dissipated"}},
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
  Table table{{{"speed_low", "m/s", "lower edge of the bin, which belongs to it"},
               {"speed_high", "m/s", "upper edge of the bin"},
               {"rate", "1/s", "collisions per second by their normal speed u_n"}},
              {}};
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
  Table table{{{"angle_low", "deg", "lower edge of the bin; 0 is head-on, 90 grazing"},
               {"angle_high", "deg", "upper edge of the bin"},
               {"rate", "1/s", "collisions per second by impact angle"},
               {"rate_above_threshold", "1/s", "those of at least the threshold in normal speed"}},
              {}};
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
  Table table{
      {{"time", "s", "end of the stretch, since counting began"},
       {"collision_rate", "1/s", "collisions per second"},
       {"collision_rate_above_threshold", "1/s", "those of at least the threshold in normal speed"},
       {"energy_normal_mean", "J", "mean impact energy of the normal motion"},
       {"dissipated_power", "W", "all losses per time"},
       {"drawn_power", "W", "work of the jar on the balls per time"},
       {"contact_time_share", "1", "share of the balls' time in lasting contact"},
       {"kinetic_energy", "J", "at the end of the stretch, in the laboratory frame"}},
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
  Table table{
      {{"replicate", "1", "its number, from 1"}, {"complete", "1", "1 if it ran to its end"}}, {}};
  for (std::size_t i = 0; i < outcome.replicates.size(); ++i) {
    const Replicate& r = outcome.replicates[i];
    if (!(r.time() > 0)) continue;
    const std::vector<Quantity> quantities = summarise(outcome, r);
    std::vector<double> row{static_cast<double>(i + 1), r.complete ? 1.0 : 0.0};
    for (const Quantity& q : quantities) row.push_back(q.value);
    if (table.rows.empty())
      for (const Quantity& q : quantities) table.columns.push_back({q.name, q.unit, q.about});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table balls_at_stop(const Replicate& replicate) {
  Table table{{{"ball", "1", "its number, from 1"},
               {"kind", "1", "its set in the case, from 1"},
               {"radius", "m", "radius of the ball"},
               {"x", "m", "its centre, from the jar's, in axes of the laboratory"},
               {"y", "m", "likewise"},
               {"z", "m", "likewise"},
               {"velocity_x", "m/s", "relative to the jar's centre"},
               {"velocity_y", "m/s", "likewise"},
               {"velocity_z", "m/s", "likewise"},
               {"spin_x", "rad/s", "angular velocity in axes of the laboratory"},
               {"spin_y", "rad/s", "likewise"},
               {"spin_z", "rad/s", "likewise"}},
              {}};
  double number = 0;
  for (const scene::Ball& b : replicate.at_stop)
    table.rows.push_back({++number, b.kind + 1.0, b.radius, b.position.x, b.position.y,
                          b.position.z, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x,
                          b.spin.y, b.spin.z});
  return table;
}

std::string stopped_name(int replicate) {
  return "stopped-" + std::to_string(replicate + 1);
}

}  // namespace mahlwerk::results
