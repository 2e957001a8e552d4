// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/paper.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"

// The plot of a quantity over a key in a figure of a paper, and its numbers.
namespace mahlwerk::report {

struct FigurePlot {
  Plot plot;
  /// The drawn numbers: a row for each point of each series; x in the unit of the axis, y and the
  /// ends of its interval in SI units.
  std::string csv;
};

/// The points of each line with their intervals, which are cut at the range of the quantity, fitted
/// laws, the band over free numbers and measured values.
FigurePlot figure_plot(const PaperFigure& figure, const Campaign& campaign);

/// Faults of the bands of figures: keys that a campaign does not vary, values that a key does not
/// take. `cases` holds each campaign's case with its [sweep].
std::vector<Fault> band_faults(const Paper& paper, const std::map<std::string, cases::Case>& cases);

}  // namespace mahlwerk::report
