// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/tables.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace mahlwerk::results {
namespace {

using Chosen = std::vector<const Replicate*>;

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
  const Chosen chosen = averaged_replicates(outcome);
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
    const std::vector<double>& values = outcome.summary.by_replicate[i];
    std::vector<double> row{static_cast<double>(i + 1), r.complete ? 1.0 : 0.0};
    row.insert(row.end(), values.begin(), values.end());
    if (table.rows.empty())
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Quantity& q = outcome.summary.quantities[k];
        table.columns.push_back({q.name, q.unit, q.about});
      }
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
  for (const scene::Ball& b : replicate.balls_at_stop)
    table.rows.push_back({++number, b.kind + 1.0, b.radius, b.position.x, b.position.y,
                          b.position.z, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x,
                          b.spin.y, b.spin.z});
  return table;
}

std::string stopped_name(int replicate) {
  return "stopped-" + std::to_string(replicate + 1);
}

}  // namespace mahlwerk::results
