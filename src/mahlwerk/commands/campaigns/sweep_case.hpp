// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/sweep/campaign_folder.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/campaigns/campaign_pages.hpp"

// The campaign of a case with [sweep], for the commands that run or report one.
namespace mahlwerk::commands {

/// Reads a case with [sweep]. Throws InputError if it has none.
cases::Case swept_case(const std::filesystem::path& file, const std::vector<cases::Override>& set);

/// File name of the lock of who merges shards.
constexpr const char* merge_lock = "campaign.merge.lock";

/// Which part of a campaign is run, and what is kept of it.
struct CampaignPart {
  std::string shard;                 ///< "2/8": the second of eight parts; empty: all
  std::string results;               ///< results kept: "all", "summary"; empty: by their number
  std::optional<double> checkpoint;  ///< [s] between two checkpoints; empty: 60 s
  bool films = false;                ///< film.json of each run, for pictures
  bool merge = false;                ///< after a shard, merge all, if no point waits any more
  std::string fingerprint;  ///< of the campaign when it was submitted; empty: it may have changed
};

/// Runs or resumes the campaign, or a part of it, in the folder `place`. Returns the exit code.
int sweep_case(const Running& running, const CampaignPart& part, const std::filesystem::path& file,
               const std::vector<cases::Override>& set, const std::filesystem::path& place);

/// Merges the shards of a campaign and writes its pages. Returns the exit code.
int merge_shards(const Running& running, const std::filesystem::path& place);

/// Prints the progress of a campaign and the runs that failed: of its shards, where there are some.
int campaign_status(const Running& running, const std::filesystem::path& place);

/// "1 run", "2 runs".
std::string counted(std::size_t n, std::string_view what);

/// Prints the state of the campaign as JSON, with the seconds of `worked` (may be null).
void print_campaign(const campaign::Store& store, const std::filesystem::path& place,
                    const campaign::WorkSummary* worked);

std::string table_with_warnings(const campaign::Campaign& campaign);

}  // namespace mahlwerk::commands
