// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/catalogue.hpp"

namespace mahlwerk::cases {

/// Reads the text of a catalogue file. Faults cite the name `file`. Throws InputError with all
/// faults: unknown keys, values without a source, values of a wrong type, unit or range.
CatalogueEntry read_entry(std::string_view text, std::string_view category, std::string_view name,
                          std::string_view file);

/// The words, separated by `between`.
std::string joined(const std::vector<std::string>& words, std::string_view between);

/// Remedy for an unknown word: the nearest known word, or all of them.
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk::cases
