// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/claim_lines.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"

namespace mahlwerk::report {
namespace {

/// The value of a text in `unit`; NaN if it is not a quantity of that dimension.
double number_in(std::string_view text, std::string_view unit) try {
  return parse_in(text, unit);
} catch (const UnitError&) {
  return NAN;
}

std::size_t key_at(const Campaign& c, std::string_view key) {
  return static_cast<std::size_t>(std::ranges::find(c.keys, key, &CampaignKey::key) -
                                  c.keys.begin());
}

bool chosen(const Campaign& c, const Point& p, const PointSelector& at) {
  return std::ranges::all_of(at, [&](const auto& one) {
    const std::size_t key = key_at(c, one.first);
    return key < p.values.size() && std::ranges::any_of(one.second, [&](const std::string& v) {
             return same_value(v, p.values[key]);
           });
  });
}

/// Whether the values of two keys correspond one to one, and there are several.
bool side_by_side(const std::vector<const Point*>& points, std::size_t a, std::size_t b) {
  std::map<std::string, std::set<std::string>> of_a, of_b;
  for (const Point* p : points) {
    of_a[p->values[a]].insert(p->values[b]);
    of_b[p->values[b]].insert(p->values[a]);
  }
  const auto one = [](const auto& entry) { return entry.second.size() == 1; };
  return of_a.size() > 1 && std::ranges::all_of(of_a, one) && std::ranges::all_of(of_b, one);
}

/// Keys that distinguish lines: they vary among `points` and correspond neither to the axis nor to
/// an earlier key.
std::vector<std::size_t> distinguishing_keys(const Campaign& c,
                                             const std::vector<const Point*>& points,
                                             std::size_t axis) {
  std::vector<std::size_t> keys;
  for (std::size_t k = 0; k < c.keys.size(); ++k) {
    std::set<std::string> values;
    for (const Point* p : points) values.insert(p->values[k]);
    const bool followed = std::ranges::any_of(
        keys, [&](std::size_t before) { return side_by_side(points, before, k); });
    const bool with_axis = k == axis || (axis < c.keys.size() && side_by_side(points, axis, k));
    if (values.size() > 1 && !followed && !with_axis) keys.push_back(k);
  }
  return keys;
}

}  // namespace

bool same_value(std::string_view a, std::string_view b) {
  if (a == b) return true;
  try {
    const mahlwerk::Quantity x = parse_quantity(a), y = parse_quantity(b);
    const double size = std::max(std::abs(x.value), std::abs(y.value));
    return x.dimension == y.dimension && std::abs(x.value - y.value) <= 1e-12 * size;
  } catch (const UnitError&) {
    return false;  // words
  }
}

std::optional<FittedLaw> law_along(LawForm form, const ClaimLine& line) {
  std::vector<double> x, y, ci95;
  for (const LinePoint& s : line.points) {
    x.push_back(s.x);
    y.push_back(s.value);
    ci95.push_back(s.ci95);
  }
  const std::vector<FittedLaw> laws = fitted_laws(x, y, ci95);
  const auto law = std::ranges::find(laws, form, &FittedLaw::form);
  return law == laws.end() ? std::nullopt : std::optional(*law);
}

std::string unit_of(const Campaign& campaign, std::string_view quantity) {
  const auto column = std::ranges::find(campaign.columns, quantity, &Column::name);
  return column == campaign.columns.end() ? "" : column->unit;
}

std::vector<ClaimLine> lines_along(const Campaign& campaign, const PointSelector& at,
                                   std::string_view against, std::string_view quantity) {
  const auto column = static_cast<std::size_t>(
      std::ranges::find(campaign.columns, quantity, &Column::name) - campaign.columns.begin());
  std::vector<const Point*> points;
  for (const Point& p : campaign.points)
    if (chosen(campaign, p, at)) points.push_back(&p);
  const std::size_t axis = key_at(campaign, against);
  const std::vector<std::size_t> others = distinguishing_keys(campaign, points, axis);
  const std::string_view unit = points.empty() || axis >= points.front()->values.size()
                                    ? ""
                                    : number_text(points.front()->values[axis]).rest;
  std::vector<ClaimLine> lines;
  for (const Point* p : points) {
    std::string label;
    for (const std::size_t k : others)
      label += (label.empty() ? "" : ", ") + distinct_key_words(campaign, k) + " " + p->values[k];
    LinePoint spot{.point = p};
    if (axis < p->values.size()) spot.text = p->values[axis], spot.x = number_in(spot.text, unit);
    if (column < p->value.size()) spot.value = p->value[column];
    if (column < p->ci95.size()) spot.ci95 = p->ci95[column];
    auto line = std::ranges::find(lines, label, &ClaimLine::others);
    if (line == lines.end()) {
      line = lines.insert(lines.end(), {label, {}});
      for (const std::size_t k : others) {
        line->keys.push_back(campaign.keys[k].key);
        line->values.push_back(p->values[k]);
      }
    }
    line->points.push_back(std::move(spot));
  }
  for (ClaimLine& line : lines)
    if (std::ranges::none_of(line.points, [](const LinePoint& s) { return std::isnan(s.x); }))
      std::ranges::stable_sort(line.points, {}, &LinePoint::x);
  return lines;
}

}  // namespace mahlwerk::report
