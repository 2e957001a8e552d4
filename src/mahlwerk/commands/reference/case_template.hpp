// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/cases/catalogue.hpp"

// The text of a case to start from: every key with its unit, range and meaning.
namespace mahlwerk::commands {

/// What a new case is made of. One of `mill` and `mill_kind` is given; at most one of `jar` and
/// `jar_kind`.
struct CaseParts {
  std::string mill, mill_kind, jar, jar_kind, balls;
  std::string motion_file = {}, surface_file = {};  ///< for a tabulated motion and a mesh
};

/// Fills in the kinds of mill and jar, and a jar if none is chosen. Throws InputError for an
/// unknown name or kind.
void complete(CaseParts& parts, const cases::Catalogue& catalogue);
/// Requires completed parts.
std::string case_template(const CaseParts& parts, const cases::Catalogue& catalogue);

}  // namespace mahlwerk::commands
