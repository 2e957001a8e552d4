// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// Number of claims by verdict, as a sentence.
std::string score(const PaperResult& result) {
  std::string text;
  for (const Holds one : {Holds::yes, Holds::partly, Holds::no, Holds::undecided}) {
    const auto count = std::ranges::count(result.verdicts, one, &Verdict::holds);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", word(one), count);
  }
  return fmt::format("Of {} claim{}: {}.", result.verdicts.size(),
                     result.verdicts.size() == 1 ? "" : "s", text);
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

std::string claim_rows(const PaperResult& result) {
  std::string rows;
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
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
  body += fmt::format(
      "<h2>Claims of the paper and findings</h2>\n<div class=\"wide\"><table>\n<thead><tr>"
      "<th>Figure</th><th>The paper says</th><th>We find</th><th>Holds</th><th>Why</th></tr>"
      "</thead>\n<tbody>\n{}</tbody></table></div>\n<p><small>± is the 95 % confidence half-width "
      "over independent replicates. Every number in \"We find\" is from the runs just made; "
      "docs/papers.md has the rules by which a claim holds.</small></p>\n<h2>Figures</h2>\n",
      claim_rows(result));
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
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const Claim& claim = result.paper->claims[i];
    const Verdict& judged = result.verdicts[i];
    text += fmt::format("{:<6} {:<14} {}\n{:22}{}\n", claim.figure, word(judged.holds), claim.says,
                        "", judged.finding);
    if (!why(result, i).empty()) text += fmt::format("{:22}why: {}\n", "", why(result, i));
  }
  const std::string changed = changes(result);
  const std::string warned = notice_lines(result.notices, result.points, "point");
  return fmt::format("{}\n{}\n{}{}{}{}", text, score(result), changed, changed.empty() ? "" : "\n",
                     warned.empty() ? "" : "\n", warned);
}

std::string claims_markdown(const PaperResult& result) {
  std::string text = "| figure | the paper says | we find | holds | why |\n|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const Claim& claim = result.paper->claims[i];
    text += fmt::format("| {} | {} | {} | {} | {} |\n", markdown_cell(claim.figure),
                        markdown_cell(claim.says), markdown_cell(result.verdicts[i].finding),
                        word(result.verdicts[i].holds), markdown_cell(why(result, i)));
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
  std::string text = line({"figure", "the_paper_says", "we_find", "holds", "why"});
  for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
    const Claim& claim = result.paper->claims[i];
    text += line({claim.figure, claim.says, result.verdicts[i].finding,
                  word(result.verdicts[i].holds), why(result, i)});
  }
  return text;
}

}  // namespace mahlwerk::report
