// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"

namespace mahlwerk::commands {

/// Writes campaign.csv, campaign.json, campaign.html and its pictures into the folder. Throws
/// InputError on write errors.
void write_pages(const campaign::Store& store, const campaign::Campaign& campaign,
                 const std::filesystem::path& place);
/// Writes the table of a campaign as CSV. Throws InputError on write errors.
void write_table(const campaign::Store& store, const std::filesystem::path& file);

}  // namespace mahlwerk::commands
