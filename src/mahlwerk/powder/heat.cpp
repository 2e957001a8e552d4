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
                  double ambient, bool milling, double duration, double steps) {
  const HeatPoint from = points.back();
  const Temperatures start{from.balls, from.jar};
  const auto whole = static_cast<std::int64_t>(std::max(1.0, std::round(steps)));
  for (std::int64_t i = 1; i <= whole; ++i) {
    const double time = duration * static_cast<double>(i) / static_cast<double>(whole);
    const Temperatures now = temperatures_after(nodes, heating, ambient, start, time);
    points.push_back({from.time + time, now.balls, now.jar, milling});
  }
}

}  // namespace

namespace {

/// Temperatures times the square root of their capacities have a symmetric matrix. A rotation
/// diagonalises it into two independent modes, also for nearly equal or very small rates.
struct HeatModes {
  double b, j;        // square roots of the capacities
  double cos, sin;    // of the rotation
  double fast, slow;  // rates

  explicit HeatModes(const HeatNodes& nodes)
      : b(std::sqrt(nodes.balls_capacity)), j(std::sqrt(nodes.jar_capacity)) {
    const double bb = nodes.exchange / (b * b), bj = -nodes.exchange / (b * j);
    const double jj = (nodes.exchange + nodes.cooling) / (j * j);
    const double turn = 0.5 * math::atan2(2 * bj, bb - jj);
    cos = math::cos(turn);
    sin = math::sin(turn);
    fast = 0.5 * (bb + jj + math::hypot(bb - jj, 2 * bj));
    const double product =
        bb * (nodes.cooling / (j * j));  // product of both rates, without cancellation
    slow = fast > 0 ? product / fast : 0;
  }

  /// Amplitudes of the fast and the slow mode.
  struct Amplitudes {
    double fast, slow;
  };
  Amplitudes of(double balls, double jar) const {
    return {cos * balls + sin * jar, cos * jar - sin * balls};
  }
  Amplitudes of_temperatures(const Temperatures& t, double ambient) const {
    return of(b * (t.balls - ambient), j * (t.jar - ambient));
  }
  Amplitudes of_heating(const Heating& heating) const {
    return of(heating.balls / b, heating.jar / j);
  }
  Temperatures temperatures(const Amplitudes& y, double ambient) const {
    return {ambient + (cos * y.fast - sin * y.slow) / b,
            ambient + (sin * y.fast + cos * y.slow) / j};
  }
};

/// (exp(z) - 1)/z
double phi(double z) {
  return z == 0 ? 1 : math::expm1(z) / z;
}

/// What a sensor of time constant 1/x, in units of the duration, shows of exp(-m u) at u = 1 if it
/// showed 0 at u = 0: (exp(-m) - exp(-x))/(1 - m/x), also for equal m and x.
double lagged_decay(double m, double x) {
  return x * math::exp(-std::min(m, x)) * phi(-std::abs(x - m));
}

/// The same of a mode y' = push - rate y.
double lagged_mode(double y, double push, double rate, double time, double lag) {
  constexpr double small = 1e-5;
  const double m = rate * time, x = time / lag;
  const double first = 1 - phi(-x), second = x < small ? x / 3 : 1 - 2 * first / x;
  const double rise = m > small ? (lagged_decay(0, x) - lagged_decay(m, x)) / m
                                : first - 0.5 * m * second;  // its expansion
  return y * lagged_decay(m, x) + push * time * rise;
}

}  // namespace

Temperatures temperatures_after(const HeatNodes& nodes, const Heating& heating, double ambient,
                                const Temperatures& start, double duration) {
  const HeatModes modes(nodes);
  const HeatModes::Amplitudes y = modes.of_temperatures(start, ambient),
                              push = modes.of_heating(heating);
  return modes.temperatures({relax(y.fast, push.fast, modes.fast, duration),
                             relax(y.slow, push.slow, modes.slow, duration)},
                            ambient);
}

double reading_after(const Thermocouple& sensor, const HeatNodes& nodes, const Heating& heating,
                     double ambient, const Temperatures& start, double reading, double duration) {
  if (duration == 0) return reading;
  if (sensor.lag == 0)
    return sensor.around(temperatures_after(nodes, heating, ambient, start, duration));
  const HeatModes modes(nodes);
  const HeatModes::Amplitudes y = modes.of_temperatures(start, ambient),
                              push = modes.of_heating(heating);
  const double lag = sensor.lag;
  const Temperatures followed =
      modes.temperatures({lagged_mode(y.fast, push.fast, modes.fast, duration, lag),
                          lagged_mode(y.slow, push.slow, modes.slow, duration, lag)},
                         0);
  return ambient + sensor.around(followed) + (reading - ambient) * math::exp(-duration / lag);
}

double share_of_balls_in_gas(double balls_area, double wall_area) {
  return balls_area / (balls_area + wall_area);
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
  std::vector<HeatPoint> found{{0, mill.ambient, mill.ambient, false}};
  for (std::int64_t i = 0; i < mill.cycles; ++i) {
    found.back().time = cycle * static_cast<double>(i);  // avoids accumulated rounding
    append_phase(found, nodes, mill.heating(), mill.ambient, true, mill.milling,
                 steps * mill.milling / cycle);
    if (mill.pause > 0)
      append_phase(found, nodes, {}, mill.ambient, false, mill.pause, steps * mill.pause / cycle);
  }
  return found;
}

}  // namespace mahlwerk::powder
