// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"

// Bands over the values of free numbers, which no interval over replicates contains.
namespace mahlwerk::report {

/// Lowest and highest end of the intervals at one x, in SI units. A point without an interval
/// counts with its value.
struct BandPoint {
  double x = 0, low = 0, high = 0;
};

/// The band over all values of the figure's free numbers, for one combination of the other keys.
struct BandLine {
  std::string others;              ///< values of the other keys; may be empty
  std::vector<BandPoint> points;   ///< by ascending x
  std::vector<LinePoint> nominal;  ///< the points at the nominal values of the free numbers
};

std::vector<BandLine> bands_along(const PaperFigure& figure, const Campaign& campaign);

}  // namespace mahlwerk::report
