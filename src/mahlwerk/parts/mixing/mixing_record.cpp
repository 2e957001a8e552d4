// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/mixing/mixing_record.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "mahlwerk/observe/mixing.hpp"
#include "mahlwerk/observe/packing.hpp"

namespace mahlwerk::parts::mixing {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// How far the first colour is from the mean of all, in standard deviations of all (mix.4).
class Segregation {
 public:
  void add(double x, double marked) {
    ++all_, sum_ += x, squares_ += x * x;
    marked_ += marked, sum_marked_ += marked * x;
  }
  double value() const {
    const double mean = sum_ / all_,
                 width = std::sqrt(std::max(0.0, squares_ / all_ - mean * mean));
    return marked_ > 0 && width > 0 ? (sum_marked_ / marked_ - mean) / width : 0.0;
  }

 private:
  double all_ = 0, sum_ = 0, squares_ = 0, marked_ = 0, sum_marked_ = 0;
};

}  // namespace

std::vector<scene::Ball> inside(const std::vector<scene::Ball>& balls) {
  std::vector<scene::Ball> found;
  std::ranges::copy_if(balls, std::back_inserter(found),
                       [](const scene::Ball& b) { return !b.outside; });
  return found;
}

/// The sample of a jar without balls.
MixingSample empty_jar() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {.lacey = none,
          .neighbours = none,
          .radial = none,
          .vertical = none,
          .axial = none,
          .axial_spread = none,
          .packing = none,
          .bed_height = none};
}

/// The halves of the charge, by the median of a coordinate; or the first ball set and the others.
/// Balls outside the jar have a colour by their set only.
void MixingRecord::colour(const std::vector<scene::Ball>& balls, const Instant& d) {
  using Colour = Mixing::Colour;
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
  for (const scene::Ball& b : balls)
    if (!b.outside) places.push_back(place(b));
  const double middle = places.empty() ? 0 : median(places);
  for (std::size_t i = 0; i < balls.size(); ++i)
    colours_[i] = balls[i].outside ? uncoloured : place(balls[i]) < middle ? 1 : 0;
}

/// Ways along the axis; in a periodic jar by the nearest image from sample to sample.
void MixingRecord::follow(const std::vector<scene::Ball>& balls, const Instant& at) {
  if (axial_.empty()) moved_.assign(balls.size(), 0), axial_.assign(balls.size(), 0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double now = dot(balls[i].position, at.axis);
    if (!samples_.empty()) {
      double way = now - axial_[i];
      if (std::isfinite(at.periods.z)) way = std::remainder(way, at.periods.z);
      moved_[i] += way;
    }
    axial_[i] = now;
  }
}

/// Mean packing in the bed (mix.5), which it adds to the profile; NaN without a bed.
double MixingRecord::packing(const std::vector<scene::Ball>& balls,
                             const std::vector<scene::Ball>& own, const Instant& at) {
  const std::vector<observe::LocalPacking> found = observe::packing_in_bed(
      {.balls = own,
       .diameter = setup_.diameter,
       .periods = at.periods,
       .clearance = [&](const Vec3& p, double within) { return at.clearance(p, within); }});
  double lowest = std::numeric_limits<double>::infinity(), sum = 0;
  for (const scene::Ball& b : balls) lowest = std::min(lowest, dot(b.position, at.up) - b.radius);
  std::vector<PackingAtHeight> layers;
  for (const observe::LocalPacking& one : found) {
    const double height = dot(at.in_jar_frame(one.at), at.up) - lowest;
    const auto layer = static_cast<std::size_t>(std::max(0.0, height / layer_height()));
    while (layers.size() <= layer)
      layers.push_back({.sample = static_cast<std::uint32_t>(samples_.size()),
                        .layer = static_cast<std::uint32_t>(layers.size())});
    layers[layer].sum += one.packing, ++layers[layer].points;
    sum += one.packing;
  }
  for (const PackingAtHeight& one : layers)
    if (one.points > 0) profile_.push_back(one);
  return found.empty() ? std::numeric_limits<double>::quiet_NaN()
                       : sum / static_cast<double>(found.size());
}

/// Indices of mixing and segregation of balls with these colours (mix.1, mix.2, mix.4).
void MixingRecord::add_indices(MixingSample& s, const std::vector<scene::Ball>& balls,
                               const std::vector<std::uint8_t>& colours, const Instant& at) const {
  s.lacey = observe::lacey_index(balls, colours, setup_.cell);
  s.neighbours = observe::neighbour_index(at.in_own_axes(balls), colours, setup_.reach, at.periods);
  Segregation radial, vertical, axial;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3& p = balls[i].position;
    const double along = dot(p, at.axis), marked = colours[i];
    radial.add(norm(p - along * at.axis), marked);
    vertical.add(dot(p, at.up), marked);
    axial.add(along, marked);
  }
  s.radial = radial.value(), s.vertical = vertical.value();
  s.axial = std::isfinite(at.periods.z) ? std::numeric_limits<double>::quiet_NaN() : axial.value();
}

/// Those of the balls in the jar that have a colour.
void MixingRecord::add_indices_of_coloured(MixingSample& s, const std::vector<scene::Ball>& all,
                                           const Instant& at) const {
  std::vector<scene::Ball> balls;
  std::vector<std::uint8_t> colours;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!all[i].outside && colours_[i] != uncoloured)
      balls.push_back(all[i]), colours.push_back(colours_[i]);
  if (!balls.empty()) add_indices(s, balls, colours, at);
}

/// Of the balls in the jar: packing, height and the way along the axis.
MixingSample MixingRecord::sample(const std::vector<scene::Ball>& balls, const Instant& at) {
  MixingSample s = empty_jar();
  s.time = setup_.interval * static_cast<double>(samples_.size());
  if (balls.empty()) return s;
  if (!setup_.flows) {
    add_indices(s, balls, colours_, at);
    s.axial_spread = 0;
    for (const double moved : moved_)
      s.axial_spread += moved * moved / static_cast<double>(balls.size());
  }
  std::vector<double> heights;
  for (const scene::Ball& b : balls) heights.push_back(dot(b.position, at.up));
  s.packing = packing(balls, at.in_own_axes(balls), at);
  std::ranges::sort(heights);
  const auto height_of = [&](double share) {
    return heights[static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1))];
  };
  s.bed_height = height_of(0.98) - height_of(0) + setup_.diameter;
  return s;
}

void MixingRecord::take_balls(const scene::EnergyBalance& now, double time,
                              const std::vector<scene::Ball>& balls) {
  const double clock = setup_.driven > 0 ? now.mill_angle / setup_.driven : time;
  const Instant at(setup_.mill, clock, setup_.diameter);
  if (colours_.empty()) colour(balls, at);
  while (next() <= now.time)
    if (setup_.flows) {
      MixingSample s = sample(inside(balls), at);
      add_indices_of_coloured(s, balls, at);
      samples_.push_back(s);
    } else {
      follow(balls, at);
      samples_.push_back(sample(balls, at));
    }
}

}  // namespace mahlwerk::parts::mixing
