// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// Writes summary.json, result.h5, case.resolved.toml and the tables of a result (docs/formats.md)
/// into `folder`. `below`: subfolder with a slash at its end ("point-03/"), or "".
void write(const Folder& folder, const Outcome& outcome, std::string_view version,
           std::string_view below = "");

/// Writes the case as `name` ("case.resolved.toml", with or without a folder), and its jar's mesh
/// and measured motion beside it. Returns the text of the case.
std::string write_case(const Folder& folder, cases::Case mill_case, std::string_view name);

}  // namespace mahlwerk::results
