// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/shapes.hpp"

// Triangle surfaces for tests, and brute-force queries of points on them.
namespace mahlwerk::tests {

using geometry::Corners;
using Triangles = std::vector<Corners>;

constexpr double crease = std::numbers::pi / 6;  // the default of a case [rad]

inline geometry::Mesh mesh_of(const Triangles& t, double angle = crease) {
  return {geometry::weld(t), angle};
}

/// Triangulates an anticlockwise polygon: as a fan about the origin if all of the polygon is
/// visible from there, otherwise by ear clipping.
inline Triangles filled(std::vector<Vec3> polygon) {
  Triangles t;
  const auto turn = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return cross(b - a, c - a).z;
  };
  for (std::size_t i = 0; i < polygon.size(); ++i)
    t.push_back({Vec3{}, polygon[i], polygon[(i + 1) % polygon.size()]});
  if (std::ranges::all_of(t, [&](const Corners& c) { return turn(c[0], c[1], c[2]) > 0; }))
    return t;
  t.clear();
  while (polygon.size() > 2) {
    const std::size_t n = polygon.size();
    const auto is_ear = [&](std::size_t i) {
      const Vec3 a = polygon[i], b = polygon[(i + 1) % n], c = polygon[(i + 2) % n];
      return turn(a, b, c) > 0 && std::ranges::none_of(polygon, [&](const Vec3& p) {
               return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                      turn(c, a, p) >= 0;
             });
    };
    std::size_t i = 0;
    while (!is_ear(i)) ++i;
    t.push_back({polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
  }
  return t;
}

/// An anticlockwise polygon extruded along z.
inline Triangles prism(const std::vector<Vec3>& polygon, double height) {
  Triangles t;
  const Vec3 up{0, 0, 0.5 * height};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    t.push_back({a - up, b - up, b + up});
    t.push_back({a - up, b + up, a + up});
  }
  for (const auto& [a, b, c] : filled(polygon)) {
    t.push_back({a + up, b + up, c + up});
    t.push_back({a - up, c - up, b - up});
  }
  return t;
}

inline std::vector<Vec3> regular(int corners, double radius) {
  std::vector<Vec3> p;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    p.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return p;
}

inline Triangles cylinder(int corners, double diameter, double height) {
  return prism(regular(corners, 0.5 * diameter), height);
}

/// A sphere of triangles: `rings` rings from pole to pole, twice as many facets around the axis.
inline Triangles ball_of_triangles(int rings, double radius) {
  const auto at = [&](int i, int j) {
    const double a = std::numbers::pi * i / rings, b = std::numbers::pi * (j % (2 * rings)) / rings;
    if (i == 0 || i == rings) return Vec3{0, 0, i == 0 ? radius : -radius};
    return radius * Vec3{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
  };
  Triangles t;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < 2 * rings; ++j) {
      if (i + 1 < rings) t.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      if (i > 0) t.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return t;
}

inline Triangles box(double width, double depth, double height) {
  const double w = 0.5 * width, d = 0.5 * depth;
  return prism({{w, -d, 0}, {w, d, 0}, {-w, d, 0}, {-w, -d, 0}}, height);
}

/// A drum with `bars` lifter bars of this height and width along its shell.
inline Triangles drum_with_lifters(double diameter, double length, int bars, double height,
                                   double width, int facets_between = 12) {
  std::vector<Vec3> p;
  const double r = 0.5 * diameter, half = std::asin(0.5 * width / r), pi = std::numbers::pi;
  for (int b = 0; b < bars; ++b) {
    const double from = 2 * pi * b / bars, to = 2 * pi * (b + 1) / bars;
    const Vec3 out{std::cos(from), std::sin(from), 0}, side{-out.y, out.x, 0};
    const double foot = r * std::cos(half);
    p.push_back(foot * out - 0.5 * width * side);
    p.push_back((foot - height) * out - 0.5 * width * side);
    p.push_back((foot - height) * out + 0.5 * width * side);
    for (int i = 0; i < facets_between; ++i) {
      const double a = from + half + (to - from - 2 * half) * i / facets_between;
      p.push_back(r * Vec3{std::cos(a), std::sin(a), 0});
    }
  }
  return prism(p, length);
}

/// A sphere-like surface: an octahedron whose triangles are divided into four, `rounds` times. Its
/// corners are at the distance `radius(direction)` from the origin.
template <class Radius>
Triangles ball(int rounds, Radius radius) {
  Triangles t;
  for (const double z : {1.0, -1.0})
    for (int k = 0; k < 4; ++k) {
      const std::array<Vec3, 4> round{Vec3{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
      const Vec3 a = round[static_cast<std::size_t>(k)];
      const Vec3 b = round[static_cast<std::size_t>((k + 1) % 4)], c{0, 0, z};
      t.push_back(z > 0 ? Corners{a, b, c} : Corners{b, a, c});
    }
  const auto unit = [](const Vec3& a) { return a / norm(a); };
  for (int n = 0; n < rounds; ++n) {
    Triangles finer;
    for (const auto& [a, b, c] : t) {
      const Vec3 ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
      for (const Corners& part :
           {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c}, Corners{ab, bc, ca}})
        finer.push_back(part);
    }
    t = finer;
  }
  for (Corners& c : t)
    for (Vec3& p : c) p = radius(p) * p;
  return t;
}

/// A jar with irregular dents and bulges.
inline Triangles lumpy(double size, int rounds = 3) {
  return ball(rounds, [size](const Vec3& d) {
    return size * (1 + 0.2 * std::sin(5 * d.x + 1) * std::sin(4 * d.y) + 0.15 * std::sin(7 * d.z));
  });
}

/// The nearest point of one triangle, from its three sides and its plane.
inline Vec3 nearest_on(const Corners& t, const Vec3& p) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  bool above = true;
  for (std::size_t k = 0; k < 3; ++k)
    above = above && dot(cross(n, t[(k + 1) % 3] - t[k]), p - t[k]) >= 0;
  if (above) return p - dot(n, p - t[0]) / squared(n) * n;
  Vec3 best = t[0];
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 way = t[(k + 1) % 3] - t[k];
    const Vec3 q = t[k] + std::clamp(dot(way, p - t[k]) / squared(way), 0.0, 1.0) * way;
    if (squared(p - q) < squared(p - best)) best = q;
  }
  return best;
}

inline double distance_to(const Triangles& all, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& t : all) least = std::min(least, norm(p - nearest_on(t, p)));
  return least;
}

/// Winding number of the surface about a point: 1 inside, 0 outside (van Oosterom and Strackee
/// 1983).
inline double winding(const Triangles& all, const Vec3& p) {
  double sum = 0;
  for (const Corners& t : all) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    sum += 2 * std::atan2(dot(a, cross(b, c)),
                          la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

inline Vec3 random_point_in(const geometry::Extent& e, Random& random) {
  return {random.uniform(e.low.x, e.high.x), random.uniform(e.low.y, e.high.y),
          random.uniform(e.low.z, e.high.z)};
}

/// Binary STL as CAD programs write it. Numbers in the file are `per_metre` times those in m.
inline std::string binary_stl(const Triangles& all, double per_metre = 1000,
                              std::string head = "solid by a CAD program") {
  head.resize(80, ' ');
  std::string bytes = head;
  const auto put = [&](std::uint32_t n) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(n >> 8 * k & 0xff);
  };
  put(static_cast<std::uint32_t>(all.size()));
  for (const Corners& t : all) {
    for (int k = 0; k < 3; ++k) put(0);  // the normal, which many programs leave empty
    for (const Vec3& c : t)
      for (const double x : {c.x, c.y, c.z})
        put(std::bit_cast<std::uint32_t>(static_cast<float>(x * per_metre)));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

}  // namespace mahlwerk::tests
