// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"

// The shards of a campaign in its folder, before and after they are merged.
namespace mahlwerk::campaign {

/// A shard and the points of its part: those of the campaign's latest plan.
struct ShardProgress {
  Shard shard;
  std::filesystem::path store;  ///< empty: the shard has not begun
  bool at_work = false;
  std::size_t points = 0, done = 0, failed = 0;
};

/// A campaign by the stores of its shards and the store that they are merged into.
struct ShardsProgress {
  std::vector<ShardProgress> shards;  ///< by number; those of the same division of the campaign
  std::string title;
  std::filesystem::path case_file;
  std::vector<cases::Override> overrides;
  std::size_t points = 0, done = 0, failed = 0;
  /// Whether there is a plan and no point waits.
  bool complete() const { return points > 0 && done + failed == points; }
};

/// Nothing if the folder holds no shards. Stores that are being made or cannot be read count as
/// empty.
std::optional<ShardsProgress> shards_progress(const std::filesystem::path& place);

/// The stores of all shards in a folder, sorted by name.
std::vector<std::filesystem::path> shard_stores(const std::filesystem::path& place);

/// Fingerprint of what a campaign computes: its case with [sweep], and the files that it names.
/// Comments and the order of keys do not change it.
std::string campaign_fingerprint(const cases::Case& mill_case);

}  // namespace mahlwerk::campaign
