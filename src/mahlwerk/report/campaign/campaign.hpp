// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/summary.hpp"

// Report of a campaign: page, pictures and tables.
namespace mahlwerk::report {

/// A key that a campaign varies. Its values are numbers in the unit of the case, or words.
struct CampaignKey {
  std::string key;   ///< "mill.speed"
  std::string unit;  ///< "rpm", if all values are numbers in it; empty for words and plain numbers
  /// Whether its values vary together with an earlier key, or are computed from other keys. It is
  /// listed with each point but is not an independent axis.
  bool follows = false;
};

/// A quantity of summary.json. Values are in SI units, as there.
struct Column {
  std::string name, unit, about;  ///< "d90", "m", description
};

/// One run of a campaign.
struct Point {
  std::size_t number = 0;                ///< of the run, from 1
  std::vector<std::string> values = {};  ///< of the swept keys, as in the case: "400 rpm"
  /// By column; NaN for missing values, trailing ones may be omitted.
  std::vector<double> value = {}, ci95 = {};
  std::string regime = {};    ///< one word, "cataracting"; empty: none
  std::string warnings = {};  ///< codes, separated by ";"
  std::string folder = {};  ///< of its own result, relative to the campaign folder; empty: not kept
  std::string failure = {};  ///< reason of the failure; empty: none
  bool waiting = false;      ///< not run yet
};

enum class Method {
  one_at_a_time,  ///< each key alone at the ends of its range
  morris,         ///< elementary effects
  sobol           ///< Sobol indices: shares of the variance
};

/// Effect of a key on a quantity. The members that are set depend on the method; NaN: unknown.
/// Numbers of the first two methods are in the quantity's unit; an elementary effect is over the
/// whole range of the key.
struct Effect {
  std::string key;
  std::string low_end = {}, high_end = {};        ///< ends of its range: "200 rpm", "400 rpm"
  observe::IntervalEstimate low = {}, high = {};  ///< one at a time: value at the ends
  observe::IntervalEstimate mean_absolute = {};   ///< Morris: mu*, mean absolute effect
  observe::IntervalEstimate mean = {};            ///< mu, mean effect
  observe::IntervalEstimate deviation = {};       ///< sigma, standard deviation of the effects
  double of_noise = NAN;                          ///< mu* expected from errors alone
  observe::IntervalEstimate first_order = {};     ///< Sobol: S1, first-order index
  observe::IntervalEstimate total = {};           ///< ST, total index, with interactions
  std::size_t count = 0;                          ///< Morris: effects used; Sobol: groups
  /// Whether the effect differs significantly from zero; nullopt: unknown.
  std::optional<bool> significant = std::nullopt;
  bool inactive = false;  ///< no result changes if only this key changes
};

/// Sensitivity of a quantity to the keys.
struct Sensitivity {
  std::string quantity, unit;  ///< of summary.json, in SI
  Method method = Method::one_at_a_time;
  observe::IntervalEstimate base = {};  ///< of the base case, or the mean over all points
  double variance = NAN;                ///< Sobol: variance without that of errors
  double noise = NAN;                   ///< Sobol: share of errors in the observed variance
  std::vector<Effect> effects = {};     ///< in any order
};

struct Campaign {
  std::string title;
  std::vector<CampaignKey> keys = {};
  std::vector<Column> columns = {};
  std::vector<Point> points = {};
  std::vector<Sensitivity> sensitivities = {};
  results::NoticeCounts notices = {};  ///< of its points
};

/// Adds a point with the quantities of its result. New quantities become columns, in which earlier
/// points have no value.
void add(Campaign& campaign, Point point, const std::vector<results::Quantity>& quantities);

/// The keys of a campaign with the common unit of their values in `points`, if there is one.
std::vector<CampaignKey> campaign_keys(const std::vector<std::string>& keys,
                                       const std::vector<Point>& points);

/// Names of the columns that pages and tables show, in their order; empty if no point has numbers.
std::vector<std::string> compared_quantities(const Campaign& campaign);

/// campaign.html: summary, plots or maps of the shown quantities with fitted laws, sensitivities,
/// and a table of the points.
std::string campaign_page(const Campaign& campaign, std::string_view version);

/// The table for the terminal: a line per point with the main quantities. `where` names the file
/// with all points if the table is cut.
std::string campaign_table(const Campaign& campaign, std::string_view where = "campaign.csv");

/// CSV table of a campaign without store: a row per point; the swept keys, then every quantity and
/// its ci95.
std::string campaign_csv(const Campaign& campaign);

}  // namespace mahlwerk::report
