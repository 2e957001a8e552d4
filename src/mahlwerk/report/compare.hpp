// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// One number by both engines.
struct EnginePair {
  observe::Estimate event, soft;

  double ratio() const { return soft.mean / event.mean; }  ///< NaN or infinite where event is 0
  double ratio_ci95() const;                               ///< half-width, to first order
  /// The 95 % intervals do not overlap; never without intervals.
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

/// What one engine has to say besides its numbers.
struct EngineDiagnostics {
  double cpu_seconds = 0;
  Notices notices;
};

/// One case as both engines ran it.
struct Comparison {
  std::string title;
  double threshold = 0;  ///< [m/s]
  EngineDiagnostics event, soft;
  std::string caution;  ///< where the case means another thing to each engine; may be empty
  std::vector<ComparedQuantity> quantities;
  /// By normal speed [m/s], an octave each, and by normal energy [J], two octaves each; the first
  /// bin holds all below it, too.
  std::vector<ComparedBin> speeds, energies;
  /// The same, four bins an octave, without those far below.
  std::vector<ComparedBin> speed_curve, energy_curve;
};
Comparison compare(const results::Outcome& event, const results::Outcome& soft);

/// How to read it: where the engines should agree, and where not.
std::string how_to_read(const Comparison& comparison);

std::string compare_table(const Comparison& comparison);  ///< for the terminal
std::string compare_csv(const Comparison& comparison);    ///< compare.csv (docs/formats.md)
/// compare.html, one page that loads nothing; results of each engine are in event/ and soft/.
std::string compare_page(const Comparison& comparison, std::string_view version);

}  // namespace mahlwerk::report
