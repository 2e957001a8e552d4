// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/part.hpp"

// [capture], [breakage], [fragments] and [grinding]: capture of powder by collisions, and breakage.
namespace mahlwerk::parts::grinding {

/// `remembering`: the breakage model tracks the strength of grains.
void describe(cases::KeyVisitor& v, cases::Capture& capture, const cases::Case& c,
              bool remembering = false);
void describe(cases::KeyVisitor& v, powder::AnyBreakage& breakage, const cases::Case& c);
void describe(cases::KeyVisitor& v, powder::AnyFragments& fragments, const cases::Case& c);
void describe(cases::KeyVisitor& v, cases::Grinding& g, const cases::Case& c);
/// Reads them together, because each depends on others.
void read(cases::SectionTables& tables, cases::Case& c, cases::Findings& findings);

}  // namespace mahlwerk::parts::grinding
