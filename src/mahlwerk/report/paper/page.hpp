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

/// A campaign of a paper, run: its numbers, and its results point by point for what is drawn of
/// single balls.
struct RunCampaign {
  Campaign numbers;
  std::vector<results::Outcome> outcomes;
  double seconds = 0;  ///< [s] of computing, on one core
};

struct PaperPicture {
  std::string file;  ///< "figure-6-collision_rate_above_threshold.svg"
  std::string svg;
  const PaperFigure* figure = nullptr;
};

/// A paper with what its campaigns, just run, gave.
struct PaperResult {
  const Paper* paper = nullptr;
  std::vector<PaperPicture> pictures;
  std::vector<Verdict> verdicts;          ///< by claim
  std::map<std::string, double> seconds;  ///< by campaign
  /// What was set instead of what the campaigns say, "run.time = 2 s". The paper's words about why
  /// a claim holds are then left out: they are about its own settings.
  std::vector<std::string> changed = {};
  results::NoticeCounts notices = {};  ///< of the points of all campaigns
  std::size_t points = 0;
};
PaperResult paper_result(const Paper& paper, const std::map<std::string, RunCampaign>& run);

/// paper.html of a paper: figures, and each claim with what was found.
std::string paper_page(const PaperResult& result, std::string_view version);
/// The claims for the terminal.
std::string claims_text(const PaperResult& result);
/// The claims as a table in Markdown, and as CSV.
std::string claims_markdown(const PaperResult& result);
std::string claims_csv(const PaperResult& result);

}  // namespace mahlwerk::report
