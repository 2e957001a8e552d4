// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/files/json_value.hpp"

// The register of quantities as text, for users and other programs.
namespace mahlwerk::results {

/// All quantities of summary.json, one object each, in its order: name, unit, about, label, symbol,
/// least, most, heading, equation, only, series (docs/formats.md).
Json quantity_list();
/// The object of one of them; null if there is none of that name.
Json quantity_record(std::string_view name);
/// The list as a table for the terminal, under the headings of results: name, unit, sentence. With
/// `word` those alone that have it in their name, their label, their sentence or their heading,
/// regardless of case; empty if there is none.
std::string quantity_index(std::string_view word = {});
/// One quantity in words; empty if there is none of that name.
std::string quantity_in_words(std::string_view name);

}  // namespace mahlwerk::results
