// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/paper/claims.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// A finished campaign of a paper: its numbers, and the outcome of each point for pictures of
/// single balls.
struct RunCampaign {
  Campaign numbers;
  std::vector<results::Outcome> outcomes;
  double seconds = 0;  ///< [s] CPU time
};

/// A figure with all its panels.
struct PaperPicture {
  std::string file;                           ///< name without ending: "figure-6"
  std::string number;                         ///< of the paper: "6"
  std::string svg;                            ///< empty if nothing was recorded that it could draw
  std::string caption;                        ///< what its panels show
  std::map<std::string, std::string> tables;  ///< the drawn numbers: "figure-6a.csv" and its text
};

/// A table with its cells as text.
struct MadeTable {
  const PaperTable* table = nullptr;
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
  std::string csv;   ///< the numbers, in SI units
  std::string note;  ///< sentence below it; may be empty
};

/// A paper with the results of its campaigns.
struct PaperResult {
  const Paper* paper = nullptr;
  std::vector<PaperPicture> pictures;
  std::vector<MadeTable> tables = {};
  std::vector<Verdict> verdicts;          ///< by claim
  std::map<std::string, double> seconds;  ///< by campaign
  /// Overrides of the campaigns' settings, "run.time = 2 s". The paper's explanations of claims are
  /// then omitted: they apply to the original settings.
  std::vector<std::string> changed = {};
  results::NoticeCounts notices = {};  ///< of the points of all campaigns
  std::size_t points = 0;
};
PaperResult paper_result(const Paper& paper, const std::map<std::string, RunCampaign>& run);

/// paper.html: figures, and each claim with its finding.
std::string paper_page(const PaperResult& result, std::string_view version);
/// figures/captions.md: the captions of the figures.
std::string captions_markdown(const PaperResult& result);
/// A cell of a table in Markdown: bars are escaped.
std::string markdown_cell(std::string text);
/// tables/NAME.md: the table in Markdown.
std::string table_markdown(const MadeTable& table);
/// The claims for the terminal.
std::string claims_text(const PaperResult& result);
/// The claims as a table in Markdown, and as CSV.
std::string claims_markdown(const PaperResult& result);
std::string claims_csv(const PaperResult& result);

}  // namespace mahlwerk::report
