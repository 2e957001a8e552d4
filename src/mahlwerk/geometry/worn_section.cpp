// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/worn_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/trig.hpp"

namespace mahlwerk::geometry {
namespace {

PlanePoint less_by(const PlanePoint& a, const PlanePoint& b) {
  return {a.x - b.x, a.y - b.y};
}
double across(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.y - a.y * b.x;
}
double along(const PlanePoint& a, const PlanePoint& b) {
  return a.x * b.x + a.y * b.y;
}
double long_as(const PlanePoint& a) {
  return std::sqrt(along(a, a));
}

std::size_t next_of(const Section& s, std::size_t i) {
  return i + 1 == s.size() ? 0 : i + 1;
}
std::size_t last_of(const Section& s, std::size_t i) {
  return i == 0 ? s.size() - 1 : i - 1;
}

/// Unit normal of a side of an anticlockwise section, outwards.
PlanePoint outward(const Section& s, std::size_t side) {
  const PlanePoint d = less_by(s[next_of(s, side)], s[side]);
  const double length = long_as(d);
  return {d.y / length, -d.x / length};
}

/// How far each corner moves if its two sides move in by these depths [m]: along their bisector, so
/// that sides of equal depth move by it exactly.
std::vector<PlanePoint> moves_of(const Section& s, const std::vector<double>& depths) {
  constexpr double sharpest = 0.5;  // cosine of half the turn; sharper corners move less
  std::vector<PlanePoint> moves;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::size_t before = last_of(s, i);
    const PlanePoint a = outward(s, before), b = outward(s, i);
    const PlanePoint sum{a.x + b.x, a.y + b.y};
    const double length = long_as(sum), half = 0.5 * length;  // the cosine of half the turn
    const double depth = 0.5 * (depths[before] + depths[i]);
    const double far = half > 0 ? depth / std::max(half, sharpest) / length : 0;
    moves.push_back({-far * sum.x, -far * sum.y});
  }
  return moves;
}

/// The area of corners p + s m is A + s linear + s^2 square.
struct AreaChange {
  double linear = 0, square = 0;
};
AreaChange change_of(const Section& s, const std::vector<PlanePoint>& moves) {
  AreaChange c;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const std::size_t next = next_of(s, i);
    c.linear += 0.5 * (across(s[i], moves[next]) + across(moves[i], s[next]));
    c.square += 0.5 * across(moves[i], moves[next]);
  }
  return c;
}

double squared_distance(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  const PlanePoint d = less_by(b, a), r = less_by(p, a);
  const double share = std::clamp(along(r, d) / along(d, d), 0.0, 1.0);
  const PlanePoint off{r.x - share * d.x, r.y - share * d.y};
  return along(off, off);
}

bool holds(const Section& s, const PlanePoint& p) {
  bool inside = false;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PlanePoint &a = s[i], &b = s[next_of(s, i)];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

/// The one corner in place of the short side between corners i and j: the area stays.
PlanePoint merged(const Section& s, std::size_t i, std::size_t j) {
  const PlanePoint &a = s[last_of(s, i)], &b = s[next_of(s, j)];
  const PlanePoint middle{0.5 * (s[i].x + s[j].x), 0.5 * (s[i].y + s[j].y)};
  const PlanePoint base = less_by(b, a);
  const double missing = across(less_by(s[i], a), less_by(s[j], a)) +
                         across(less_by(s[j], a), base) - across(less_by(middle, a), base);
  const double far = missing / along(base, base);
  return {middle.x + far * base.y, middle.y - far * base.x};
}

}  // namespace

double area_of(const Section& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.size(); ++i) sum += across(s[i], s[next_of(s, i)]);
  return 0.5 * sum;
}

double length_of(const Section& s, std::size_t side) {
  return long_as(less_by(s[next_of(s, side)], s[side]));
}

Section cut_into_pieces(Section s, double longest) {
  if (area_of(s) < 0) std::ranges::reverse(s);
  constexpr double rounding = 1e-9;
  Section cut;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PlanePoint d = less_by(s[next_of(s, i)], s[i]);
    const double pieces = std::max(1.0, std::ceil(long_as(d) / longest - rounding));
    for (double k = 0; k < pieces; ++k)
      cut.push_back({s[i].x + k / pieces * d.x, s[i].y + k / pieces * d.y});
  }
  return cut;
}

std::size_t nearest_side(const Section& s, const PlanePoint& p) {
  std::size_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < s.size(); ++i)
    if (const double far = squared_distance(s[i], s[next_of(s, i)], p); far < least)
      least = far, found = i;
  return found;
}

std::vector<double> spread_along(const Section& s, std::vector<double> lost,
                                 const std::vector<bool>& exposed, double width) {
  const std::size_t n = s.size();
  std::vector<double> lengths(n);
  for (std::size_t i = 0; i < n; ++i) lengths[i] = length_of(s, i);
  const double shortest = *std::ranges::min_element(lengths);
  if (!(width > 0) || !(shortest > 0)) return lost;
  // Explicit steps of conduction: stable where a step is at most a half of the squared distance.
  constexpr double stable = 0.25, most_steps = 1e5;
  const double steps =
      std::min(most_steps, std::ceil(0.5 * width * width / (stable * shortest * shortest)));
  const double per_step = 0.5 * width * width / steps;
  std::vector<double> flow(n);  // from side i to the next one
  for (double k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = next_of(s, i);
      flow[i] = exposed[i] && exposed[j]
                    ? per_step * (lost[i] / lengths[i] - lost[j] / lengths[j]) /
                          (0.5 * (lengths[i] + lengths[j]))
                    : 0;
    }
    for (std::size_t i = 0; i < n; ++i) {
      lost[i] -= flow[i];
      lost[next_of(s, i)] += flow[i];
    }
  }
  return lost;
}

std::optional<Section> worn_section(const Section& s, const std::vector<double>& lost) {
  double sum = 0;
  std::vector<double> depths(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    depths[i] = lost[i] / length_of(s, i);
    sum += lost[i];
  }
  if (!(sum > 0)) return s;
  const std::vector<PlanePoint> moves = moves_of(s, depths);
  const AreaChange change = change_of(s, moves);
  const double root = change.linear * change.linear - 4 * change.square * sum;
  if (!(root >= 0) || !(change.linear < 0)) return std::nullopt;
  const double scale = 2 * sum / (-change.linear + std::sqrt(root));
  Section worn = s;
  for (std::size_t i = 0; i < s.size(); ++i) {
    worn[i].x += scale * moves[i].x;
    worn[i].y += scale * moves[i].y;
  }
  if (!(area_of(worn) > 0) || !flaw_of(worn).empty()) return std::nullopt;
  return worn;
}

Section without_short_sides(Section s, double shortest) {
  for (std::size_t i = 0; i < s.size() && s.size() > 4;) {
    const std::size_t j = next_of(s, i);
    if (length_of(s, i) >= shortest) {
      ++i;
      continue;
    }
    Section fewer = s;
    fewer[i] = merged(s, i, j);
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(j));
    if (!flaw_of(fewer).empty())
      ++i;  // it stays
    else
      s = std::move(fewer);
  }
  return s;
}

double share_of_circle(const Section& s, double radius) {
  std::vector<double> angles;  // at which the circle crosses a side
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PlanePoint &a = s[i], d = less_by(s[next_of(s, i)], a);
    const double square = along(d, d), linear = along(a, d);
    const double root = linear * linear - square * (along(a, a) - radius * radius);
    if (!(root > 0)) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double at = (-linear + sign * std::sqrt(root)) / square;
      if (at >= 0 && at < 1) angles.push_back(math::atan2(a.y + at * d.y, a.x + at * d.x));
    }
  }
  constexpr double whole = 2 * std::numbers::pi;
  if (angles.empty()) return holds(s, {radius, 0}) ? 1 : 0;
  std::ranges::sort(angles);
  double inside = 0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double to = i + 1 < angles.size() ? angles[i + 1] : angles[0] + whole;
    const SinCos middle = sin_cos(0.5 * (angles[i] + to));
    if (holds(s, {radius * middle.cos, radius * middle.sin})) inside += to - angles[i];
  }
  return inside / whole;
}

}  // namespace mahlwerk::geometry
