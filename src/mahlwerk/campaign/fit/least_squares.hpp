// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

// Numbers found from data by weighted least squares, within bounds (docs/theory/fit.md).
namespace mahlwerk::campaign {

/// A number to be found, and where to look for it.
struct FreeParameter {
  std::string name;
  double least = 0, most = 1;                              ///< finite, least < most
  std::optional<double> start = std::nullopt;              ///< between them; none: their middle
  bool least_is_natural = false, most_is_natural = false;  ///< nothing lies beyond that it could be

  /// It is positive and may be ten times as large as another: searched in the logarithm.
  bool logarithmic() const { return least > 0 && most > 10 * least; }
};

/// Of a set of parameters, in their order: as many numbers for any set, NaN where it has none.
using Residuals = std::function<std::vector<double>(const std::vector<double>&)>;

/// What residuals are measured in.
enum class ErrorScale {
  known,     ///< standard deviations of the measurements
  estimated  ///< something alike for all: the residuals themselves tell how the data scatter
};

struct FittedParameter {
  std::string name;
  double value = 0;
  double low = 0, high = 0;  ///< 95 % interval (fit.5); where it is open, the end of the range
  bool open_low = false, open_high = false;  ///< the data give no such limit within the range
  bool determined = false;
  std::vector<std::string> remarks;  ///< sentences without a full stop; why, if not determined
};

struct LeastSquaresResult {
  std::vector<FittedParameter> parameters;
  std::vector<std::vector<double>> correlation;  ///< (fit.7)
  std::vector<double> residuals;
  double sum_of_squares = 0;
  int degrees_of_freedom = 0;        ///< residuals less parameters
  double scatter = 0;                ///< [1] s of the residuals (fit.3); NaN without freedom
  int evaluations = 0;               ///< of the residuals
  std::vector<std::string> remarks;  ///< on all of it; sentences without a full stop
};

/// The parameters for which the sum of squares (fit.1) is least, how sure they are, and which of
/// them the data do not determine. A set whose residuals are not all finite fits worse than any
/// other. Takes some hundred evaluations a parameter; the same for the same input. Throws RunError
/// if no set that was tried has residuals, std::invalid_argument for bounds that hold no interval.
LeastSquaresResult least_squares(const Residuals& residuals,
                                 const std::vector<FreeParameter>& parameters, ErrorScale scatter);

}  // namespace mahlwerk::campaign
