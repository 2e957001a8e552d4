// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "mahlwerk/powder/heat.hpp"

namespace mahlwerk::powder {

/// Temperature of the powder over the milling time: a constant, or that of a node of the lumped
/// thermal model. Cycles of milling and pause repeat without end; milling time stands still in
/// pauses.
struct PowderTemperature {
  enum class Node { balls, jar };
  bool from_heat = false;  ///< whether the thermal model gives it
  double constant = 0;     ///< [K] > 0 otherwise
  HeatNodes nodes = {};
  MillCycles cycles = {};
  Node node = Node::balls;

  /// [K] Temperature after a milling `time` [s] >= 0, with the mill running.
  double at(double time) const;
  /// Integral over the clock of `rate(T [K], milling)` until a milling `time` [s] >= 0, with the
  /// pauses before it (rea.7). Gauss-Legendre quadrature on panels that grow with the time since
  /// the mill was switched on or off; relative error below 1e-9 for rates by (rea.6).
  double integral(const std::function<double(double, bool)>& rate, double time) const;
  /// [s] The first milling time until `horizon` [s] at which `reached(T [K], milling time)` is
  /// true, if it stays true in the cycle that it begins in; infinite if there is none.
  double first_time(const std::function<bool(double, double)>& reached, double horizon) const;
};

}  // namespace mahlwerk::powder
