// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"

namespace mahlwerk::commands {

/// The report of a campaign from its store. Includes sensitivities if its design provides them and
/// its case can still be read.
report::Campaign campaign_of(const campaign::Store& store);
/// Adds the sensitivities of the quantities to the keys. `design` is the design matrix: a row per
/// point, a column per key. Adds nothing for other designs.
void add_sensitivities(report::Campaign& campaign, const cases::Sweep& sweep,
                       const std::vector<std::vector<double>>& design);

/// Writes campaign.csv and campaign.html into the folder. Throws InputError on write errors.
void write_pages(const campaign::Store& store, const report::Campaign& campaign,
                 const std::filesystem::path& place);
/// Writes the table of a campaign as CSV. Throws InputError on write errors.
void write_table(const campaign::Store& store, const std::filesystem::path& file);

}  // namespace mahlwerk::commands
