// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/report/campaign/sheet.hpp"

// Text and tables of the points on a campaign's page (HTML).
namespace mahlwerk::report {

/// Summary: number of points, varied keys, failed and waiting points, largest change.
std::string campaign_lead(const Sheet& sheet);

/// Failed points, grouped by reason; empty if none failed.
std::string failures(const Campaign& campaign);

/// A row per point, at most 1000, with its values, quantities and regime. A click on a column head
/// sorts.
std::string point_table(const Sheet& sheet);

}  // namespace mahlwerk::report
