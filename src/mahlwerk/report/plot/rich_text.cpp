// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/rich_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

/// A part of a text in one style.
struct TextRun {
  std::string text;
  bool italic = false;
  int shift = 0;  // -1 subscript, 1 superscript
};

std::vector<TextRun> runs_of(std::string_view text) {
  std::vector<TextRun> runs{{}};
  bool italic = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool shifts = (text[i] == '_' || text[i] == '^') && text.substr(i + 1).starts_with('{');
    const std::size_t end = shifts ? text.find('}', i) : std::string_view::npos;
    if (end != std::string_view::npos) {
      runs.push_back(
          {std::string(text.substr(i + 2, end - i - 2)), false, text[i] == '_' ? -1 : 1});
      runs.push_back({"", italic});
      i = end;
    } else if (text[i] == '$' && (italic || text.find('$', i + 1) != std::string_view::npos)) {
      italic = !italic;
      runs.push_back({"", italic});
    } else {
      runs.back().text += text[i];
    }
  }
  std::erase_if(runs, [](const TextRun& run) { return run.text.empty(); });
  return runs;
}

}  // namespace

std::string rich_text(std::string_view text, double font) {
  std::string svg;
  double raised = 0;
  for (const TextRun& run : runs_of(text)) {
    const double to = font * (run.shift > 0 ? 0.36 : run.shift < 0 ? -0.22 : 0);
    std::string style;
    if (to != raised) style += fmt::format(" dy=\"{:.3g}\"", raised - to);
    if (run.shift != 0) style += fmt::format(" font-size=\"{:.3g}\"", 0.75 * font);
    if (run.italic) style += " font-style=\"italic\"";
    if (!style.empty() && (run.text.starts_with(' ') || run.text.ends_with(' ')))
      style += " xml:space=\"preserve\"";  // librsvg drops spaces at the ends of a tspan
    raised = to;
    svg += style.empty() ? escaped(run.text)
                         : fmt::format("<tspan{}>{}</tspan>", style, escaped(run.text));
  }
  return svg;
}

std::string plain_text(std::string_view text) {
  std::string plain;
  for (const TextRun& run : runs_of(text)) plain += run.text;
  return plain;
}

std::vector<std::string> wrapped(std::string_view text, std::size_t letters) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word(text.substr(at, end - at));
    at = end + 1;
    if (!lines.empty() && width(plain_text(lines.back() + " " + word)) <= letters)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

std::vector<std::string> balanced(std::string_view text, std::size_t letters) {
  std::vector<std::string> lines = wrapped(text, letters);
  for (std::size_t fewer = letters; fewer-- > 1;) {
    std::vector<std::string> narrower = wrapped(text, fewer);
    if (narrower.size() > lines.size()) break;
    lines = std::move(narrower);
  }
  return lines;
}

}  // namespace mahlwerk::report
