// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

// Weighted least squares within bounds (docs/theory/fit.md).
namespace mahlwerk::campaign {

/// A parameter to fit, and its bounds.
struct FreeParameter {
  std::string name;
  double least = 0, most = 1;                           ///< finite, least < most
  std::optional<double> start = std::nullopt;           ///< between the bounds; empty: their middle
  bool min_is_natural = false, max_is_natural = false;  ///< no value beyond it is possible

  /// Whether the search uses the logarithm: the bounds are positive and a factor above 10 apart.
  bool logarithmic() const { return least > 0 && most > 10 * least; }
};

/// Residuals as a function of the parameters, in their order: the same number for any set, NaN
/// where a set has none.
using Residuals = std::function<std::vector<double>(const std::vector<double>&)>;

/// Unit of the residuals.
enum class ErrorScale {
  known,     ///< standard deviations of the measurements
  estimated  ///< a common unit: the residuals determine the scatter of the data
};

struct FittedParameter {
  std::string name;
  double value = 0;
  double low = 0, high = 0;  ///< 95 % interval (fit.5); where it is open, the end of the range
  bool open_low = false, open_high = false;  ///< no such limit within the range
  bool determined = false;
  std::vector<std::string> remarks;  ///< sentences without a full stop; why, if not determined
};

struct LeastSquaresResult {
  std::vector<FittedParameter> parameters;
  std::vector<std::vector<double>> correlation;  ///< (fit.7)
  std::vector<double> residuals;
  double sum_of_squares = 0;
  int degrees_of_freedom = 0;  ///< residuals less parameters
  double scatter = 0;          ///< [1] s of the residuals (fit.3); NaN without degrees of freedom
  int evaluations = 0;         ///< of the residuals
  std::vector<std::string> remarks;  ///< on the whole fit; sentences without a full stop
};

/// Minimises the sum of squares (fit.1): the parameters, their intervals, and which of them the
/// data do not determine. A set with a residual that is not finite fits worse than any other. Takes
/// some hundred evaluations per parameter; the same for the same input. Throws RunError if no set
/// that was tried has residuals, std::invalid_argument if bounds hold no interval.
LeastSquaresResult least_squares(const Residuals& residuals,
                                 const std::vector<FreeParameter>& parameters, ErrorScale scatter);

}  // namespace mahlwerk::campaign
