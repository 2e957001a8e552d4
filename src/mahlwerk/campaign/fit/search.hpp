// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "mahlwerk/campaign/fit/least_squares.hpp"

namespace mahlwerk::campaign {

/// The value of a parameter from its place, 0 to 1 across its range (fit.2), and back.
double value_at(const FreeParameter& p, double place);
double place_of(const FreeParameter& p, double value);

/// A set of parameters, by their places, and how it fits.
struct Point {
  std::vector<double> place, residuals;
  double sum = std::numeric_limits<double>::infinity();  ///< of squares (fit.1)
};

/// Goes down in the sum of squares, and remembers every place it saw. Keeps references to what it
/// is made of.
class Search {
 public:
  Search(const Residuals& residuals, const std::vector<FreeParameter>& parameters)
      : residuals_(residuals), parameters_(parameters) {}

  std::size_t count() const { return parameters_.size(); }
  const std::vector<Point>& seen() const { return seen_; }  ///< without residuals

  Point look(const std::vector<double>& place);

  /// Of the residuals by each place but that of `held`, from both sides if they are to be `fine`;
  /// zero where no neighbour has any.
  std::vector<std::vector<double>> slopes(const Point& at, bool fine,
                                          std::optional<std::size_t> held = std::nullopt);

  /// By Levenberg and Marquardt, the parameter `held` staying where it is.
  Point descend(Point at, std::optional<std::size_t> held = std::nullopt);

  /// Anywhere near, for sums that are not smooth: by simplexes (Rowan 1990).
  Point roam(const Point& from);

  /// The best of some places spread over the ranges, far from each other. Throws RunError if none
  /// of them has residuals.
  std::vector<Point> starts();

 private:
  std::optional<Point> lower(const Point& at, const std::vector<std::vector<double>>& slopes,
                             double& damping);

  const Residuals& residuals_;
  const std::vector<FreeParameter>& parameters_;
  std::vector<Point> seen_;
};

}  // namespace mahlwerk::campaign
