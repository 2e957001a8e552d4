// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/parameters.hpp"

#include <fmt/format.h>

#include <array>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/page.hpp"

namespace mahlwerk::report {

std::string parameter_table(const ParameterEstimates& found, std::string_view head) {
  std::vector<std::array<std::string, 4>> lines{{std::string(head), "value", "95 % interval", ""}};
  for (const FittedParameter& p : found.parameters)
    lines.push_back(
        {p.name, p.text.value, p.interval_text(), p.determined ? "" : "NOT DETERMINED"});
  return aligned(lines);
}

std::string remark_lines(const ParameterEstimates& found) {
  std::string text;
  for (const FittedParameter& p : found.parameters)
    for (const std::string& remark : p.remarks) text += fmt::format("{}: {}.\n", p.name, remark);
  for (const std::string& remark : found.remarks) text += remark + ".\n";
  return text;
}

std::string value_cell_text(const FittedParameter& p) {
  return p.determined ? escaped(p.text.value) : "<s>" + escaped(p.text.value) + "</s>";
}

std::string remark_boxes(const ParameterEstimates& found) {
  std::string text;
  for (const FittedParameter& p : found.parameters) {
    std::string words;
    for (const std::string& remark : p.remarks)
      words += (words.empty() ? " " : "; ") + escaped(remark);
    if (!words.empty()) words += ".";
    if (!p.determined)
      text += note_box(fmt::format("<b>The data do not determine <code>{}</code>:</b>{}",
                                   escaped(p.name), words),
                       true);
    else if (!words.empty())
      text += note_box(fmt::format("<code>{}</code>:{}", escaped(p.name), words), false);
  }
  for (const std::string& remark : found.remarks) text += note_box(escaped(remark) + ".", true);
  return text;
}

std::string correlation_table(const ParameterEstimates& found, std::string_view what,
                              int decimals) {
  if (found.parameters.size() < 2) return "";
  std::string head, rows;
  for (std::size_t i = 0; i < found.parameters.size(); ++i) {
    const std::string name = escaped(found.parameters[i].name);
    head += fmt::format("<th class=\"n\"><code>{}</code></th>", name);
    rows += fmt::format("<tr><th scope=\"row\"><code>{}</code></th>", name);
    for (const double c : found.correlation[i])
      rows += fmt::format("<td class=\"n\">{:.{}f}</td>", c, decimals);
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h2>Correlation of the {}</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th>{}"
      "</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      what, head, rows);
}

}  // namespace mahlwerk::report
