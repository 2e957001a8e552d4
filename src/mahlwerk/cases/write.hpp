// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::cases {

/// The resolved case as TOML: every value, followed by its origin as a comment.
/// read_text(write(c)) == c.
std::string write(const Case& c);

/// Fingerprint of the contents of the files that a case names: the jar's mesh and the measured
/// motion. Distinguishes cases whose files have equal names but different contents.
std::string input_files_fingerprint(const Case& c);

}  // namespace mahlwerk::cases
