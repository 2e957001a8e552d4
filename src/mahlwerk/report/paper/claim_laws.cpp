// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Claims about a law: a straight line by its slope and curvature, a power law by its exponent.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/paper/claim_rules.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

std::string r_squared(const FittedLaw& law) {
  return fmt::format("R² = {:.4f}", law.r_squared);
}

/// Tests whether the interval of the exponent is on the claimed side of, or near, the claimed one.
Verdict judge_exponent(const ClaimContext& c, const FittedLaw& law) {
  const double p = law.coefficients[1], ci95 = law.ci95[1], claimed = *c.claim.exponent;
  const std::string found =
      fmt::format("exponent {}, {}", readable(p, ci95, "").text(), r_squared(law));
  if (!std::isfinite(ci95)) return {found, Holds::undecided};
  if (!c.claim.is.empty()) {
    const double off = (p - claimed) * (c.claim.is == "above" ? 1 : -1);
    if (std::abs(off) <= ci95) return {found, Holds::undecided};
    return {found, off > 0 ? Holds::yes : Holds::no};
  }
  const double off = std::abs(p - claimed);
  if (off + ci95 <= c.claim.within) return {found, Holds::yes};
  return {found, off - ci95 > c.claim.within ? Holds::no : Holds::undecided};
}

/// Deviation of a fitted parabola from its chord at the middle of the points, over its rise.
double bend(const FittedLaw& parabola, const ClaimLine& line) {
  const auto [least, most] = std::ranges::minmax(line.points, {}, &LinePoint::x);
  const double half = 0.5 * (most.x - least.x);
  const double rise = std::abs(parabola.at(most.x) - parabola.at(least.x));
  return -parabola.coefficients[2] * half * half / rise;
}

struct Curvature {
  double value = NAN, ci95 = NAN;  ///< [1]
};

/// The bend with the half-width that follows from the intervals of the points: each moves the
/// fit by its own part, and the parts are independent.
Curvature curvature(const ClaimLine& line) {
  const std::optional<FittedLaw> parabola = law_along(LawForm::parabola, line);
  if (!parabola) return {};
  const double value = bend(*parabola, line);
  double squares = 0;
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    ClaimLine moved = line;
    moved.points[i].value += moved.points[i].ci95;
    const std::optional<FittedLaw> law = law_along(LawForm::parabola, moved);
    const double part = law ? bend(*law, moved) - value : NAN;
    squares += part * part;
  }
  return {value, std::sqrt(squares)};
}

Verdict judge_line_law(const ClaimContext& c, const ClaimLine& line, const FittedLaw& law) {
  const CampaignKey& key = *std::ranges::find(c.campaign.keys, c.claim.against, &CampaignKey::key);
  std::string found = fmt::format("{} for each {}, {}", c.text(law.coefficients[1], law.ci95[1]),
                                  key.unit.empty() ? "1" : key.unit, r_squared(law));
  const double slope = law.coefficients[1] * (c.claim.is == "falls" ? -1 : 1);
  const bool sloped = std::abs(slope) > law.ci95[1];
  const Curvature curved = curvature(line);
  found += fmt::format("; the middle deviates by {} % of the rise from a line through the ends{}",
                       readable(100 * curved.value, 100 * curved.ci95, "").number,
                       std::abs(curved.value) > curved.ci95 ? "" : ", no significant curvature");
  if (!std::isfinite(curved.ci95) || !sloped) return {found, Holds::undecided};
  if (!c.claim.is.empty() && slope < 0) return {found, Holds::no};
  if (std::abs(curved.value) + curved.ci95 <= c.claim.within) return {found, Holds::yes};
  return {found,
          std::abs(curved.value) - curved.ci95 > c.claim.within ? Holds::no : Holds::undecided};
}

}  // namespace

Verdict judge_law(const ClaimContext& c, const ClaimLine& line) {
  const std::optional<FittedLaw> law = law_along(c.claim.law, line);
  if (!law) return {"too few points for a fit"};
  return c.claim.law == LawForm::power ? judge_exponent(c, *law) : judge_line_law(c, line, *law);
}

Verdict judge_maximum(const ClaimContext& c, const ClaimLine& line) {
  const std::vector<LinePoint>& s = line.points;
  const auto sure = [](const LinePoint& p) {
    return std::isfinite(p.value) && std::isfinite(p.ci95) && std::isfinite(p.x);
  };
  if (s.size() < 3 || !std::ranges::all_of(s, sure)) return {"no intervals to compare"};
  const LinePoint& best = *std::ranges::max_element(s, {}, &LinePoint::value);
  std::vector<const LinePoint*> candidates;  // not surely below the largest
  for (const LinePoint& p : s)
    if (!best.above(p)) candidates.push_back(&p);
  const auto x_of = [&](const std::string& text) {
    const auto at =
        std::ranges::find_if(s, [&](const LinePoint& p) { return same_value(p.text, text); });
    return at == s.end() ? NAN : at->x;
  };
  const auto range = std::minmax({x_of(c.claim.first), x_of(c.claim.second)});
  const auto inside = std::ranges::count_if(
      candidates, [&](const LinePoint* p) { return p->x >= range.first && p->x <= range.second; });
  std::string found = fmt::format("largest at {} {}: {}", c.key(), best.text, c.text(best));
  if (candidates.size() > 1)
    found += fmt::format("; within the intervals anywhere from {} to {}", candidates.front()->text,
                         candidates.back()->text);
  if (inside == std::ssize(candidates)) return {found, Holds::yes};
  return {found, inside > 0 ? Holds::undecided : Holds::no};
}

}  // namespace mahlwerk::report
