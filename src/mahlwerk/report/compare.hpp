// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// Estimates of one quantity by both engines.
struct EnginePair {
  observe::Estimate event, soft;

  double ratio() const {
    return soft.mean / event.mean;
  }                           ///< soft/event; NaN or infinite if event is 0
  double ratio_ci95() const;  ///< half-width, by first-order error propagation
  /// Whether the 95 % intervals do not overlap; false without intervals.
  bool differs() const;
};

struct ComparedQuantity {
  std::string name, unit, about;  ///< as in summary.json
  EnginePair estimates;
};

/// Collisions per second within low <= value < high.
struct ComparedBin {
  double low = 0, high = 0;
  EnginePair rate;
};

/// Computing time and notices of one engine.
struct EngineDiagnostics {
  double cpu_seconds = 0;
  Notices notices;
};

/// Results of one case by both engines.
struct Comparison {
  std::string title, case_file;
  double threshold = 0;  ///< [m/s]
  EngineDiagnostics event, soft;
  std::string caution;  ///< input that the engines interpret differently; may be empty
  std::vector<ComparedQuantity> quantities;
  /// By normal speed [m/s] in bins of one octave, and by normal energy [J] in bins of two octaves.
  /// The first bin includes everything below it.
  std::vector<ComparedBin> speeds, energies;
  /// The same with four bins per octave, without the values far below.
  std::vector<ComparedBin> speed_curve, energy_curve;
};
Comparison compare(const results::Outcome& event, const results::Outcome& soft);

/// Guidance for the reader: where the engines should agree, and where not.
std::string how_to_read(const Comparison& comparison);

std::string compare_table(const Comparison& comparison);  ///< for the terminal
std::string compare_csv(const Comparison& comparison);    ///< compare.csv (docs/formats.md)
/// compare.html, a self-contained page; results of each engine are in event/ and soft/.
std::string compare_page(const Comparison& comparison, std::string_view version);

}  // namespace mahlwerk::report
