// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/commands/measure/measured.hpp"

namespace mahlwerk::commands {

/// Sources of the measured values, and [uncertainty] with draws of those of [mill] and [contact]
/// from the normal distribution of their intervals and covariance (mea.16): 16, or as many as the
/// case has already. Their mean is the measured value. The same measurement gives the same draws.
void add_draws(const Measured& measured, cases::Case& mill_case);

}  // namespace mahlwerk::commands
