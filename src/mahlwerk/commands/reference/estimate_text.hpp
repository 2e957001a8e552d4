// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/commands/reference/estimate_case.hpp"

// The case of an estimate with the time that it counts.
namespace mahlwerk::commands {

/// Reads the text of a case. Throws InputError.
using CaseReader = std::function<cases::Case(const std::string&)>;

/// The case of the words as a TOML text. It counts a hundred periods of the mill between one and
/// three seconds, at least three periods; less where the soft engine would take more than about
/// half a minute of a core. The time follows from the case alone, so that an estimate is the same
/// on any machine. Throws InputError.
std::string estimate_text(const EstimateWords& words, const cases::Catalogue& catalogue,
                          const CaseReader& read);

/// The text as a file, with a comment that says what it is. `set`: options --set of the estimate,
/// with a blank before each.
std::string saved_estimate(const std::string& text, const std::string& set = "");

}  // namespace mahlwerk::commands
