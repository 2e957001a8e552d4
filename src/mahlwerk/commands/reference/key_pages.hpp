// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// The keys and the units of a case file, as tables and as JSON.
namespace mahlwerk::commands {

using KeySections = std::vector<const cases::KeySection*>;

/// The sections and kinds that a word names: "mill", "planetary", "mill.planetary" if a kind's name
/// occurs twice, or the section of a key, "mill.speed". With a section come no kinds.
KeySections sections_named(std::string_view word);
/// All words that sections_named() knows, each once.
std::vector<std::string> section_words();

/// The kinds of a section: "still", "vibration", ... of "mill".
std::vector<std::string> kinds_of(std::string_view section);
/// Description of a key; unless `brief`, also the conditions under which it counts and the origin
/// of its default.
std::string key_meaning(const cases::KeyInfo& key, bool brief = false);
/// The range of a number in few characters: "> 0", "0 to 1", "> 0 to 1"; else the type.
std::string key_range(const cases::KeyInfo& key);
/// Breaks a text into lines of at most `width` characters. The first begins in the column after
/// `margin`, with which the others begin.
std::string wrapped_text(const std::string& text, const std::string& margin,
                         std::size_t width = 110);

/// The section as tables of keys; with `only`, of this key alone.
std::string key_tables(const cases::KeySection& section, std::string_view only = {});
results::Json keys_as_json(const KeySections& sections);
/// Every section and kind with the names of its keys.
std::string key_index();
KeySections all_sections();

/// The units that measure the same in one line, in the order of the table of units.
std::string unit_table();
results::Json units_as_json();

}  // namespace mahlwerk::commands
