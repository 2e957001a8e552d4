// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/search/outcome_model.hpp"

namespace mahlwerk::campaign {

/// Emulator of an outcome, of its logarithm where it varies by a large factor.
struct OutcomeEmulator {
  OutcomeModel model;
  bool logarithmic = false;

  double transformed(double value) const;
  double value_of(double transformed) const;
  /// Root mean square of the leave-one-out errors, relative to the spread of the outcome (opt.18).
  double leave_one_out_error() const;
};

/// How well each observation is predicted from all others (opt.18).
struct HoldOut {
  double error = 0;     ///< root mean square, relative to the spread of the outcome
  double widening = 1;  ///< >= 1: factor that makes intervals as wide as these errors (opt.19)
  double coverage = 0;  ///< share of the observations within their widened 95 % intervals
};
HoldOut hold_out(const OutcomeEmulator& emulator);

/// Whether positive values differ so much (by a factor above 3) that their logarithm is smoother.
bool varies_by_factors(double least, double most);

}  // namespace mahlwerk::campaign
