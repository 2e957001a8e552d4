// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/fit/least_squares.hpp"

namespace mahlwerk::campaign {

/// The value of a parameter from its position, 0 to 1 across its range (fit.2), and back.
double value_at(const FreeParameter& p, double position);
double position_of(const FreeParameter& p, double value);

/// A set of parameters, as positions, with its residuals.
struct Evaluation {
  std::vector<double> position, residuals;
  double sum = std::numeric_limits<double>::infinity();  ///< of squares (fit.1)
};

/// Minimises the sum of squares, and keeps every position that it has evaluated. Holds references
/// to its arguments.
class Minimiser {
 public:
  Minimiser(const Residuals& residuals, const std::vector<FreeParameter>& parameters)
      : residuals_(residuals), parameters_(parameters) {}

  std::size_t count() const { return parameters_.size(); }
  const std::vector<Evaluation>& evaluations() const {
    return evaluations_;
  }  ///< without residuals

  Evaluation evaluate(const std::vector<double>& position);

  /// Derivatives of the residuals by each position except that of `fixed`: from both sides if
  /// `fine`; zero where no neighbour has residuals.
  std::vector<std::vector<double>> slopes(const Evaluation& at, bool fine,
                                          std::optional<std::size_t> fixed = std::nullopt);

  /// Levenberg-Marquardt method from `at`; parameter `fixed` keeps its position.
  Evaluation levenberg_marquardt(Evaluation at, std::optional<std::size_t> fixed = std::nullopt);

  /// Subplex search near `from`, for sums that are not smooth (Rowan 1990).
  Evaluation subplex_search(const Evaluation& from);

  /// The best of many positions spread over the ranges, far from each other. Throws RunError if
  /// none of them has residuals.
  std::vector<Evaluation> start_points();

 private:
  std::optional<Evaluation> damped_step(const Evaluation& at,
                                        const std::vector<std::vector<double>>& slopes,
                                        double& damping);

  const Residuals& residuals_;
  const std::vector<FreeParameter>& parameters_;
  std::vector<Evaluation> evaluations_;
};

}  // namespace mahlwerk::campaign
