// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/reporting/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <system_error>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::commands {
namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
constexpr std::string_view cell_gap = "  ", document_label = "    more:   ",
                           remedy_label = "    remedy:", warning_label = "Warning:";

ColorMode chosen_color = ColorMode::automatic;

int descriptor(Stream stream) {
  return stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO;
}

std::string_view environment(const char* name) {
  const char* said = std::getenv(name);
  return said != nullptr ? said : "";
}

/// A path as part of an address: other characters than those of paths as %20.
std::string address_of(std::string_view path) {
  constexpr std::string_view others = "/-_.~#";
  std::string made;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (plain || others.find(c) != std::string_view::npos)
      made += c;
    else
      made += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return made;
}

/// Where the parts of a wrapped line begin after the first, and where the first must end.
struct Wrap {
  std::size_t indent, end = unlimited;
};

Wrap wrap_of(std::string_view line, std::size_t width) {
  constexpr std::size_t deeper = 4;
  const std::size_t margin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.rfind(cell_gap, line.find_last_not_of(' '));
  if (gap == std::string_view::npos || gap < margin) return {margin};
  const std::size_t column = report::width(line.substr(0, gap)) + cell_gap.size();
  if (column <= width / 2) return {column};
  return {margin + deeper, gap};
}

bool is_indented(std::string_view line) {
  return line.starts_with(cell_gap) && line.find_first_not_of(' ') != std::string_view::npos;
}

/// Calls `shown(line, next line)` for each line, and joins what it returns.
template <class Shown>
std::string by_lines(std::string_view text, const Shown& shown) {
  std::string made;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    made += shown(line, text.substr(0, text.find('\n')));
    if (end != std::string_view::npos) made += '\n';
  }
  return made;
}

/// The first `count` bytes of `text` in a style, at most to the end of its first line.
std::string with_styled_start(const std::string& text, std::size_t count, Style style,
                              Stream stream) {
  count = std::min({count, text.size(), text.find('\n')});
  return styled(style, std::string_view(text).substr(0, count), stream) + text.substr(count);
}

}  // namespace

void set_color(ColorMode mode) {
  chosen_color = mode;
}

bool is_terminal(Stream stream) {
  const std::string_view term = environment("TERM");
  return isatty(descriptor(stream)) == 1 && !term.empty() && term != "dumb";
}

bool has_color(Stream stream) {
  if (chosen_color != ColorMode::automatic) return chosen_color == ColorMode::always;
  return is_terminal(stream) && environment("NO_COLOR").empty();
}

std::size_t terminal_width(Stream stream) {
  constexpr std::size_t usual = 80, least = 20;
  // Without TERM nothing is known: in a browser standard output says that it is a terminal.
  if (isatty(descriptor(stream)) != 1 || environment("TERM").empty()) return unlimited;
  std::size_t columns = 0;
  const std::string_view said = environment("COLUMNS");
  std::from_chars(said.data(), said.data() + said.size(), columns);
  winsize size{};
  if (columns == 0 && ioctl(descriptor(stream), TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return columns == 0 ? usual : std::max(columns, least);
}

std::string styled(Style style, std::string_view text, Stream stream) {
  if (text.empty() || !has_color(stream)) return std::string(text);
  const std::string_view code = style == Style::heading   ? "1"
                                : style == Style::warning ? "1;33"
                                                          : "1;31";
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

std::string linked(std::string_view text, const std::string& target, Stream stream) {
  // The console of Linux prints what it does not know of a link.
  if (!has_color(stream) || environment("TERM") == "linux") return std::string(text);
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(target, failed);
  if (failed) return std::string(text);
  return fmt::format("\033]8;;file://{}\033\\{}\033]8;;\033\\", address_of(whole.string()), text);
}

std::string wrapped_line(std::string_view line, std::size_t width) {
  if (report::width(line) <= width) return std::string(line);
  const Wrap wrap = wrap_of(line, width);
  const std::string margin(wrap.indent, ' ');
  std::string made;
  std::size_t column = 0, start = 0;
  while (start < line.size()) {
    const std::size_t word = std::min(line.find_first_not_of(' ', start), line.size());
    const std::size_t end = std::min(line.find(' ', word), line.size());
    const std::size_t wide = report::width(line.substr(word, end - word));
    const bool ends = start <= wrap.end && word > wrap.end;
    if (ends || (column + (word - start) + wide > width && column > margin.size())) {
      made += '\n' + margin;
      column = margin.size() + wide;
    } else {
      made += line.substr(start, word - start);
      column += (word - start) + wide;
    }
    made += line.substr(word, end - word);
    start = end;
  }
  return made;
}

std::string page_for(Stream stream, std::string_view text) {
  if (terminal_width(stream) == unlimited && !has_color(stream)) return std::string(text);
  return by_lines(text, [&](std::string_view line, std::string_view next) {
    const std::string shown = wrapped_line(line, terminal_width(stream));
    if (line.starts_with(warning_label))
      return with_styled_start(shown, warning_label.size(), Style::warning, stream);
    const bool heads = !line.empty() && line.front() != ' ' && is_indented(next);
    return heads ? with_styled_start(shown, line.find(cell_gap), Style::heading, stream) : shown;
  });
}

std::string faults_for(Stream stream, Style style, std::string_view text) {
  if (terminal_width(stream) == unlimited && !has_color(stream)) return std::string(text);
  return by_lines(text, [&](std::string_view line, std::string_view) {
    if (line.starts_with(document_label)) {
      const std::string place = document(line.substr(document_label.size()));
      return std::string(document_label) + linked(place, place, stream);
    }
    const std::string shown = wrapped_line(line, terminal_width(stream));
    if (line.starts_with(remedy_label))
      return with_styled_start(shown, remedy_label.size(), Style::heading, stream);
    const std::size_t place = line.find(": ");
    const bool begins = !line.starts_with(" ") && place != std::string_view::npos;
    return begins ? with_styled_start(shown, place + 1, style, stream) : shown;
  });
}

}  // namespace mahlwerk::commands
