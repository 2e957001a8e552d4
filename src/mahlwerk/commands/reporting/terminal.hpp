// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// What a terminal can show: its width, colours, links. Elsewhere (files, pipes) texts stay as they
// are.
namespace mahlwerk::commands {

enum class Stream { output, errors };

/// --color: `automatic` colours on terminals, unless NO_COLOR is set or TERM is "dumb".
enum class ColorMode { automatic, always, never };

/// Counts for all later texts.
void set_color(ColorMode mode);

/// Whether the stream is a terminal that moves its cursor: TERM is set and is not "dumb".
bool is_terminal(Stream stream);
bool has_color(Stream stream);

/// Columns of the terminal: COLUMNS, else those of its window, else 80. Without a terminal the
/// largest number.
std::size_t terminal_width(Stream stream);

enum class Style { heading, warning, error };

/// `text` in this style; unchanged where there is no colour.
std::string styled(Style style, std::string_view text, Stream stream);

/// `text` as a link (OSC 8) that opens `target`, the path of a file with or without "#heading";
/// unchanged where there is no colour.
std::string linked(std::string_view text, const std::string& target, Stream stream);

/// A line broken at blanks so that no part is longer than `width`, where words allow it. In a table
/// (cells are two blanks apart) the last cell continues below itself; if it begins in the right
/// half, it gets lines of its own.
std::string wrapped_line(std::string_view line, std::size_t width);

/// A page of results or help as the terminal shows it: wrapped, with headings (lines above
/// indented lines) and warnings in their styles. Unchanged where there is no terminal.
std::string page_for(Stream stream, std::string_view text);

/// Messages of faults, as describe() makes them, as the terminal shows them: wrapped, with the
/// place in the `style`, and the documents that they name as links that open. Unchanged where there
/// is no terminal.
std::string faults_for(Stream stream, Style style, std::string_view text);

}  // namespace mahlwerk::commands
