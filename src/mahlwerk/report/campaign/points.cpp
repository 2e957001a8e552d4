// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/campaign/points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace mahlwerk::report {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_rows = 1000;

/// Script: a click on a column head sorts, a second click reverses the order; empty cells stay
/// last.
constexpr std::string_view sorting = R"js(<script>
for(const head of document.querySelectorAll("#points thead th"))head.onclick=()=>{
 const i=head.cellIndex,up=head.ariaSort!=="ascending",body=document.querySelector("#points tbody"),
 key=row=>{const c=row.cells[i];return c?c.dataset.v??c.textContent:""},rows=[...body.rows];
 rows.sort((a,b)=>{const p=key(a),q=key(b);if(!p||!q)return !p-!q;
  const d=isNaN(p)||isNaN(q)?p.localeCompare(q,"en",{numeric:true}):p-q;return up?d:-d});
 for(const h of head.parentNode.cells)h.ariaSort=null;
 head.ariaSort=up?"ascending":"descending";body.append(...rows)};
</script>
)js";

std::string heads(const Sheet& sheet, bool regimes) {
  const Campaign& c = sheet.campaign;
  std::string text = "<th class=\"n\">run</th>";
  for (std::size_t i = 0; i < c.keys.size(); ++i)
    text += fmt::format("<th{}>{}</th>", sheet.keys[i].numeric() ? " class=\"n\"" : "",
                        escaped(axis_label(c.keys[i])));
  if (regimes) text += "<th>regime</th>";
  for (const std::size_t i : sheet.shown)
    text += fmt::format("<th class=\"n\" title=\"{}\">{}</th>", escaped(c.columns[i].about),
                        escaped(column_label(c.columns[i], sheet.multiples[i])));
  if (any_warnings(c)) text += "<th>warnings</th>";
  return text;
}

/// Table cell of a key's value; numbers without unit, which is in the head.
std::string value_cell(const Sheet& sheet, std::size_t point, std::size_t key) {
  const Levels& levels = sheet.keys[key];
  const std::vector<std::string>& values = sheet.campaign.points[point].values;
  const std::string text = key < values.size() ? values[key] : "";
  if (!levels.numeric()) return fmt::format("<td>{}</td>", escaped(text));
  const std::string_view number(text.data(),
                                text.find(' ') == std::string::npos
                                    ? text.size() - sheet.campaign.keys[key].unit.size()
                                    : text.find(' '));
  return fmt::format("<td class=\"n\" data-v=\"{}\">{}</td>", levels.numbers[levels.of[point]],
                     escaped(number));
}

/// Warning codes separated by ", ", so that a narrow column may break between them.
std::string spaced(std::string_view codes) {
  std::string text;
  for (const char c : codes) {
    text += c == ';' ? ',' : c;
    if (c == ';') text += ' ';
  }
  return text;
}

std::string row(const Sheet& sheet, std::size_t point, bool regimes, bool warnings) {
  const Campaign& c = sheet.campaign;
  const Point& p = c.points[point];
  std::string text =
      p.folder.empty()
          ? fmt::format("<tr><td class=\"n\">{}</td>", p.number)
          : fmt::format("<tr><td class=\"n\"><a href=\"{}\">{}</a></td>",
                        escaped((fs::path(p.folder) / "report.html").generic_string()), p.number);
  for (std::size_t i = 0; i < c.keys.size(); ++i) text += value_cell(sheet, point, i);
  if (!p.failure.empty() || p.waiting())
    return text + fmt::format("<td colspan=\"{}\" data-v=\"\"{}>{}</td></tr>\n",
                              std::max<std::size_t>(
                                  sheet.shown.size() + (regimes ? 1 : 0) + (warnings ? 1 : 0), 1),
                              p.waiting() ? "" : " class=\"failed\"",
                              escaped(missing_reason(p, 80)));
  if (regimes) text += fmt::format("<td>{}</td>", escaped(p.regime));
  for (const std::size_t i : sheet.shown) {
    const double v = value_at(p, i);
    const Multiple& m = sheet.multiples[i];
    text += fmt::format("<td class=\"n\" data-v=\"{}\">{}</td>",
                        std::isfinite(v) ? fmt::format("{}", v) : "",
                        escaped(readable_within(v, half_width_at(p, i), c.columns[i].unit,
                                                results::range_of(c.columns[i].name), m.factor)
                                    .number));
  }
  if (warnings) text += fmt::format("<td>{}</td>", escaped(spaced(p.warnings)));
  return text + "</tr>\n";
}

/// "3, 7, 12", or the first ten of many: "3, 7, ... (40 in all)".
std::string listed(const std::vector<std::size_t>& numbers) {
  constexpr std::size_t most = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(numbers.size(), most); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
  return numbers.size() > most ? fmt::format("{}, ... ({} in all)", text, numbers.size()) : text;
}

/// A message as HTML, with <br/> for line ends.
std::string in_lines(std::string_view message) {
  std::string text;
  for (const char c : escaped(message))
    text += c == '\n' ? std::string("<br/>") : std::string(1, c);
  return text;
}

/// Sentence on the shown quantity with the largest ratio of maximum to minimum; empty if none
/// changes.
std::string highlights(const Sheet& sheet) {
  const Point *from = nullptr, *to = nullptr;
  double most = 0;
  std::size_t what = 0;
  for (const std::size_t column : sheet.shown) {
    const Point *least = nullptr, *largest = nullptr;
    for (const Point& p : sheet.campaign.points) {
      const double v = value_at(p, column);
      if (!std::isfinite(v)) continue;
      if (least == nullptr || v < value_at(*least, column)) least = &p;
      if (largest == nullptr || v > value_at(*largest, column)) largest = &p;
    }
    const double ratio = value_at(*largest, column) / value_at(*least, column);
    if (!(value_at(*least, column) > 0) || !(ratio > most)) continue;
    most = ratio;
    what = column;
    from = least;
    to = largest;
  }
  constexpr double same = 1.001;
  if (!(most > same)) return "";
  const Column& c = sheet.campaign.columns[what];
  const auto told = [&, points = sheet.campaign.points.data()](const Point& p) {
    return fmt::format("{} ({})",
                       readable_within(value_at(p, what), half_width_at(p, what), c.unit,
                                       results::range_of(c.name))
                           .text(),
                       sheet.others(static_cast<std::size_t>(&p - points), {}));
  };
  return fmt::format(" The largest change is that of {}: from {} to {}, {:.3g} times as much.",
                     label(c.name), told(*from), told(*to), most);
}

std::string varied_keys(const Sheet& sheet) {
  std::string text;
  for (std::size_t i = 0; i < sheet.keys.size(); ++i) {
    const Levels& l = sheet.keys[i];
    const std::string key = sheet.campaign.keys[i].key;
    if (l.size() == 0) continue;
    text += (text.empty() ? "" : "; ") + key;
    if (l.size() == 1)
      text += fmt::format(" ({} at all points)", l.texts[0]);
    else if (l.numeric())
      text += fmt::format(" from {} to {} ({} values)", l.texts.front(), l.texts.back(), l.size());
    else if (constexpr std::size_t few = 4; l.size() <= few)
      for (std::size_t k = 0; k < l.size(); ++k)
        text += (k == 0 ? " (" : ", ") + l.texts[k] + (k + 1 == l.size() ? ")" : "");
    else
      text += fmt::format(" ({} values)", l.size());
  }
  return text;
}

}  // namespace

std::string campaign_lead(const Sheet& sheet) {
  const Campaign& c = sheet.campaign;
  if (c.points.empty()) return "<p class=\"lead\">No point has been computed yet.</p>\n";
  const auto failed =
      std::ranges::count_if(c.points, [](const Point& p) { return !p.failure.empty(); });
  const auto all = static_cast<std::ptrdiff_t>(c.points.size());
  std::string text = fmt::format("{} point{}.", all, all == 1 ? "" : "s");
  if (const std::string varies = varied_keys(sheet); !varies.empty())
    text += fmt::format(" Varied keys: {}.", varies);
  if (failed == all)
    text += all == 1 ? " It failed." : " All of them failed.";
  else if (failed > 0)
    text += fmt::format(" {} point{} failed.", failed, failed == 1 ? "" : "s");
  if (const auto waiting = std::ranges::count(c.points, true, &Point::waiting); waiting > 0)
    text += fmt::format(" {} wait{} to be run.", waiting, waiting == 1 ? "s" : "");
  std::map<std::string, std::size_t> regimes;
  for (const Point& p : c.points)
    if (!p.regime.empty()) ++regimes[p.regime];
  std::string moves;
  for (const auto& [regime, points] : regimes)
    moves += fmt::format("{}{} at {}", moves.empty() ? "" : ", ", regime, points);
  if (!moves.empty()) text += fmt::format(" The charge is {}.", moves);
  if (!sheet.shown.empty()) text += highlights(sheet);
  return fmt::format("<p class=\"lead\">{}</p>\n", escaped(text));
}

std::string failures(const Campaign& c) {
  constexpr std::size_t most = 20, long_enough = 400;
  std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
  std::map<std::string, std::size_t> places;
  for (const Point& p : c.points) {
    if (p.failure.empty()) continue;
    const auto [at, is_new] = places.emplace(p.failure, groups.size());
    if (is_new) groups.push_back({p.failure, {}});
    groups[at->second].second.push_back(p.number);
  }
  if (groups.empty()) return "";
  std::string rows;
  for (std::size_t i = 0; i < std::min(groups.size(), most); ++i)
    rows +=
        fmt::format("<p>Run{} {}: {}</p>\n", groups[i].second.size() == 1 ? "" : "s",
                    listed(groups[i].second), in_lines(shortened(groups[i].first, long_enough)));
  if (groups.size() > most)
    rows += fmt::format("<p>... and {} more reasons.</p>\n", groups.size() - most);
  return fmt::format("<div class=\"box warn\"><h2>Failed</h2>\n{}</div>\n", rows);
}

std::string point_table(const Sheet& sheet) {
  const Campaign& c = sheet.campaign;
  if (c.points.empty()) return "";
  const bool regimes = regimes_differ(c), warnings = any_warnings(c);
  std::string body;
  const std::size_t rows = std::min(c.points.size(), max_rows);
  for (std::size_t i = 0; i < rows; ++i) body += row(sheet, i, regimes, warnings);
  const std::string rest =
      rows < c.points.size()
          ? fmt::format("<p>The first {} of {} points; campaign.csv has all of them.</p>\n", rows,
                        c.points.size())
          : "";
  return fmt::format(
      "<h2>Points</h2>\n{}<div class=\"wide\"><table "
      "id=\"points\">\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></"
      "div>\n<p><small>A click on a column head sorts. ± is the 95 % confidence half-width over "
      "independent replicates "
      "(Student's t).</small></p>\n{}",
      rest, heads(sheet, regimes), body, sorting);
}

}  // namespace mahlwerk::report
