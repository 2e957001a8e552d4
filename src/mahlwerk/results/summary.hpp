// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// One number of a result, under its plain name in summary.json.
struct Quantity {
  std::string name;
  double value = 0;
  double ci95 = 0;  ///< half-width over replicates; NaN with fewer than two
  std::string unit;
  std::string about;
  /// Half-width that the scatter over time within replicates gives; NaN where there is none.
  double ci95_time = std::numeric_limits<double>::quiet_NaN();

  /// The half-width to show: over replicates, else over time.
  double half_width() const { return std::isfinite(ci95) ? ci95 : ci95_time; }
};

/// The quantities of summary.json, in their order (docs/formats.md).
std::vector<Quantity> summarise(const Outcome& outcome);

/// The same of one replicate alone, in the same order; ci95 is NaN.
std::vector<Quantity> summarise(const Outcome& outcome, const Replicate& replicate);

/// A quantity that a case does not have, and the section it comes with: "[wear]".
struct Lacking {
  std::string name, section;
};
/// Those that the case would have with another section.
std::vector<Lacking> lacking(const cases::Case& what);

/// The mean of a quantity and its half-width; a replicate in which it does not exist (no collision)
/// is left out.
void combine(Quantity& q, const std::vector<double>& values);

/// The replicates that means are taken over: those that ran to their end if there are at least two,
/// else all that counted any time.
std::vector<const Replicate*> averaged(const Outcome& outcome);
/// Those of them that have ground.
std::vector<const Replicate*> ground_replicates(const Outcome& outcome);

/// Mean of what `of` says of each replicate; NaN of none.
template <class Of>
double mean_over(const std::vector<const Replicate*>& replicates, const Of& of) {
  double sum = 0;
  for (const Replicate* r : replicates) sum += of(*r);
  return sum / static_cast<double>(replicates.size());
}

/// True if every replicate was run, and to its end.
bool complete(const Outcome& outcome);

}  // namespace mahlwerk::results
