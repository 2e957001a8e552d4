// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "mahlwerk/results/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// Writes summary.json, result.h5, case.resolved.toml and the tables of a result (docs/formats.md)
/// into `folder`, under `below` if that is given ("" or "point-03/").
void write(const Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below = "");

}  // namespace mahlwerk::results
