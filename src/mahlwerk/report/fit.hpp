// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/notices/notice_counts.hpp"

// What was found by fitting, for the terminal, as a table and as a page.
namespace mahlwerk::report {

/// A number of the case that was to be found.
struct FitParameter {
  std::string key, unit, about;
  double value = 0, low = 0, high = 0;  ///< and 95 % interval
  double simulation_ci95 = 0;           ///< half-width due to the simulated mills; NaN: not known
  double least = 0, most = 0;           ///< where it was looked for
  bool open_low = false, open_high = false, determined = true;
  std::vector<std::string> remarks;  ///< sentences without a full stop

  std::string value_text() const;     ///< "1.3 kg/J/m"
  std::string interval_text() const;  ///< "1.1 to 1.6 kg/J/m", "up to ...", "not determined"
};

/// Something measured, and what the models say of it, in SI.
struct FitPoint {
  std::string what, unit;  ///< "D90", "m"
  std::size_t condition = 0;
  double time = 0, size = 0;  ///< [s]; [m] of what passes, else 0
  double measured = 0, error = 0, fitted = 0, residual = 0;
  int line = 0;  ///< of the file of measurements
};

/// What the models say over time, or of `passing` over size.
struct FitCurve {
  std::string what;
  std::size_t condition = 0;
  double time = 0;  ///< [s] of a distribution
  std::vector<double> x, y;
};

struct FitReport {
  std::string title, case_file, data_file;
  std::vector<FitParameter> parameters = {};
  std::vector<std::vector<double>> correlation = {};
  std::vector<std::string> conditions = {};  ///< "mill.frequency = 16 Hz"; empty: as the case is
  std::vector<FitPoint> points = {};
  std::vector<FitCurve> curves = {};
  std::vector<std::string> remarks = {};  ///< on all of it
  results::NoticeCounts notices = {};     ///< of the mills, one of each condition
  double scatter = 0;                     ///< of the residuals; NaN without freedom
  int degrees_of_freedom = 0, evaluations = 0;
  bool errors_known = false;

  bool all_determined() const;
};

/// What residuals, intervals and the scatter mean here.
std::string how_to_read(const FitReport& fit);

std::string fit_table(const FitReport& fit);  ///< for the terminal
std::string fit_csv(const FitReport& fit);    ///< fit.csv (docs/formats.md)
/// fit.html, one page that loads nothing.
std::string fit_page(const FitReport& fit, std::string_view version);

}  // namespace mahlwerk::report
