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

#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/summary.hpp"

// What is told of a campaign: its page, pictures and tables.
namespace mahlwerk::report {

/// A key that a campaign varies. Numbers in the unit the case uses, or text where values are words.
struct CampaignKey {
  std::string key;   ///< "mill.speed"
  std::string unit;  ///< "rpm", if all values are numbers in it; empty for words and plain numbers
  /// Its values go side by side with those of a key before it, or follow from others: it is told
  /// of each point, but is no axis of its own.
  bool follows = false;
};

/// A quantity of summary.json. Values are in SI units, as there.
struct Column {
  std::string name, unit, about;  ///< "d90", "m", what it is
};

/// One run of a campaign.
struct Point {
  std::size_t number = 0;                ///< of the run, from 1
  std::vector<std::string> values = {};  ///< of the swept keys, as the case says them: "400 rpm"
  /// By column; NaN where it has none, the last may be missing.
  std::vector<double> value = {}, ci95 = {};
  std::string regime = {};    ///< one word, "cataracting"; empty: none
  std::string warnings = {};  ///< codes, separated by ";"
  std::string folder = {};    ///< of its own result, relative to the campaign's; empty: none kept
  std::string failure = {};   ///< why it gave nothing; empty: it did
  bool waiting = false;       ///< it was not run yet
};

enum class Method {
  one_at_a_time,  ///< each key alone at its ends
  morris,         ///< elementary effects
  sobol           ///< shares of variance
};

/// What a key does to a quantity. Which members are set depends on the method; NaN where nothing is
/// known. Numbers of the first two methods are in the quantity's unit; an elementary effect is over
/// the whole range of the key.
struct Effect {
  std::string key;
  std::string low_end = {}, high_end = {};               ///< of its range: "200 rpm", "400 rpm"
  double low = NAN, low_ci95 = NAN;                      ///< one at a time: with the low end
  double high = NAN, high_ci95 = NAN;                    ///< and with the high one
  double mean_absolute = NAN, mean_absolute_ci95 = NAN;  ///< Morris: mu*, mean of the sizes
  double mean = NAN, mean_ci95 = NAN;                    ///< mu, of the effects themselves
  double deviation = NAN, deviation_ci95 = NAN;          ///< sigma, how much they differ
  double of_noise = NAN;                                 ///< mu* that errors alone would give
  double first_order = NAN, first_order_ci95 = NAN;      ///< Sobol: S1, share of it alone
  double total = NAN, total_ci95 = NAN;                  ///< ST, with what it does with others
  double total_low = NAN, total_high = NAN;              ///< its interval, which may be uneven
  std::size_t count = 0;                                 ///< Morris: effects used; Sobol: groups
  /// It differs from none by more than chance makes; nothing: that is not known.
  std::optional<bool> significant = std::nullopt;
  bool inactive = false;  ///< no run changes by a digit where this key alone does
};

/// How a quantity answers to the keys.
struct Sensitivity {
  std::string quantity, unit;  ///< of summary.json, in SI
  Method method = Method::one_at_a_time;
  double base = NAN, base_ci95 = NAN;  ///< of the case itself, or the mean over all points
  double variance = NAN;               ///< Sobol: without that of errors
  double noise = NAN;                  ///< Sobol: share of errors in the variance seen
  std::vector<Effect> effects = {};    ///< in any order
};

struct Campaign {
  std::string title;
  std::vector<CampaignKey> keys = {};
  std::vector<Column> columns = {};
  std::vector<Point> points = {};
  std::vector<Sensitivity> sensitivities = {};
  results::NoticeCounts notices = {};  ///< of its points
};

/// Adds a point with the quantities of its result. Those that are new become columns; points told
/// before have nothing there.
void add(Campaign& campaign, Point point, const std::vector<results::Quantity>& quantities);

/// What varies in `points` when the keys `keys` do: the unit is that of all values of a key if they
/// share one.
std::vector<CampaignKey> campaign_keys(const std::vector<std::string>& keys,
                                       const std::vector<Point>& points);

/// Names of the columns that pages and tables show, in their order; none where no point has
/// numbers.
std::vector<std::string> compared_quantities(const Campaign& campaign);
/// Those that a page shows of any campaign that has them.
const std::vector<std::string>& usual_quantities();

/// campaign.html: what stands out, plots or maps of the chosen quantities with fitted laws,
/// sensitivities, and a table of the points.
std::string campaign_page(const Campaign& campaign, std::string_view version);

/// The plots of the page as pictures of their own: file name -> SVG.
std::map<std::string, std::string> campaign_figures(const Campaign& campaign);

/// The table for the terminal: a line per point with the figures that are compared most. `where`
/// says what holds the points that are too many for it.
std::string campaign_table(const Campaign& campaign, std::string_view where = "campaign.csv");

/// The table of a campaign that has no store: a row per point; the swept keys, then every quantity
/// and its ci95.
std::string campaign_csv(const Campaign& campaign);

}  // namespace mahlwerk::report
