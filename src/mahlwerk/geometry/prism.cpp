// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/prism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/rotation.hpp"

namespace mahlwerk::geometry {
namespace {

/// Twice the area of a triangle, > 0 if its corners run anticlockwise.
double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubled_area(const Section& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.size(); ++i) sum += turn({}, s[i], s[(i + 1) % s.size()]);
  return sum;
}

bool within_box(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Whether two sides share a point.
bool meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
  const double ca = turn(c, d, a), cb = turn(c, d, b), ac = turn(a, b, c), ad = turn(a, b, d);
  if (((ca > 0 && cb < 0) || (ca < 0 && cb > 0)) && ((ac > 0 && ad < 0) || (ac < 0 && ad > 0)))
    return true;
  return (ca == 0 && within_box(c, d, a)) || (cb == 0 && within_box(c, d, b)) ||
         (ac == 0 && within_box(a, b, c)) || (ad == 0 && within_box(a, b, d));
}

bool in_triangle(const std::array<PlanePoint, 3>& t, const PlanePoint& p) {
  return turn(t[0], t[1], p) >= 0 && turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0;
}

/// Whether the corner k of an anticlockwise section can be cut off: it is convex and its triangle
/// holds no other corner.
bool is_ear(const Section& s, std::size_t k) {
  const std::size_t n = s.size();
  const std::array<PlanePoint, 3> t{s[(k + n - 1) % n], s[k], s[(k + 1) % n]};
  if (!(turn(t[0], t[1], t[2]) > 0)) return false;
  return std::ranges::none_of(s, [&](const PlanePoint& p) {
    return p != t[0] && p != t[1] && p != t[2] && in_triangle(t, p);
  });
}

/// Triangles that fill an anticlockwise section, ear by ear.
std::vector<std::array<PlanePoint, 3>> filled(Section s) {
  std::vector<std::array<PlanePoint, 3>> all;
  while (s.size() > 2) {
    std::size_t k = 0;
    while (k < s.size() && !is_ear(s, k)) ++k;
    if (k == s.size()) k = 0;  // only corners on a straight line are left
    const std::size_t n = s.size();
    all.push_back({s[(k + n - 1) % n], s[k], s[(k + 1) % n]});
    s.erase(s.begin() + static_cast<std::ptrdiff_t>(k));
  }
  return all;
}

}  // namespace

std::string flaw_of(const Section& s) {
  const std::size_t n = s.size();
  if (n < 3) return "a section needs three corners or more";
  for (std::size_t i = 0; i < n; ++i)
    if (s[i] == s[(i + 1) % n])
      return fmt::format("corners {} and {} are one", i + 1, (i + 1) % n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && meet(s[i], s[i + 1], s[j], s[(j + 1) % n]))
        return fmt::format("its sides after corners {} and {} meet", i + 1, j + 1);
  }
  return doubled_area(s) == 0 ? "it has no area" : "";
}

double angular_width(const Section& s) {
  double low = 0, high = 0, angle = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PlanePoint& a = s[i];
    const PlanePoint& b = s[(i + 1) % s.size()];
    angle += math::atan2(turn({}, a, b), a.x * b.x + a.y * b.y);
    low = std::min(low, angle), high = std::max(high, angle);
  }
  return std::min(high - low, 2 * std::numbers::pi);
}

std::vector<Corners> prism(Section section, double length, int copies) {
  if (doubled_area(section) < 0) std::ranges::reverse(section);
  std::vector<Corners> one;
  const double half = 0.5 * length;
  const auto at = [](const PlanePoint& p, double z) { return Vec3{p.x, p.y, z}; };
  for (const auto& t : filled(section)) {
    one.push_back({at(t[0], half), at(t[1], half), at(t[2], half)});
    one.push_back({at(t[0], -half), at(t[2], -half), at(t[1], -half)});
  }
  for (std::size_t i = 0; i < section.size(); ++i) {
    const PlanePoint& a = section[i];
    const PlanePoint& b = section[(i + 1) % section.size()];
    one.push_back({at(a, -half), at(b, -half), at(b, half)});
    one.push_back({at(a, -half), at(b, half), at(a, half)});
  }
  std::vector<Corners> all;
  for (int k = 0; k < copies; ++k) {
    const Rotation q = rotation_about({0, 0, 1}, 2 * std::numbers::pi * k / copies);
    for (const Corners& c : one) all.push_back({q * c[0], q * c[1], q * c[2]});
  }
  return all;
}

}  // namespace mahlwerk::geometry
