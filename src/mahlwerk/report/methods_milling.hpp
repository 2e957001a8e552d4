// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::report {

/// The sentences of the methods paragraph on what follows from the milling time: dose, wear and
/// temperatures. An asterisk marks every assumed value.
std::string milling_words(const cases::Case& c);

}  // namespace mahlwerk::report
