// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/least_squares.hpp"
#include "mahlwerk/campaign/search/optimise.hpp"

// Parameters of a simulated mill from measurements on the real one: Bayesian calibration with
// emulators (docs/theory/calibration.md).
namespace mahlwerk::campaign {

/// A measured value of one outcome of the runs.
struct Datum {
  std::size_t outcome = 0;
  double value = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< standard deviation; NaN: not known
  std::size_t quantity = 0;  ///< data without errors share one unknown scatter for each quantity
};

struct CalibrationGoal {
  std::vector<FreeParameter> parameters;  ///< 1 to 8
  std::vector<Datum> data;                ///< at least one; errors are known for all, or for none
  std::size_t outcomes = 0;               ///< of a setting, over all conditions
  int settings = 0;                       ///< maximum number of settings; 0: usual_settings()
  int replicates = 2;                     ///< of each setting
  std::uint64_t seed = 1;
  std::size_t draws = 32;  ///< kept for [uncertainty]
  /// The point that is run for a requested one (rounded values); empty: the same point.
  std::function<DesignPoint(const DesignPoint&)> snap = {};
};

/// Settings that suffice for smooth outcomes of this many parameters.
int usual_settings(std::size_t parameters);

/// An outcome at the calibrated parameters.
struct PredictedOutcome {
  observe::IntervalEstimate value;  ///< with the interval from posterior and emulator (cal.8)
  /// Root mean square of the leave-one-out errors of the emulator, relative to the spread of the
  /// outcome over all settings.
  double emulator_error = 0;
};

/// Values of the most central draw, with 95 % intervals of the posterior; the correlation is that
/// of the positions in the ranges.
struct CalibrationResult : ParameterEstimates {
  DesignPoint central = {};                 ///< position of the most central draw
  std::vector<DesignPoint> draws = {};      ///< positions of some draws, for [uncertainty]
  std::vector<DesignPoint> posterior = {};  ///< positions of all draws
  std::vector<PredictedOutcome> outcomes = {};
  double misfit = 0;  ///< root of chi square by degrees of freedom; NaN without degrees of freedom
  std::vector<double> scatter =
      {};                     ///< by quantity: relative scatter of data without errors; else empty
  double emulator_share = 0;  ///< largest share of the emulator in the variance of a datum
  int settings = 0, failed = 0, rounds = 0;
  bool converged = false;
};

/// What a calibration is doing, for a progress line.
struct CalibrationProgress {
  int settings = 0, of = 0, rounds = 0;
  bool at_centre = false;  ///< runs of the calibrated case
};

struct CalibrationOptions {
  const std::atomic<bool>* stop = nullptr;  ///< when set: throws Interrupted
  std::function<void(const CalibrationProgress&)> progress = {};
};

/// Calibrates the parameters. Runs a Sobol design first, then settings from the posterior where the
/// emulators are least certain, until the emulators add little to the uncertainty of the
/// measurements. A setting that fails has no outcome and is left out. Deterministic. Throws
/// RunError if fewer settings ran than are needed, std::invalid_argument if the goal is out of
/// range.
CalibrationResult calibrate(const CalibrationGoal& goal, const Simulation& simulation,
                            const CalibrationOptions& options = {});

}  // namespace mahlwerk::campaign
