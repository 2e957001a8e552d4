// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"

// What the program computes and the page does not.
namespace mahlwerk::web {

/// Faults of a case that is too large for the memory of a page.
std::vector<Fault> page_faults(const cases::Case& mill_case);

/// A warning that names the sections and keys that only the program follows; empty if there are
/// none.
Notices left_to_program(const cases::Case& mill_case);

}  // namespace mahlwerk::web
