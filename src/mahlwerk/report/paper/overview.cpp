// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::array<std::string_view, 3> statuses{"verified", "quoted", "unverified"};
constexpr double close = 0.1;  // [1] deviation of a set that is called exact

std::string status_of(const Paper& paper, const Claim& claim) {
  const Measurement* measured = paper.measurement(claim.measured);
  return measured == nullptr ? ""
                             : std::string(statuses[static_cast<std::size_t>(measured->status)]);
}

std::string percent(const OverviewRow& row) {
  return std::isfinite(row.deviation) ? fmt::format("{:.0f} %", 100 * row.deviation) : "";
}

}  // namespace

std::vector<OverviewRow> overview_rows(const PaperResult& result, std::string_view folder) {
  std::vector<OverviewRow> rows;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const Claim& claim = result.paper->claims[i];
    rows.push_back({.folder = std::string(folder),
                    .title = result.paper->title,
                    .claim = claim.says,
                    .found = result.verdicts[i].finding,
                    .status = status_of(*result.paper, claim),
                    .holds = result.verdicts[i].holds,
                    .deviation = result.verdicts[i].deviation});
  }
  return rows;
}

std::string overview_score(const std::vector<OverviewRow>& rows) {
  std::set<std::string> sets, judged, exact;
  for (const OverviewRow& row : rows) {
    sets.insert(row.folder);
    if (row.holds != Holds::undecided) judged.insert(row.folder);
    if (row.status != "unverified" && row.deviation <= close) exact.insert(row.folder);
  }
  std::string counts;
  for (const Holds one : {Holds::yes, Holds::partly, Holds::no, Holds::undecided}) {
    const auto count = std::ranges::count(rows, one, &OverviewRow::holds);
    if (count > 0) counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", word(one), count);
  }
  return fmt::format(
      "{} sets of measured data, {} with a verdict. Of {} claims: {}. In {} sets a whole band lies "
      "within {:.0f} % of the measured values{}{}.",
      sets.size(), judged.size(), rows.size(), counts, exact.size(), 100 * close,
      exact.empty() ? "" : ": ", fmt::join(exact, ", "));
}

std::string overview_markdown(const std::vector<OverviewRow>& rows) {
  std::string text =
      "| set | measured | measured and predicted | agrees | largest deviation | numbers |\n"
      "|---|---|---|---|---|---|\n";
  for (const OverviewRow& row : rows)
    text += fmt::format("| [{0}](../validation/{0}/README.md) | {1} | {2} | {3} | {4} | {5} |\n",
                        row.folder, markdown_cell(row.claim), markdown_cell(row.found),
                        word(row.holds), percent(row), row.status);
  return text;
}

std::string overview_csv(const std::vector<OverviewRow>& rows) {
  const auto line = [](std::initializer_list<std::string> cells) {
    std::vector<std::string> quoted;
    for (const std::string& one : cells) quoted.push_back(results::csv_cell(one));
    return results::csv_line(quoted);
  };
  std::string text = line({"set", "measured", "found", "agrees", "largest_deviation", "numbers"});
  for (const OverviewRow& row : rows)
    text += line({row.folder, row.claim, row.found, std::string(word(row.holds)),
                  std::isfinite(row.deviation) ? fmt::format("{:.4g}", row.deviation) : "",
                  row.status});
  return text;
}

std::string overview_page(const std::vector<OverviewRow>& rows, std::string_view version) {
  std::string body = fmt::format(
      "<p class=\"lead\">{}</p>\n<div class=\"wide\"><table>\n<thead><tr><th>Set</th>"
      "<th>Measured</th><th>Measured and predicted</th><th>Agrees</th><th class=\"n\">Largest "
      "deviation</th><th>Numbers</th></tr></thead>\n<tbody>\n",
      escaped(overview_score(rows)));
  for (const OverviewRow& row : rows)
    body += fmt::format(
        "<tr><td><a href=\"../{0}/paper.html\">{1}</a></td><td>{2}</td><td>{3}</td>"
        "<td><b>{4}</b></td><td class=\"n\">{5}</td><td>{6}</td></tr>\n",
        escaped(row.folder), escaped(row.title), escaped(row.claim), escaped(row.found),
        word(row.holds), percent(row), escaped(row.status));
  body += "</tbody></table></div>\n";
  return page("Measured mills and predictions", body,
              fmt::format("Mahlwerk {}.", escaped(version)));
}

}  // namespace mahlwerk::report
