// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::parts::grinding {

/// Warnings where grinding models are used beyond their range of validity; else empty.
Notices warnings(const results::Outcome& outcome);

}  // namespace mahlwerk::parts::grinding
