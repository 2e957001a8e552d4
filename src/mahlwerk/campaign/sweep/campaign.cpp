// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/sweep/campaign.hpp"

#include <algorithm>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::campaign {
namespace {

/// Above this number of points, only the usual quantities are read from the store.
constexpr std::size_t many_points = 5000;

/// Index of a quantity's column, which is added if missing. `likely` is tried first.
std::size_t column_for(Campaign& c, std::size_t likely, const results::Quantity& q) {
  if (likely < c.columns.size() && c.columns[likely].name == q.name) return likely;
  const auto found = std::ranges::find(c.columns, q.name, &results::Column::name);
  if (found != c.columns.end()) return static_cast<std::size_t>(found - c.columns.begin());
  c.columns.push_back({q.name, q.unit, q.about});
  return c.columns.size() - 1;
}

bool has_numbers(const Campaign& c, std::size_t column) {
  return std::ranges::any_of(c.points,
                             [&](const Point& p) { return std::isfinite(value_at(p, column)); });
}

/// Whether the points are those of this plan: compares the first and the last point. The case may
/// have changed since the run.
bool made_by(const Campaign& campaign, const Plan& plan, const cases::Case& mill_case) {
  if (campaign.points.empty() || plan.size() != campaign.points.size()) return false;
  const std::vector<std::string> own = base_values(plan, mill_case);
  for (const std::size_t i : {std::size_t{0}, plan.size() - 1}) {
    const std::vector<std::string>&kept = campaign.points[i].values,
          said = point_values(plan, i, own);
    const bool same = std::ranges::equal(kept, said, [](const auto& a, const auto& b) {
      const NumberText x = number_text(a), y = number_text(b);
      return a == b || (x.number == y.number && x.rest == y.rest);
    });
    if (!same) return false;
  }
  return true;
}

void add_sensitivities_of_design(Campaign& campaign, const Store& store,
                                 const cases::Catalogue& known) {
  try {
    const cases::Case mill_case = cases::read(store.case_file(), known, store.overrides());
    if (mill_case.sweep.empty()) return;
    const Plan plan(mill_case.sweep, mill_case.seed);
    if (made_by(campaign, plan, mill_case))
      add_sensitivities(campaign, mill_case.sweep, plan.design());
  } catch (const InputError&) {
    // the case was removed or changed since: the report omits the sensitivities
  }
}

/// Values or half-widths of a column at all points.
std::vector<double> of_points(const Campaign& campaign, std::size_t column,
                              double (*number)(const Point&, std::size_t)) {
  std::vector<double> numbers;
  for (const Point& point : campaign.points) numbers.push_back(number(point, column));
  return numbers;
}

Sensitivity sensitivity_of(const Campaign& campaign, const cases::Sweep& sweep,
                           const DesignMatrix& design, std::size_t column) {
  const auto replicates = static_cast<std::size_t>(
      std::ranges::find(campaign.columns, "replicates", &results::Column::name) -
      campaign.columns.begin());
  const std::vector<double> outcomes = of_points(campaign, column, value_at),
                            widths = of_points(campaign, column, half_width_at);
  const auto errors = [&] {
    return standard_errors(outcomes, widths, of_points(campaign, replicates, value_at));
  };
  Sensitivity found = sweep.design == cases::Design::one_at_a_time
                          ? one_at_a_time_effects(outcomes, widths)
                      : sweep.design == cases::Design::morris
                          ? elementary_effects(design, outcomes, errors())
                          : variance_decomposition(sweep.keys.size(), outcomes, errors());
  found.quantity = campaign.columns[column].name;
  found.unit = campaign.columns[column].unit;
  for (std::size_t k = 0; k < found.effects.size(); ++k) {
    found.effects[k].key = sweep.keys[k].key;
    found.effects[k].low_end = sweep.keys[k].values[0];
    found.effects[k].high_end = sweep.keys[k].values[1];
  }
  return found;
}

}  // namespace

void add(Campaign& campaign, Point point, const std::vector<results::Quantity>& quantities) {
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    const std::size_t column = column_for(campaign, i, quantities[i]);
    if (point.value.size() <= column) {
      point.value.resize(column + 1, NAN);
      point.ci95.resize(column + 1, NAN);
    }
    point.value[column] = quantities[i].value;
    point.ci95[column] = quantities[i].ci95;
  }
  campaign.points.push_back(std::move(point));
}

std::vector<CampaignKey> campaign_keys(const std::vector<std::string>& keys,
                                       const std::vector<Point>& points) {
  std::vector<CampaignKey> list;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string_view unit = points.empty() ? "" : number_text(points.front().values[i]).rest;
    const bool shared = std::ranges::all_of(points, [&](const Point& p) {
      const NumberText s = number_text(p.values[i]);
      return std::isfinite(s.number) && s.rest == unit;
    });
    list.push_back({keys[i], shared ? std::string(unit) : ""});
  }
  return list;
}

std::vector<std::size_t> shown_columns(const Campaign& c) {
  std::vector<std::size_t> list;
  for (const std::string& name : results::usual_columns()) {
    const auto at = std::ranges::find(c.columns, name, &results::Column::name);
    const auto column = static_cast<std::size_t>(at - c.columns.begin());
    if (at != c.columns.end() && has_numbers(c, column)) list.push_back(column);
  }
  constexpr std::size_t few = 6;  // without any usual quantity: the first few columns
  if (list.empty())
    for (std::size_t i = 0; i < c.columns.size() && list.size() < few; ++i)
      if (has_numbers(c, i)) list.push_back(i);
  return list;
}

void add_sensitivities(Campaign& campaign, const cases::Sweep& sweep, const DesignMatrix& design) {
  using cases::Design;
  const bool made_for_it = sweep.design == Design::one_at_a_time ||
                           sweep.design == Design::morris || sweep.design == Design::sobol_indices;
  if (!made_for_it || design.size() != campaign.points.size()) return;
  for (const std::size_t column : shown_columns(campaign))
    campaign.sensitivities.push_back(sensitivity_of(campaign, sweep, design, column));
}

Campaign campaign_of(const Store& store, const cases::Catalogue& known) {
  Campaign campaign{.title = store.title(), .case_file = store.case_file().filename().string()};
  std::vector<std::string> names;
  const bool all = store.counts().points <= many_points;
  const std::vector<std::string>& usual = results::usual_columns();
  for (const results::Quantity& q : store.quantities()) {
    // Standard errors need the number of replicates.
    const bool wanted = q.name == "replicates" || std::ranges::find(usual, q.name) != usual.end();
    if (!all && !wanted) continue;
    names.push_back(q.name);
    campaign.columns.push_back({q.name, q.unit, q.about});
  }
  store.read(names, [&](const Point& point) { campaign.points.push_back(point); });
  campaign.keys = campaign_keys(store.keys(), campaign.points);
  for (CampaignKey& key : campaign.keys) key.follows = store.follows(key.key);
  campaign.notices = store.notices();
  add_sensitivities_of_design(campaign, store, known);
  return campaign;
}

}  // namespace mahlwerk::campaign
