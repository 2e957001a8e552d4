// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/notices/notice_counts.hpp"

// Results of a fit: text for the terminal, CSV table and page.
namespace mahlwerk::report {

/// A fitted parameter of the case.
struct FitParameter {
  std::string key, unit, about;
  double value = 0, low = 0, high = 0;  ///< value and 95 % interval
  double simulation_ci95 = 0;           ///< half-width due to the simulated mills; NaN: unknown
  double least = 0, most = 0;           ///< search range
  bool open_low = false, open_high = false, determined = true;
  std::vector<std::string> remarks;  ///< sentences without a full stop

  std::string value_text() const;     ///< "1.3 kg/J/m"
  std::string interval_text() const;  ///< "1.1 to 1.6 kg/J/m", "up to ...", "not determined"
};

/// A measurement and its fitted value, in SI units.
struct FitPoint {
  std::string what, unit;  ///< "D90", "m"
  std::size_t condition = 0;
  double time = 0, size = 0;  ///< [s]; [m] sieve size of `passing`, else 0
  double measured = 0, error = 0, fitted = 0, residual = 0;
  int line = 0;  ///< line number in the file of measurements
};

/// Model curve over time, or of `passing` over size.
struct FitCurve {
  std::string what;
  std::size_t condition = 0;
  double time = 0;  ///< [s] of a size distribution
  std::vector<double> x, y;
};

struct FitReport {
  std::string title, case_file, data_file;
  std::vector<FitParameter> parameters = {};
  std::vector<std::vector<double>> correlation = {};
  std::vector<std::string> conditions =
      {};  ///< "mill.frequency = 16 Hz"; empty: the case unchanged
  std::vector<FitPoint> points = {};
  std::vector<FitCurve> curves = {};
  std::vector<std::string> remarks = {};  ///< on the whole fit
  results::NoticeCounts notices = {};     ///< of the mills, one mill for each condition
  double scatter = 0;                     ///< of the residuals; NaN without degrees of freedom
  int degrees_of_freedom = 0, evaluations = 0;
  bool errors_known = false;

  bool all_determined() const;
};

/// Explains residuals, intervals and scatter to the reader.
std::string how_to_read(const FitReport& fit);

std::string fit_table(const FitReport& fit);  ///< for the terminal
std::string fit_csv(const FitReport& fit);    ///< fit.csv (docs/formats.md)
/// fit.html, a self-contained page.
std::string fit_page(const FitReport& fit, std::string_view version);

}  // namespace mahlwerk::report
