// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "campaign_pages.hpp"
#include "commands.hpp"
#include "mahlwerk/campaign/sweep/campaign_folder.hpp"

// The campaign of a case with [sweep], for the commands that run or tell of one.
namespace mahlwerk::app {

/// Throws InputError of a case without [sweep].
cases::Case swept_case(const std::filesystem::path& file, const std::vector<cases::Override>& set);

/// Runs it, all of it or request.shard, in the folder `place`, again and again until all is done.
int sweep_case(const Request& request, const std::filesystem::path& file,
               const std::vector<cases::Override>& set, const std::filesystem::path& place);

/// "1 run", "2 runs".
std::string counted(std::size_t n, std::string_view what);

/// As JSON: how far it is, and how the work just `worked` went, which may be null.
void print_campaign(const campaign::Store& store, const std::filesystem::path& place,
                    const campaign::WorkSummary* worked);

std::string table_with_warnings(const report::Campaign& campaign);

}  // namespace mahlwerk::app
