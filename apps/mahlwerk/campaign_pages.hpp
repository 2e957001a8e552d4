// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"

namespace mahlwerk::app {

/// What there is to tell of a campaign, from its store; where its design tells how much keys
/// matter, that too, if its case can still be read.
report::Campaign campaign_of(const campaign::Store& store);
/// Which quantities answer to which keys; `design` holds the places of the points. Nothing for a
/// design that does not tell.
void add_sensitivities(report::Campaign& campaign, const cases::Sweep& sweep,
                       const std::vector<std::vector<double>>& design);

/// campaign.csv, campaign.html and its pictures, into the folder.
void write_pages(const campaign::Store& store, const report::Campaign& campaign,
                 const std::filesystem::path& place);

}  // namespace mahlwerk::app
