// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/paper/claim_rules.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/traits.hpp"

namespace mahlwerk::report {
namespace {

using Kind = Claim::Kind;

using Context = ClaimContext;

bool sure(const LinePoint& s) {
  return std::isfinite(s.value) && std::isfinite(s.ci95);
}

Verdict judge_trend(const Context& c, const ClaimLine& line) {
  const std::vector<LinePoint>& s = line.points;
  if (s.size() < 2 || !std::ranges::all_of(s, sure)) return {"no intervals to compare"};
  const bool up = c.claim.is == "rises";
  const auto clear = [&](const LinePoint& a, const LinePoint& b) {
    return up ? b.above(a) : a.above(b);
  };
  std::string unclear;
  std::size_t good = 0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i)
    if (clear(s[i], s[i + 1]))
      ++good;
    else
      unclear += fmt::format("{}{} to {}", unclear.empty() ? "" : ", ", s[i].text, s[i + 1].text);
  std::string found = fmt::format(
      "{} at {} {}, {} at {}; {} by more than both intervals at {} of {} steps", c.text(s.front()),
      c.key(), s.front().text, c.text(s.back()), s.back().text, c.claim.is, good, s.size() - 1);
  if (!unclear.empty() && good > 0) found += ", not from " + unclear;
  if (good == s.size() - 1) return {found, Holds::yes};
  return {found, clear(s.front(), s.back()) ? Holds::partly : Holds::no};
}

/// The ratio b/a with its half-width.
struct Ratio {
  double value = NAN, ci95 = NAN;
};
Ratio ratio(const LinePoint& a, const LinePoint& b) {
  if (!sure(a) || !sure(b) || !(a.value > 0)) return {};
  const double r = b.value / a.value;
  return {r, std::hypot(b.ci95, r * a.ci95) / a.value};
}

Verdict judge_compare(const Context& c, const ClaimLine& line) {
  const LinePoint *a = nullptr, *b = nullptr;
  for (const LinePoint& s : line.points) {
    if (same_value(s.text, c.claim.first)) a = &s;
    if (same_value(s.text, c.claim.second)) b = &s;
  }
  if (a == nullptr || b == nullptr) return {"not run at both values"};
  const Ratio r = ratio(*a, *b);
  std::string found =
      fmt::format("{} at {} {}, {} at {}", c.text(*a), c.key(), a->text, c.text(*b), b->text);
  if (std::isfinite(r.value)) found += ": " + readable(r.value, r.ci95, "").text() + " times";
  const bool larger = b->above(*a), smaller = a->above(*b);
  if (!larger && !smaller) return {found + "; the intervals overlap", Holds::undecided};
  return {found, larger == (c.claim.is == "larger") ? Holds::yes : Holds::no};
}

Verdict judge_alike(const Context& c, const ClaimLine& line) {
  const std::vector<LinePoint>& s = line.points;
  if (s.size() < 2 || !std::ranges::all_of(s, sure)) return {"no intervals to compare"};
  const auto [least, most] = std::ranges::minmax_element(s, {}, &LinePoint::value);
  const Ratio r = ratio(*least, *most);
  const std::string found =
      fmt::format("{} at {} {} to {} at {}: {} times", c.text(*least), c.key(), least->text,
                  c.text(*most), most->text, readable(r.value, r.ci95, "").text());
  const double bound = 1 + c.claim.within;
  if (r.value + r.ci95 <= bound) return {found, Holds::yes};
  return {found, r.value - r.ci95 > bound ? Holds::no : Holds::undecided};
}

/// Lists the regimes along a line; consecutive points with the same regime are grouped.
Verdict judge_regime(const Context& c, const ClaimLine& line) {
  std::string found, last;
  std::size_t good = 0;
  for (const LinePoint& s : line.points) {
    const std::string& now = s.point->regime;
    good += now == c.claim.is ? 1 : 0;
    if (now == last && !found.empty())
      found += s.text.empty() ? "" : ", " + s.text;
    else
      found += fmt::format("{}{}{}{}", found.empty() ? "" : "; ", now.empty() ? "none" : now,
                           s.text.empty() ? "" : " at " + c.key() + " ", s.text);
    last = now;
  }
  if (good == line.points.size()) return {found, Holds::yes};
  return {found, good > 0 ? Holds::partly : Holds::no};
}

/// A value in SI units, in the unit of a quantity of the summary: J/g, deg.
double in_unit(double si, const std::string& unit) try {
  const double zero = parse_quantity("0 " + unit).value;
  return (si - zero) / (parse_quantity("1 " + unit).value - zero);
} catch (const UnitError&) {
  return si;  // "1", "1/s"
}

Verdict judge_bound(const Context& c, const ClaimLine& line) {
  const double limit = in_unit(c.claim.bound, c.unit);
  std::string found;
  std::size_t good = 0, bad = 0;
  for (const LinePoint& s : line.points) {
    const bool above = s.low() > limit, below = s.high() < limit;
    const bool wanted = c.claim.is == "above";
    good += (wanted ? above : below) ? 1 : 0;
    bad += (wanted ? below : above) ? 1 : 0;
    found += fmt::format("{}{}{}", found.empty() ? "" : ", ", c.text(s),
                         s.text.empty() ? "" : " at " + s.text);
  }
  if (good == line.points.size()) return {found, Holds::yes};
  if (good > 0) return {found, Holds::partly};
  return {found, bad == line.points.size() ? Holds::no : Holds::undecided};
}

Verdict judge_line(const Context& c, const ClaimLine& line) {
  switch (c.claim.kind) {
    case Kind::law:
      return judge_law(c, line);
    case Kind::trend:
      return judge_trend(c, line);
    case Kind::compare:
      return judge_compare(c, line);
    case Kind::alike:
      return judge_alike(c, line);
    case Kind::regime:
      return judge_regime(c, line);
    case Kind::bound:
      return judge_bound(c, line);
    case Kind::maximum:
      return judge_maximum(c, line);
    case Kind::measured:        // all lines together
    case Kind::capture_bounds:  // of the outcomes, captured_table.cpp
      break;
  }
  return {};
}

/// The verdicts of lines with many combinations of keys, counted.
std::string counted(const std::vector<Verdict>& lines) {
  std::string text;
  for (const Holds one : {Holds::yes, Holds::partly, Holds::no, Holds::undecided}) {
    const auto count = std::ranges::count(lines, one, &Verdict::holds);
    if (count > 0) text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", word(one), count);
  }
  return fmt::format("{} of {} combinations of the other keys", text, lines.size());
}

}  // namespace

std::string_view word(Holds holds) {
  switch (holds) {
    case Holds::yes:
      return "yes";
    case Holds::partly:
      return "partly";
    case Holds::no:
      return "no";
    case Holds::undecided:
      return "undecided";
  }
  return "";
}

std::string ClaimContext::text(double value, double ci95) const {
  return readable(value, ci95, unit).text();
}

std::string ClaimContext::text(const LinePoint& s) const {
  return readable_within(s.value, s.ci95, unit, results::range_of(claim.quantity)).text();
}

std::string ClaimContext::key() const {
  return key_words(claim.against);
}

Verdict judge(const Claim& claim, const Campaign& campaign, const Measurement* measured) {
  const Context context{claim, campaign, unit_of(campaign, claim.quantity)};
  std::vector<ClaimLine> lines = lines_along(campaign, claim.at, claim.against, claim.quantity);
  if (lines.empty()) return {"no such point was run"};
  if (claim.kind == Kind::measured)
    return measured == nullptr ? Verdict{"no measured values"}
                               : judge_measured(context, std::move(lines), *measured);
  std::vector<Verdict> each;
  for (const ClaimLine& line : lines) each.push_back(judge_line(context, line));
  Verdict all;
  const bool same = std::ranges::all_of(
      each, [&](const Verdict& one) { return one.holds == each.front().holds; });
  all.holds = same ? each.front().holds : Holds::partly;
  constexpr std::size_t few = 4;
  if (each.size() > few) {
    all.finding = counted(each);
    return all;
  }
  for (std::size_t i = 0; i < each.size(); ++i)
    all.finding += (i == 0 ? "" : "; ") + (lines[i].others.empty() ? "" : lines[i].others + ": ") +
                   each[i].finding;
  return all;
}

}  // namespace mahlwerk::report
