// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
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
  std::string unit = {}, about = {};                    ///< of its numbers, empty: none; what it is

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

/// Numbers of a parameter as text, with unit: "412 rpm".
struct ParameterTexts {
  std::string value, low, high;  ///< and ends of its 95 % interval
  std::string least, most;       ///< ends of its range
};

/// A parameter with what the measurements say of it.
struct FittedParameter : FreeParameter {
  double value = 0;
  double low = 0, high = 0;  ///< 95 % interval (fit.5); where it is open, the end of the range
  bool open_low = false, open_high = false;  ///< no such limit within the range
  bool determined = false;
  std::vector<std::string> remarks = {};  ///< sentences without a full stop; why, if not determined
  /// Half-width of the 95 % interval that the scatter of the simulated mills alone gives it
  /// (fit.10); NaN: unknown. The interval includes it.
  double simulation_ci95 = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> posterior = {};  ///< of a calibration: its values in all draws
  ParameterTexts text = {};

  std::string interval_text() const;  ///< "0.4 to 0.6", "up to 0.6", "not determined"
};

/// Parameters that were estimated together.
struct ParameterEstimates {
  std::vector<FittedParameter> parameters = {};
  std::vector<std::vector<double>> correlation = {};  ///< (fit.7)
  std::vector<std::string> remarks = {};  ///< on the whole; sentences without a full stop

  bool all_determined() const;
};

struct LeastSquaresResult : ParameterEstimates {
  std::vector<double> residuals = {};
  double sum_of_squares = 0;
  int degrees_of_freedom = 0;  ///< residuals less parameters
  double scatter = 0;          ///< [1] s of the residuals (fit.3); NaN without degrees of freedom
  int evaluations = 0;         ///< of the residuals
};

/// Minimises the sum of squares (fit.1): the parameters, their intervals, and which of them the
/// data do not determine. A set with a residual that is not finite fits worse than any other. Takes
/// some hundred evaluations per parameter; the same for the same input. Throws RunError if no set
/// that was tried has residuals, std::invalid_argument if bounds hold no interval.
LeastSquaresResult least_squares(const Residuals& residuals,
                                 const std::vector<FreeParameter>& parameters, ErrorScale scatter);

}  // namespace mahlwerk::campaign
