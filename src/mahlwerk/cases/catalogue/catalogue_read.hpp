// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"

namespace mahlwerk::cases {

/// Reads the text of a catalogue file. `file` is the name faults cite. Throws InputError with every
/// fault: unknown keys, values without a source, values that are not what their key asks for.
CatalogueEntry read_entry(std::string_view text, std::string_view category, std::string_view name,
                          std::string_view file);

/// The words with `between` between them.
std::string joined(const std::vector<std::string>& words, std::string_view between);

/// What to write instead of a word that is not known.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk::cases
