// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/kinetics/powder_temperature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace mahlwerk::powder {
namespace {

double of_node(const Temperatures& t, PowderTemperature::Node node) {
  return node == PowderTemperature::Node::balls ? t.balls : t.jar;
}

/// [s] Less than the shorter time constant of both nodes: the trace of the matrix of rates is the
/// sum of both rates. Infinite without heat transfer.
double time_constant(const HeatNodes& n) {
  return 1 / (n.exchange / n.balls_capacity + (n.exchange + n.cooling) / n.jar_capacity);
}

/// Positive nodes and weights of the Gauss-Legendre rule with 8 points on [-1, 1].
constexpr std::array<std::array<double, 2>, 4> gauss{{{0.1834346424956498, 0.3626837833783620},
                                                      {0.5255324099163290, 0.3137066458778873},
                                                      {0.7966664774136267, 0.2223810344533745},
                                                      {0.9602898564975363, 0.1012285362903763}}};

double panel(const std::function<double(double)>& f, double from, double to) {
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (const auto& [x, weight] : gauss)
    sum += weight * (f(middle - half * x) + f(middle + half * x));
  return half * sum;
}

/// Integral from 0 to `length` of a function that changes fast over `scale` at first, and slower
/// with time.
double graded_integral(const std::function<double(double)>& f, double length, double scale) {
  constexpr double finest = 1.0 / 64, growth = 0.125;
  double sum = 0;
  for (double from = 0; from < length;) {
    const double step = std::max(std::min(0.5 * scale, finest * length), growth * from);
    const double to = std::min(from + step, length);
    sum += panel(f, from, to);
    from = to;
  }
  return sum;
}

/// Calls `visit(start temperatures, milling, length of the phase, milling time before it)` for each
/// phase until a milling `time`; ends early if it returns false. Without pauses milling is one
/// phase.
template <class Visit>
void each_phase(const PowderTemperature& t, double time, const Visit& visit) {
  const MillCycles& c = t.cycles;
  Temperatures now{c.ambient, c.ambient};
  const bool pauses = c.pause > 0;
  for (double done = 0; done < time;) {
    const double length = pauses ? std::min(c.milling, time - done) : time;
    if (!visit(now, true, length, done)) return;
    now = temperatures_after(t.nodes, c.heating(), c.ambient, now, length);
    done += length;
    if (!(done < time)) return;
    if (!visit(now, false, c.pause, done)) return;
    now = temperatures_after(t.nodes, {}, c.ambient, now, c.pause);
  }
}

}  // namespace

double PowderTemperature::at(double time) const {
  if (!from_heat) return constant;
  double found = cycles.ambient;
  each_phase(*this, time, [&](const Temperatures& start, bool milling, double length, double) {
    if (milling)
      found =
          of_node(temperatures_after(nodes, cycles.heating(), cycles.ambient, start, length), node);
    return true;
  });
  return found;
}

double PowderTemperature::integral(const std::function<double(double, bool)>& rate,
                                   double time) const {
  if (!from_heat) return rate(constant, true) * time;
  const double scale = time_constant(nodes);
  double sum = 0;
  each_phase(*this, time, [&](const Temperatures& start, bool milling, double length, double) {
    const Heating heating = milling ? cycles.heating() : Heating{};
    sum += graded_integral(
        [&](double since) {
          return rate(
              of_node(temperatures_after(nodes, heating, cycles.ambient, start, since), node),
              milling);
        },
        length, scale);
    return true;
  });
  return sum;
}

double PowderTemperature::first_time(const std::function<bool(double, double)>& reached,
                                     double horizon) const {
  constexpr int pieces = 64, halvings = 60;
  double found = std::numeric_limits<double>::infinity();
  const auto search = [&](double before, double length, const auto& temperature) {
    const auto is_reached = [&](double since) {
      return reached(temperature(since), before + since);
    };
    for (int i = 0; i <= pieces; ++i) {
      double high = length * i / pieces, low = length * std::max(i - 1, 0) / pieces;
      if (!is_reached(high)) continue;
      for (int k = 0; k < halvings && i > 0; ++k) {
        const double middle = 0.5 * (low + high);
        (is_reached(middle) ? high : low) = middle;
      }
      found = before + high;
      return false;
    }
    return true;
  };
  if (!from_heat) {
    search(0, horizon, [&](double) { return constant; });
    return found;
  }
  each_phase(
      *this, horizon, [&](const Temperatures& start, bool milling, double length, double before) {
        return !milling || search(before, length, [&](double since) {
          return of_node(temperatures_after(nodes, cycles.heating(), cycles.ambient, start, since),
                         node);
        });
      });
  return found;
}

}  // namespace mahlwerk::powder
