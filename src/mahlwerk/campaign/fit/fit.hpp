// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/fit/evaluations.hpp"
#include "mahlwerk/campaign/fit/least_squares.hpp"
#include "mahlwerk/campaign/fit/measurement_study.hpp"
#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/campaign/fit/predictor.hpp"
#include "mahlwerk/results/outcome.hpp"

// Parameters of powder models, fitted to measurements (docs/theory/fit.md).
namespace mahlwerk::campaign {

/// The free parameters in [fit] of a case, without those in `fixed`, in their units.
std::vector<FreeParameter> free_parameters(const cases::Case& mill_case,
                                           const std::vector<std::string>& fixed = {});

/// Faults of a fit: the case cannot predict a measurement, or no parameter is free. `file` is that
/// of the measurements.
std::vector<Fault> fit_faults(const cases::Case& mill_case, const Measurements& data,
                              const std::vector<FreeParameter>& parameters,
                              const std::string& file);

/// Gives measurements without a time that of the case under their condition.
void fill_times(Measurements& data, const std::vector<cases::Case>& conditions);

/// The case that a fit runs for a condition: collisions and frames are not recorded, grinding is by
/// population balance up to the longest time measured, each parameter is at the middle of its
/// range.
cases::Case case_for_fit(cases::Case mill_case, std::size_t condition, const Measurements& data,
                         const std::vector<FreeParameter>& parameters);

/// Residual of a measurement: (fit.8) for sizes, surfaces and times, (fit.9) for shares.
double residual(const Measurement& measured, double predicted);

struct FitOptions {
  int threads = 0;                          ///< 0: as many as the machine has
  const std::atomic<bool>* stop = nullptr;  ///< when set: throws Interrupted
  /// Called after each evaluation; `usual`: number of evaluations that a fit usually takes.
  std::function<void(int evaluations, int usual)> progress = {};
  FitEvaluations* kept = nullptr;  ///< keeps predictions, and supplies them
};

/// Model curve over time, or of `passing` over size.
struct FitCurve {
  std::string what;
  std::size_t condition = 0;
  double time = 0;  ///< [s] of a size distribution
  std::vector<double> x, y;
};

struct Fit : MeasurementStudy {
  LeastSquaresResult result = {};
  std::vector<FitCurve> curves = {};
};

/// The numbers of a parameter as text, with as many digits as keep the ends of its interval apart.
ParameterTexts texts_of(const FittedParameter& p);

/// Fits the parameters to the measurements. Throws RunError if no values give any powder,
/// Interrupted if options.stop is set.
Fit fit(const std::vector<results::Outcome>& mills, const Measurements& data,
        const std::vector<FreeParameter>& parameters, const FitOptions& options = {});

}  // namespace mahlwerk::campaign
