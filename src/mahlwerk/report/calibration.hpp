// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/notices/notice_counts.hpp"

// Results of a calibration: text for the terminal, CSV table and page.
namespace mahlwerk::report {

/// A calibrated key. Texts are as in a case: "0.53", "412 rpm".
struct CalibratedKey {
  std::string key, unit;         ///< unit of `posterior`; empty: a plain number
  std::string from, to;          ///< the range
  double least = 0, most = 1;    ///< the same in `unit`
  std::string value, low, high;  ///< most central draw and 95 % interval
  double number = 0, number_low = 0, number_high = 1;  ///< the same in `unit`
  bool open_low = false, open_high = false, determined = true;
  std::vector<double> posterior = {};     ///< values of the draws
  std::vector<std::string> remarks = {};  ///< sentences without a full stop

  std::string interval_text() const;  ///< "0.4 to 0.6", "up to 0.6", "not determined"
};

/// A measured value beside the calibrated model, in SI units.
struct CalibratedPoint {
  std::string what, unit;
  std::size_t condition = 0;
  double fall = 0;  ///< [m] of a rebound
  double measured = 0, error = 0;
  double predicted = 0, low = 0, high = 0;  ///< by the emulators, with 95 % interval
  double simulated = 0, ci95 = 0;           ///< runs at the central draw, with new seeds
  int line = 0;
};

struct CalibrationReport {
  std::string title, case_file, data_file;
  std::vector<CalibratedKey> keys = {};
  std::vector<std::vector<double>> correlation = {};
  std::vector<std::string> conditions = {};  ///< "mill.speed = 300 rpm"; empty: the case unchanged
  std::string condition_key = {},
              condition_unit = {};            ///< the only key that varies, if it is a number
  std::vector<double> condition_values = {};  ///< its values
  std::vector<CalibratedPoint> points = {};
  std::vector<std::string> remarks = {};
  results::NoticeCounts notices = {};
  double misfit = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> scatter = {};  ///< relative, of data without errors, by quantity
  double emulator_error = 0;         ///< largest leave-one-out error of an emulator, by spread
  double emulator_share = 0;
  int settings = 0, failed = 0, runs = 0, draws = 0;
  bool errors_known = false, converged = false;

  bool all_determined() const;
};

std::string calibration_table(const CalibrationReport& found);  ///< for the terminal
std::string calibration_csv(const CalibrationReport& found);    ///< fit.csv (docs/formats.md)
std::string posterior_csv(const CalibrationReport& found);      ///< posterior.csv
/// fit.html, a self-contained page.
std::string calibration_page(const CalibrationReport& found, std::string_view version);
/// Explains intervals and predictions to the reader.
std::string how_to_read(const CalibrationReport& found);

}  // namespace mahlwerk::report
