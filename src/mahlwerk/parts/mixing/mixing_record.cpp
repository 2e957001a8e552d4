// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/mixing/mixing_record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/kinematics/any_motion.hpp"

namespace mahlwerk::parts::mixing {
namespace {

/// Directions of a jar at an instant: along its axis, up, and level across both.
struct Directions {
  Vec3 axis, up, across;
};
Directions directions(const scene::Chamber& mill, double time) {
  Directions d;
  d.axis = kinematics::rotation(*mill.motion, time) * mill.mount.ez;
  const double g = norm(mill.gravity);
  d.up = g > 0 ? -mill.gravity / g : Vec3{0, 0, 1};
  const Vec3 level = cross(d.axis, d.up);
  const Vec3 other = kinematics::rotation(*mill.motion, time) * mill.mount.ex;
  d.across = norm(level) > 0.1 ? level / norm(level) : other - dot(other, d.up) * d.up;
  return d;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

/// The halves of the charge, by the median of a coordinate; or the first ball set and the others.
void MixingRecord::colour(const std::vector<scene::Ball>& balls, double time) {
  using Colour = Mixing::Colour;
  const Directions d = directions(setup_.mill, time);
  const auto place = [&](const scene::Ball& b) {
    const Vec3& p = b.position;
    switch (setup_.section.colour) {
      case Colour::across:
        return dot(p, d.across);
      case Colour::height:
        return dot(p, d.up);
      case Colour::axis:
        return dot(p, d.axis);
      case Colour::radius:
        return norm(p - dot(p, d.axis) * d.axis);
      case Colour::sets:
        break;
    }
    return 0.0;
  };
  colours_.assign(balls.size(), 0);
  if (setup_.section.colour == Colour::sets) {
    for (std::size_t i = 0; i < balls.size(); ++i) colours_[i] = balls[i].kind == 0 ? 1 : 0;
    return;
  }
  std::vector<double> places;
  for (const scene::Ball& b : balls) places.push_back(place(b));
  const double middle = median(places);
  for (std::size_t i = 0; i < balls.size(); ++i) colours_[i] = places[i] < middle ? 1 : 0;
}

/// Ways along the axis; in a periodic jar by the nearest image from sample to sample.
void MixingRecord::follow(const std::vector<scene::Ball>& balls, double time) {
  const Vec3 axis = directions(setup_.mill, time).axis;
  const double period = geometry::periods(*setup_.mill.shape).z;
  if (axial_.empty()) moved_.assign(balls.size(), 0), axial_.assign(balls.size(), 0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double now = dot(balls[i].position, axis);
    if (!samples_.empty()) {
      double way = now - axial_[i];
      if (std::isfinite(period)) way = std::remainder(way, period);
      moved_[i] += way;
    }
    axial_[i] = now;
  }
}

/// Mean packing around balls that are farther than a ball and a half from all walls (mix.5).
double MixingRecord::packing(const std::vector<scene::Ball>& balls, double time) const {
  constexpr std::size_t probes = 200;
  const double radius = 1.5 * setup_.diameter;
  const Rotation own = kinematics::rotation(*setup_.mill.motion, time) * setup_.mill.mount;
  const std::size_t each = std::max<std::size_t>(1, balls.size() / probes);
  std::vector<double> found;
  std::vector<scene::Ball> near;
  for (std::size_t i = 0; i < balls.size(); i += each) {
    const Vec3& p = balls[i].position;
    if (geometry::nearest_wall(*setup_.mill.shape, own.apply_inverse(p), radius) < radius) continue;
    near.clear();
    for (const scene::Ball& b : balls)
      if (squared(b.position - p) < (radius + b.radius) * (radius + b.radius)) near.push_back(b);
    found.push_back(observe::packing_around(near, p, radius));
  }
  if (found.empty()) return std::numeric_limits<double>::quiet_NaN();
  // Half of the probes are deep in the bed, unless it is shallow: the upper quartile of all.
  std::ranges::sort(found);
  const auto from = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  return std::accumulate(from, found.end(), 0.0) / static_cast<double>(found.end() - from);
}

void MixingRecord::take_balls(const scene::EnergyBalance& now, double time_of_balls,
                              const std::vector<scene::Ball>& balls) {
  const double time = time_of_balls;
  if (colours_.empty()) colour(balls, time);
  while (next() <= now.time) {
    follow(balls, time);
    MixingSample s;
    s.time = setup_.interval * static_cast<double>(samples_.size());
    const observe::MixingIndex index =
        observe::mixing_index(balls, colours_, setup_.cell, setup_.reach);
    s.lacey = index.lacey, s.neighbours = index.neighbours;
    const Directions d = directions(setup_.mill, time);
    double all = 0, marked = 0, r = 0, r_marked = 0, h = 0, h_marked = 0, spread = 0, r2 = 0,
           h2 = 0;
    std::vector<double> heights;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3& p = balls[i].position;
      const double radius = norm(p - dot(p, d.axis) * d.axis), height = dot(p, d.up);
      const double of = colours_[i];
      all += 1, marked += of, r += radius, h += height, r_marked += of * radius;
      h_marked += of * height, r2 += radius * radius, h2 += height * height;
      spread += moved_[i] * moved_[i];
      heights.push_back(height);
    }
    const auto apart = [&](double sum, double sum_marked, double squares) {
      const double width = std::sqrt(std::max(0.0, squares / all - sum / all * (sum / all)));
      return marked > 0 && width > 0 ? (sum_marked / marked - sum / all) / width : 0.0;
    };
    s.radial = apart(r, r_marked, r2), s.vertical = apart(h, h_marked, h2);
    s.axial_spread = spread / all;
    s.packing = packing(balls, time);
    std::ranges::sort(heights);
    const auto at = [&](double share) {
      return heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))];
    };
    s.bed_height = at(0.98) - at(0) + setup_.diameter;
    samples_.push_back(s);
  }
}

}  // namespace mahlwerk::parts::mixing
