// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "mahlwerk/campaign/store/store.hpp"
#include "mahlwerk/campaign/sweep/sensitivity.hpp"
#include "mahlwerk/results/table.hpp"

// The numbers of a campaign: its points with their quantities, and what matters to them.
namespace mahlwerk::campaign {

/// A key that a campaign varies. Its values are numbers in the unit of the case, or words.
struct CampaignKey {
  std::string key;   ///< "mill.speed"
  std::string unit;  ///< "rpm", if all values are numbers in it; empty for words and plain numbers
  /// Whether its values vary together with an earlier key, or are computed from other keys. It is
  /// listed with each point but is not an independent axis.
  bool follows = false;
};

struct Campaign {
  std::string title = {}, case_file = {};  ///< name of the file, without its folder
  std::vector<CampaignKey> keys = {};
  std::vector<results::Column> columns = {};  ///< quantities of summary.json, in SI units
  std::vector<Point> points = {};
  std::vector<Sensitivity> sensitivities = {};
  results::NoticeCounts notices = {};  ///< of its points
};

/// Value and half-width of a column; NaN if the point has none.
inline double value_at(const Point& point, std::size_t column) {
  return column < point.value.size() ? point.value[column] : NAN;
}
inline double half_width_at(const Point& point, std::size_t column) {
  return column < point.ci95.size() ? point.ci95[column] : NAN;
}

/// Adds a point with the quantities of its result. New quantities become columns, in which earlier
/// points have no value.
void add(Campaign& campaign, Point point, const std::vector<results::Quantity>& quantities);

/// The keys of a campaign with the common unit of their values in `points`, if there is one.
std::vector<CampaignKey> campaign_keys(const std::vector<std::string>& keys,
                                       const std::vector<Point>& points);

/// The columns that pages and tables show, in their order; empty if no point has numbers.
std::vector<std::size_t> shown_columns(const Campaign& campaign);

/// Adds the sensitivities of the shown quantities to the keys. `design` is the design matrix: a row
/// per point, a column per key. Adds nothing for designs that are not made for it.
void add_sensitivities(Campaign& campaign, const cases::Sweep& sweep, const DesignMatrix& design);

/// The campaign of a store. Includes sensitivities if its design provides them and its case can
/// still be read.
Campaign campaign_of(const Store& store, const cases::Catalogue& known);

}  // namespace mahlwerk::campaign
