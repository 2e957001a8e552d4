// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"

namespace mahlwerk::parts::flow {

void describe(cases::KeyVisitor& v, cases::Flow& flow, const cases::Case& c);
/// What is wrong with valid values of [flow].
void check(const cases::Case& c, std::vector<Fault>& found);

}  // namespace mahlwerk::parts::flow
