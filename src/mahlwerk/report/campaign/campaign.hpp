// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "mahlwerk/campaign/sweep/campaign.hpp"

// Report of a campaign: page, pictures and tables.
namespace mahlwerk::report {

using campaign::Campaign, campaign::CampaignKey, campaign::Point;
using campaign::Effect, campaign::Sensitivity;
using cases::Design;
using results::Column;

/// campaign.html: summary, plots or maps of the shown quantities with fitted laws, sensitivities,
/// and a table of the points.
std::string campaign_page(const Campaign& campaign, std::string_view version);

/// The table for the terminal: a line per point with the main quantities. `where` names the file
/// with all points if the table is cut.
std::string campaign_table(const Campaign& campaign, std::string_view where = "campaign.csv");

/// campaign.json (docs/formats.md): keys, columns, points, what matters to them. The points are
/// left out if there are more than 5000.
std::string campaign_json(const Campaign& campaign, std::string_view version);

}  // namespace mahlwerk::report
