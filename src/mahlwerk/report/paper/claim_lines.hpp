// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/paper.hpp"
#include "mahlwerk/report/plot/laws.hpp"

// Points of a campaign, grouped into lines along a key.
namespace mahlwerk::report {

/// A quantity at one value of the key.
struct LinePoint {
  const Point* point = nullptr;
  std::string text = {};                       ///< the key's value: "10 mm"
  double x = NAN;                              ///< its number, in the unit of the first point
  double value = NAN, ci95 = NAN;              ///< in SI units
  double low() const { return value - ci95; }  ///< NaN without an interval
  double high() const { return value + ci95; }
  bool above(const LinePoint& o) const {
    return low() > o.high();
  }  ///< the intervals do not overlap
};

/// Points that differ in one key only, or in keys that vary together with it.
struct ClaimLine {
  std::string others;  ///< values of the other keys, "friction 0.5, ratio -2"; may be empty
  std::vector<LinePoint> points;  ///< by ascending number of the key; words in campaign order
  std::vector<std::string> keys = {}, values = {};  ///< of `others`: the keys, their values
};

/// The points that `at` selects, grouped into lines along `against` (empty: each point is a line).
/// `quantity` may be empty.
std::vector<ClaimLine> lines_along(const Campaign& campaign, const PointSelector& at,
                                   std::string_view against, std::string_view quantity);

/// Fits a law to the points of a line, weighted by their intervals (cam.20 to cam.24); nullopt if
/// there are too few points.
std::optional<FittedLaw> law_along(LawForm form, const ClaimLine& line);

/// Whether two texts are the same value of a key: "10 mm" and "0.01 m".
bool same_value(std::string_view a, std::string_view b);

/// The unit of a quantity; empty if the campaign has no such quantity.
std::string unit_of(const Campaign& campaign, std::string_view quantity);

}  // namespace mahlwerk::report
