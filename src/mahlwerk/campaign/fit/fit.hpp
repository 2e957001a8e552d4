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
#include "mahlwerk/campaign/fit/least_squares.hpp"
#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/outcome.hpp"

// Numbers of the powder's models, found from what was measured of it (docs/theory/fit.md).
namespace mahlwerk::campaign {

/// The numbers that [fit] of a case leaves open but for those in `fixed`, in their units.
std::vector<FreeParameter> free_parameters(const cases::Case& what,
                                           const std::vector<std::string>& fixed = {});

/// What keeps a case from telling what was measured, or leaves nothing to be found; `file` is that
/// of the measurements.
std::vector<Fault> fit_faults(const cases::Case& what, const Measurements& data,
                              const std::vector<FreeParameter>& parameters,
                              const std::string& file);

/// Measurements that say no time get that of the case under their condition.
void fill_times(Measurements& data, const std::vector<cases::Case>& conditions);

/// A case as a fit runs its mill: nothing is kept but what the powder needs, which mills by the
/// balance as long as its longest measurement says, with each number in the middle of its range.
cases::Case case_for_fit(cases::Case what, std::size_t condition, const Measurements& data,
                         const std::vector<FreeParameter>& parameters);

/// What the models say of the powder under collisions that stay as they are.
class Predictor {
 public:
  /// `mills`: of each condition, kept by reference; each has a replicate that counted.
  /// `measurements` have times no longer than its case mills. The mean of all replicates, or the
  /// one that is `only`.
  Predictor(const std::vector<results::Outcome>& mills, std::vector<FreeParameter> parameters,
            std::vector<Measurement> measurements, int threads = 0,
            std::optional<std::size_t> only = std::nullopt);

  /// What each measurement should have given; NaN where the models give nothing.
  std::vector<double> operator()(const std::vector<double>& values) const;

 private:
  struct Mill {
    const results::Outcome* outcome;
    std::vector<const results::Replicate*> replicates;
    powder::StressSpectrum stresses;
    std::optional<powder::CaptureTable> beds;  ///< where no number that is sought changes them
    bool grinds = false;                       ///< sizes are asked for
    std::vector<std::size_t> measurements;     ///< places in measurements_
  };
  void predict(const Mill& mill, const std::vector<double>& values,
               std::vector<double>& predicted) const;

  std::vector<FreeParameter> parameters_;
  std::vector<Measurement> measurements_;
  std::vector<Mill> mills_;
  int threads_;
};

/// (fit.8) for sizes and surfaces, (fit.9) for shares.
double residual(const Measurement& measured, double predicted);

struct FitOptions {
  int threads = 0;                                     ///< 0: as many as the machine has
  const std::atomic<bool>* stop = nullptr;             ///< set: Interrupted is thrown
  std::function<void(int evaluations)> progress = {};  ///< after each time the powder was milled
};

struct Fit {
  LeastSquaresResult result;
  std::vector<double> predicted;  ///< of each measurement, by what was found
  /// Half-widths of the 95 % intervals that the scatter of the simulated mills alone gives each
  /// number (fit.10), in its unit; NaN with fewer than two replicates. Intervals allow for it.
  std::vector<double> simulation_ci95;
};

/// The numbers that bring the models nearest to what was measured. Throws RunError where no values
/// give any powder, Interrupted once it is told to stop.
Fit fit(const std::vector<results::Outcome>& mills, const Measurements& data,
        const std::vector<FreeParameter>& parameters, const FitOptions& options = {});

}  // namespace mahlwerk::campaign
