// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/sizes.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

SizeGrid::SizeGrid(double middle, double largest, double smallest, int per_octave)
    : per_octave_(per_octave) {
  constexpr double rounding = 1e-9;  // an end on an edge needs no further class
  const double half = 0.5 / per_octave;
  const auto above = static_cast<int>(
      std::ceil(std::max(0.0, (math::log2(largest / middle) - half) * per_octave - rounding)));
  const auto below = static_cast<int>(
      std::ceil(std::max(0.0, (math::log2(middle / smallest) - half) * per_octave - rounding)));
  top_ = middle * math::exp2(half + static_cast<double>(above) / per_octave);
  classes_ = above + 1 + below;
}

double SizeGrid::upper(int i) const {
  return top_ * math::exp2(-static_cast<double>(i) / per_octave_);
}

double SizeGrid::middle(int i) const {
  return top_ * math::exp2(-(static_cast<double>(i) + 0.5) / per_octave_);
}

int SizeGrid::class_of(double size) const {
  const double place = math::log2(top_ / size) * per_octave_;
  return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(classes_ - 1)));
}

std::vector<double> SizeGrid::shares(const Feed& feed) const {
  std::vector<double> found(static_cast<std::size_t>(classes_));
  if (feed.law == Feed::Law::equal) {
    found[static_cast<std::size_t>(class_of(feed.size))] = 1;
    return found;
  }
  double above = 1;  // share finer than the upper edge; coarser mass is in the first class
  for (int i = 0; i < classes_; ++i) {
    const double below = i + 1 < classes_ ? feed.undersize(lower(i)) : 0;
    found[static_cast<std::size_t>(i)] = above - below;
    above = below;
  }
  return found;
}

double quantile(const SizeGrid& grid, const std::vector<double>& shares, double share) {
  double below = 0;
  for (int i = grid.classes() - 1; i >= 0; --i) {
    const double here = shares[static_cast<std::size_t>(i)];
    if (here > 0 && below + here >= share) {
      const double part = std::clamp((share - below) / here, 0.0, 1.0);
      return grid.lower(i) * math::exp2(part / grid.per_octave());
    }
    below += here;
  }
  return grid.upper(0);
}

double undersize(const SizeGrid& grid, const std::vector<double>& shares, double size) {
  double below = 0;
  for (int i = grid.classes() - 1; i >= 0 && size > grid.lower(i); --i) {
    const double part = std::min(1.0, math::log2(size / grid.lower(i)) * grid.per_octave());
    below += part * shares[static_cast<std::size_t>(i)];
  }
  return below;
}

double specific_surface(const SizeGrid& grid, const std::vector<double>& shares, double density) {
  double sum = 0;
  for (int i = 0; i < grid.classes(); ++i)
    sum += shares[static_cast<std::size_t>(i)] / grid.middle(i);
  return 6 / density * sum;
}

double mean_size(const SizeGrid& grid, const std::vector<double>& shares) {
  double sum = 0;
  for (int i = 0; i < grid.classes(); ++i)
    sum += shares[static_cast<std::size_t>(i)] * grid.middle(i);
  return sum;
}

}  // namespace mahlwerk::powder
