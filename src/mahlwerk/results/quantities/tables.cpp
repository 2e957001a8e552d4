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
  Table table{{{"time", "s", "end of the time window, since counting began"},
               {"collision_rate", "1/s", "collisions per second"},
               {"collision_rate_above_threshold", "1/s",
                "collisions per second with a normal speed u_n of at least the threshold"},
               {"energy_normal_mean", "J", "mean impact energy of the normal motion"},
               {"dissipated_power", "W", "all losses per time"},
               {"drawn_power", "W", "work of the jar on the balls per time"},
               {"contact_time_share", "1", "share of the balls' time in sustained contact"},
               {"kinetic_energy", "J",
                "kinetic energy at the end of the time window, in the laboratory frame"}},
              {}};
  const Chosen chosen = averaged_replicates(outcome);
  double balls = 0;
  for (const cases::BallSet& set : outcome.mill_case.balls) balls += static_cast<double>(set.count);
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
  Table table{{{"replicate", "1", "number of the replicate, from 1"},
               {"complete", "1", "1 if it ran to its end"}},
              {}};
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

namespace {

/// The state of balls; `axes`: "in laboratory axes".
Table state_table(const std::vector<scene::Ball>& balls, const std::string& axes) {
  Table table{{{"ball", "1", "number of the ball, from 1"},
               {"kind", "1", "number of its ball set in the case, from 1"},
               {"radius", "m", "radius of the ball"},
               {"x", "m", "x of the ball's centre from the jar's centre, " + axes},
               {"y", "m", "y of the ball's centre, likewise"},
               {"z", "m", "z of the ball's centre, likewise"},
               {"velocity_x", "m/s", "x velocity relative to the jar's centre"},
               {"velocity_y", "m/s", "y velocity relative to the jar's centre"},
               {"velocity_z", "m/s", "z velocity relative to the jar's centre"},
               {"spin_x", "rad/s", "x component of the angular velocity, " + axes},
               {"spin_y", "rad/s", "y component of the angular velocity"},
               {"spin_z", "rad/s", "z component of the angular velocity"}},
              {}};
  double number = 0;
  for (const scene::Ball& b : balls)
    table.rows.push_back({++number, b.kind + 1.0, b.radius, b.position.x, b.position.y,
                          b.position.z, b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x,
                          b.spin.y, b.spin.z});
  return table;
}

}  // namespace

Table balls_at_stop(const Replicate& replicate) {
  return state_table(replicate.balls_at_stop, "in laboratory axes");
}

Table balls_at_end(const Replicate& replicate) {
  return state_table(replicate.balls_at_end,
                     "in the axes of the jar's carrier: the disc, or the laboratory");
}

Table start_state(const std::vector<cases::BallState>& state) {
  std::vector<scene::Ball> balls;
  for (const cases::BallState& b : state)
    balls.push_back({b.radius, 0, b.position, b.velocity, b.spin, b.kind});
  return state_table(balls, "in the axes of the jar's carrier: the disc, or the laboratory");
}

std::string final_name(int replicate) {
  return "final-" + std::to_string(replicate + 1);
}

std::string stopped_name(int replicate) {
  return "stopped-" + std::to_string(replicate + 1);
}

}  // namespace mahlwerk::results
