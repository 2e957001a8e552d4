// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Symbols in the labels of plots: "$E_{n}$" is an italic E with the upright subscript n, "f^{2}" a
// superscript. A mark without its counterpart is drawn as it stands.
namespace mahlwerk::report {

/// Content of an SVG <text> element; `font` is its font size [px].
std::string rich_text(std::string_view text, double font);

/// The text without marks.
std::string plain_text(std::string_view text);

/// The text in lines of at most `letters` characters; a longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t letters);
/// The same with as few lines, which are of similar length.
std::vector<std::string> balanced(std::string_view text, std::size_t letters);

}  // namespace mahlwerk::report
