// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/report/campaign/sheet.hpp"

// What a campaign's page says of its points in words and tables (HTML).
namespace mahlwerk::report {

/// How many points there are, what varies, how many failed or wait, what stands out.
std::string campaign_lead(const Sheet& sheet);

/// Which points failed and why, equal reasons told once; empty if none did.
std::string failures(const Campaign& campaign);

/// A row per point, 1000 at most, with its values, quantities and regime; sorted by a click on a
/// head.
std::string point_table(const Sheet& sheet);

}  // namespace mahlwerk::report
