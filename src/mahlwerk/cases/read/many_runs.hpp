// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/read/case_tree.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {

/// Reads the sections about many runs into `c`, [sweep], [optimise], [match], [fit] and
/// [uncertainty], and applies the overrides of each and of the command. The keys that a section
/// varies have a value of the case in `tree` afterwards. Returns [fit] as written.
DottedLists read_many_runs(CaseTree& tree, const std::vector<Override>& overrides, Case& c);

}  // namespace mahlwerk::cases
