// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"

namespace mahlwerk::parts::bed_breakage {

void describe(cases::KeyVisitor& v, cases::BedBreakage& bed, const cases::Case& c);
void check(const cases::Case& c, std::vector<Fault>& found);

}  // namespace mahlwerk::parts::bed_breakage
