// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "mahlwerk/results/files/folder.hpp"

// The runs of a paper's campaigns.
namespace mahlwerk::commands {

/// A paper with the cases of its campaigns.
struct PaperJob {
  report::Paper paper;
  std::map<std::string, cases::Case> whole;                ///< by campaign: its case with [sweep]
  std::map<std::string, std::vector<cases::Case>> points;  ///< by campaign: its points
  std::unique_ptr<results::Folder> folder;
};

struct PaperRuns {
  std::map<std::string, report::RunCampaign> campaigns;
  std::vector<Fault> unwritten;  ///< why the results of points could not be written; else empty
};

/// Runs all points of all campaigns of the paper together, so that no core idles between campaigns,
/// and writes the result of each point when it ends. `checkpoint` as in compute().
PaperRuns run_paper(const Running& running, std::optional<double> checkpoint, const PaperJob& job,
                    campaign::ResumableRuns& kept);

}  // namespace mahlwerk::commands
