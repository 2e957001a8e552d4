// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/heat.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {
namespace {

/// Solution of y' = push - rate y after a time (hea.4).
double relax(double y, double push, double rate, double time) {
  const double z = -rate * time;
  return y * math::exp(z) + push * time * (z == 0 ? 1 : math::expm1(z) / z);
}

/// Appends the temperatures of one phase.
void append_phase(std::vector<HeatPoint>& points, const HeatNodes& nodes, const Heating& heating,
                  double ambient, double duration, double steps) {
  const HeatPoint from = points.back();
  const Temperatures start{from.balls, from.jar};
  const auto whole = static_cast<std::int64_t>(std::max(1.0, std::round(steps)));
  for (std::int64_t i = 1; i <= whole; ++i) {
    const double time = duration * static_cast<double>(i) / static_cast<double>(whole);
    const Temperatures now = temperatures_after(nodes, heating, ambient, start, time);
    points.push_back({from.time + time, now.balls, now.jar});
  }
}

}  // namespace

// Temperatures times the square root of their capacities have a symmetric matrix. A rotation
// diagonalises it into two independent modes, also for nearly equal or very small rates.
Temperatures temperatures_after(const HeatNodes& nodes, const Heating& heating, double ambient,
                                const Temperatures& start, double duration) {
  const double b = std::sqrt(nodes.balls_capacity), j = std::sqrt(nodes.jar_capacity);
  const double bb = nodes.exchange / (b * b), bj = -nodes.exchange / (b * j);
  const double jj = (nodes.exchange + nodes.cooling) / (j * j);
  const double turn = 0.5 * math::atan2(2 * bj, bb - jj), c = math::cos(turn), s = math::sin(turn);
  const double fast = 0.5 * (bb + jj + math::hypot(bb - jj, 2 * bj));
  const double product =
      bb * (nodes.cooling / (j * j));  // product of both rates, without cancellation
  const double slow = fast > 0 ? product / fast : 0;

  const double balls = b * (start.balls - ambient), jar = j * (start.jar - ambient);
  const double push_balls = heating.balls / b, push_jar = heating.jar / j;
  const double one = relax(c * balls + s * jar, c * push_balls + s * push_jar, fast, duration);
  const double two = relax(c * jar - s * balls, c * push_jar - s * push_balls, slow, duration);
  return {ambient + (c * one - s * two) / b, ambient + (s * one + c * two) / j};
}

Temperatures steady_temperatures(const HeatNodes& nodes, const Heating& heating, double ambient) {
  const auto rise = [](double power, double conductance) {
    return power > 0 ? power / conductance : 0;
  };
  const double jar = ambient + rise(heating.balls + heating.jar, nodes.cooling);
  return {jar + rise(heating.balls, nodes.exchange), jar};
}

std::vector<HeatPoint> temperature_history(const HeatNodes& nodes, const MillCycles& mill,
                                           int points) {
  const double cycle = mill.milling + mill.pause;
  const double steps = points / static_cast<double>(mill.cycles);  // points per cycle
  std::vector<HeatPoint> found{{0, mill.ambient, mill.ambient}};
  for (std::int64_t i = 0; i < mill.cycles; ++i) {
    found.back().time = cycle * static_cast<double>(i);  // avoids accumulated rounding
    append_phase(found, nodes, mill.heating(), mill.ambient, mill.milling,
                 steps * mill.milling / cycle);
    if (mill.pause > 0)
      append_phase(found, nodes, {}, mill.ambient, mill.pause, steps * mill.pause / cycle);
  }
  return found;
}

}  // namespace mahlwerk::powder
