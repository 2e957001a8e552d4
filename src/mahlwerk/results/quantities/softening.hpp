// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// [1] The most by which impacts that contact.softening makes longer can raise the
/// contact_time_share of a replicate: no two of them coincide.
double share_by_softening(const cases::Case& mill_case, const Replicate& replicate);

}  // namespace mahlwerk::results
