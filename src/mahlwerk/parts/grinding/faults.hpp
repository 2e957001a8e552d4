// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::parts::grinding {

/// Inconsistencies of [powder], [capture], [breakage], [fragments] and [grinding].
void check(const cases::Case& c, std::vector<Fault>& found);

}  // namespace mahlwerk::parts::grinding
