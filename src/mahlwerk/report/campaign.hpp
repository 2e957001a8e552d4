// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::report {

/// A key that a campaign varies. Numbers in the unit the case uses, or text where values are words.
struct Swept {
  std::string key;   ///< "mill.speed"
  std::string unit;  ///< "rpm"; empty for words and plain numbers
};

/// One point of a campaign.
struct Point {
  std::vector<std::string> values;  ///< of the swept keys, as the case says them: "400 rpm"
  std::vector<results::Quantity> quantities;
  std::string folder;  ///< of its own result, relative to the campaign's; empty: none
};

struct Campaign {
  std::string title;
  std::vector<Swept> swept;
  std::vector<Point> points;
};

/// What varies in `points` when the keys `keys` do: the unit is that of all values of a key if they
/// share one.
std::vector<Swept> swept(const std::vector<std::string>& keys, const std::vector<Point>& points);

/// campaign.html: a table of the points, and the chosen quantities against the numeric key with
/// most values, a line for every combination of the others.
std::string campaign_page(const Campaign& campaign, std::string_view version);

/// The plots of the page as pictures of their own: file name -> SVG.
std::map<std::string, std::string> campaign_figures(const Campaign& campaign);

/// The table for the terminal: a line per point with the figures that are compared most.
std::string campaign_table(const Campaign& campaign);

/// campaign.csv: a row per point; the swept keys, then every quantity and its ci95.
std::string campaign_csv(const Campaign& campaign);

}  // namespace mahlwerk::report
