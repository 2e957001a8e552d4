// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// Numbers of the claims of the paper, or of our own statements.
std::vector<std::size_t> claims_of(const PaperResult& result, bool own) {
  std::vector<std::size_t> those;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i)
    if (result.paper->claims[i].own == own) those.push_back(i);
  return those;
}

/// Counts by verdict: "Of 3 claims: yes 2, no 1."
std::string score_of(const PaperResult& result, bool own) {
  const std::vector<std::size_t> those = claims_of(result, own);
  std::string text;
  for (const Holds one : {Holds::yes, Holds::partly, Holds::no, Holds::undecided}) {
    const auto count = std::ranges::count_if(
        those, [&](std::size_t i) { return result.verdicts[i].holds == one; });
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word(one), count);
  }
  return fmt::format("Of {} {}{}{}: {}.", those.size(), own ? "statement" : "claim",
                     those.size() == 1 ? "" : "s", own ? " of ours" : "", text);
}

/// Counts for the paper's claims and, apart, for our own statements.
std::string score(const PaperResult& result) {
  std::string text = score_of(result, false);
  if (!claims_of(result, true).empty()) text += " " + score_of(result, true);
  return text;
}

std::string why(const PaperResult& result, std::size_t claim) {
  return result.changed.empty() ? result.paper->claims[claim].why : "";
}

/// Sentence that lists the overrides; empty if there are none.
std::string changes(const PaperResult& result) {
  if (result.changed.empty()) return "";
  return fmt::format("Run with {}, unlike the campaigns of the paper.",
                     fmt::join(result.changed, ", "));
}

double whole_time(const PaperResult& result) {
  double sum = 0;
  for (const auto& [name, seconds] : result.seconds) sum += seconds;
  return sum;
}

std::string claim_rows(const PaperResult& result, bool own) {
  std::string rows;
  for (const std::size_t i : claims_of(result, own)) {
    const Claim& claim = result.paper->claims[i];
    const Verdict& judged = result.verdicts[i];
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td><b>{}</b></td><td>{}</td></tr>\n",
                        escaped(claim.figure), escaped(claim.says), escaped(judged.finding),
                        word(judged.holds), escaped(why(result, i)));
  }
  return rows;
}

/// The tables of the paper, with their titles and notes.
std::string table_sections(const PaperResult& result) {
  std::string body;
  for (const MadeTable& made : result.tables) {
    std::string rows;
    for (const std::vector<std::string>& row : made.rows) {
      rows += "<tr>";
      for (const std::string& cell : row) rows += fmt::format("<td>{}</td>", escaped(cell));
      rows += "</tr>\n";
    }
    std::string heads;
    for (const std::string& head : made.heads) heads += fmt::format("<th>{}</th>", escaped(head));
    body += fmt::format(
        "<h3>{}</h3>\n<div class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n"
        "{}</tbody></table></div>\n<p><small>{}{}{}</small></p>\n",
        escaped(made.table->title), heads, rows, escaped(made.note),
        made.table->about.empty() ? "" : " ", escaped(made.table->about));
  }
  return body.empty() ? "" : "<h2>Tables</h2>\n" + body;
}

std::string claim_table(const PaperResult& result, bool own) {
  return fmt::format(
      "<div class=\"wide\"><table>\n<thead><tr><th>Figure</th><th>{}</th><th>We find</th><th>Holds"
      "</th><th>Why</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      own ? "We say" : "The paper says", claim_rows(result, own));
}

std::string campaign_rows(const PaperResult& result) {
  std::string rows;
  for (const auto& [name, seconds] : result.seconds)
    rows += fmt::format(
        "<tr><td><a href=\"{0}/campaign.html\">{0}</a></td><td class=\"n\">{1:.2g} "
        "s</td></tr>\n",
        escaped(name), seconds);
  return rows;
}

}  // namespace

std::string markdown_cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

std::string paper_page(const PaperResult& result, std::string_view version) {
  const Paper& paper = *result.paper;
  std::string body =
      fmt::format("<p class=\"lead\">{}. {}</p>\n", escaped(paper.source), score(result));
  if (!result.changed.empty())
    body += fmt::format("<div class=\"box warn\"><p>{}</p></div>\n", escaped(changes(result)));
  body += notice_boxes(result.notices, result.points, "point");
  if (!paper.about.empty())
    body += fmt::format("<section class=\"box\"><p>{}</p></section>\n", escaped(paper.about));
  body += "<h2>Claims of the paper and findings</h2>\n" + claim_table(result, false);
  if (!claims_of(result, true).empty())
    body += "<h2>Statements of ours, not of the paper</h2>\n" + claim_table(result, true);
  body +=
      "<p><small>± is the 95 % confidence half-width over independent replicates. Every number in "
      "\"We find\" is from the runs just made; docs/papers.md has the rules by which a claim "
      "holds.</small></p>\n<h2>Figures</h2>\n";
  for (const PaperPicture& picture : result.pictures)
    if (!picture.svg.empty())
      body += fmt::format("<figure>\n{}<figcaption><b>Figure {}.</b> {}</figcaption>\n</figure>\n",
                          picture.svg, escaped(picture.number), escaped(picture.caption));
  body += table_sections(result);
  body += fmt::format(
      "<h2>Campaigns</h2>\n<div class=\"wide\"><table>\n<thead><tr><th>Campaign</th><th "
      "class=\"n\">CPU time</th></tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
      campaign_rows(result));
  return page(paper.title, body,
              fmt::format("Mahlwerk {}, {} s of CPU time.", escaped(version),
                          two_digits(whole_time(result))));
}

std::string captions_markdown(const PaperResult& result) {
  std::string text;
  for (const PaperPicture& picture : result.pictures)
    if (!picture.svg.empty())
      text += fmt::format("{}**Figure {}.** {}\n", text.empty() ? "" : "\n", picture.number,
                          picture.caption);
  return text;
}

std::string claims_text(const PaperResult& result) {
  std::string text;
  for (const bool own : {false, true}) {
    const std::vector<std::size_t> those = claims_of(result, own);
    if (own && !those.empty()) text += "\nstatements of ours, not of the paper:\n";
    for (const std::size_t i : those) {
      const Claim& claim = result.paper->claims[i];
      const Verdict& judged = result.verdicts[i];
      text += fmt::format("{:<6} {:<14} {}\n{:22}{}\n", claim.figure, word(judged.holds),
                          claim.says, "", judged.finding);
      if (!why(result, i).empty()) text += fmt::format("{:22}why: {}\n", "", why(result, i));
    }
  }
  const std::string changed = changes(result);
  const std::string warned = notice_lines(result.notices, result.points, "point");
  return fmt::format("{}\n{}\n{}{}{}{}", text, score(result), changed, changed.empty() ? "" : "\n",
                     warned.empty() ? "" : "\n", warned);
}

std::string claims_markdown(const PaperResult& result) {
  std::string text;
  for (const bool own : {false, true}) {
    const std::vector<std::size_t> those = claims_of(result, own);
    if (own && those.empty()) continue;
    text += fmt::format("{}| figure | {} | we find | holds | why |\n|---|---|---|---|---|\n",
                        text.empty() ? "" : "\n", own ? "we say" : "the paper says");
    for (const std::size_t i : those) {
      const Claim& claim = result.paper->claims[i];
      text += fmt::format("| {} | {} | {} | {} | {} |\n", markdown_cell(claim.figure),
                          markdown_cell(claim.says), markdown_cell(result.verdicts[i].finding),
                          word(result.verdicts[i].holds), markdown_cell(why(result, i)));
    }
  }
  return text;
}

std::string table_markdown(const MadeTable& made) {
  std::string text, rule;
  for (const std::string& head : made.heads) {
    text += "| " + markdown_cell(head) + " ";
    rule += "|---";
  }
  text += "|\n" + rule + "|\n";
  for (const std::vector<std::string>& row : made.rows) {
    for (const std::string& one : row) text += "| " + markdown_cell(one) + " ";
    text += "|\n";
  }
  return text;
}

std::string claims_csv(const PaperResult& result) {
  const auto line = [](std::initializer_list<std::string_view> cells) {
    std::vector<std::string> quoted;
    for (const std::string_view cell : cells) quoted.push_back(results::csv_cell(cell));
    return results::csv_line(quoted);
  };
  std::string text = line({"figure", "the_paper_says", "we_find", "holds", "why", "own"});
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const Claim& claim = result.paper->claims[i];
    text += line({claim.figure, claim.says, result.verdicts[i].finding,
                  word(result.verdicts[i].holds), why(result, i), claim.own ? "yes" : "no"});
  }
  return text;
}

}  // namespace mahlwerk::report
