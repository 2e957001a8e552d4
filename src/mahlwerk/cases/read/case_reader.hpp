// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "mahlwerk/cases/file/table.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::cases {

/// Reads a case from its parsed file. Throws InputError with all faults.
Case read_tree(const Node& root, const std::filesystem::path& file, const Catalogue& catalogue,
               const std::vector<Override>& overrides);

}  // namespace mahlwerk::cases
