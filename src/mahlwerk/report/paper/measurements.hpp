// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/paper.hpp"

namespace mahlwerk::report {

/// The figure with the values of the measurements that it names, on the axis of the campaign.
PaperFigure with_measured(const PaperFigure& figure, const Paper& paper, const Campaign& campaign);

/// The points of a line over that at the value `base` of the key, with the interval of the ratio.
/// Empty if there is no such point. Its own ratio is exactly 1.
ClaimLine relative_line(const ClaimLine& line, const std::string& base);

}  // namespace mahlwerk::report
