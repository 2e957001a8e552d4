// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/index.hpp"

namespace mahlwerk::event {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

}  // namespace

Cells::Cells(const Vec3& low, const Vec3& size, bool periodic, double side, double slack,
             double most)
    : low_(low), slack_(slack), periodic_(periodic) {
  const double volume = size.x * size.y * size.z;
  const double wide = std::max(side, math::cbrt(volume / std::max(most, 1.0)));
  const auto count = [&](double width) {
    const double several = std::min(5.0, std::floor(width / side));  // see needs_all_images()
    const double least = std::max(several, periodic ? 2.0 : 1.0);
    return static_cast<std::int32_t>(
        std::clamp(std::max(std::floor(width / wide), least), 1.0, mask + 1.0));
  };
  counts_ = {count(size.x), count(size.y), count(size.z)};
  side_ = {size.x / counts_[0], size.y / counts_[1], size.z / counts_[2]};
  per_side_ = {1 / side_.x, 1 / side_.y, 1 / side_.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t n = counts_[axis];
    for (std::int32_t i = 0; i < n; ++i) {
      const bool round = periodic && n > 1;
      lower_neighbour_[axis].push_back(i > 0 ? i - 1 : round && n > 2 ? n - 1 : -1);
      upper_neighbour_[axis].push_back(i < n - 1 ? i + 1 : round && n > 2 ? 0 : -1);
    }
  }
  filled_.assign(as_index(this->count() + 1), 0);
  slots_.assign(as_index((this->count() + 1) * capacity_ + 4), -1);
}

Cell Cells::cell_at(const Vec3& spot) const {
  const Vec3 p = spot - low_;
  const auto index = [](double x, double inverse_side, std::int32_t n) {
    return static_cast<std::int32_t>(std::clamp(x * inverse_side, 0.0, n - 1.0));
  };
  return index(p.x, per_side_.x, counts_[0]) | index(p.y, per_side_.y, counts_[1]) << bits |
         index(p.z, per_side_.z, counts_[2]) << (2 * bits);
}

void Cells::clear() {
  std::fill(filled_.begin(), filled_.end(), 0);
}

void Cells::insert(std::int32_t ball, Cell cell) {
  const std::int32_t where = cell_index(cell);
  std::int32_t& n = filled_[as_index(where)];
  if (n == capacity_) grow();
  slots_[as_index(where * capacity_ + n)] = ball;
  ++n;
}

void Cells::remove(std::int32_t ball, Cell cell) {
  const std::int32_t where = cell_index(cell);
  std::int32_t* const first = &slots_[as_index(where * capacity_)];
  std::int32_t& n = filled_[as_index(where)];
  *std::find(first, first + n, ball) = first[n - 1];
  --n;
}

void Cells::grow() {
  HugePageVector<std::int32_t> larger(as_index((count() + 1) * 2 * capacity_ + 4), -1);
  for (std::int32_t place = 0; place <= count(); ++place)
    std::copy_n(&slots_[as_index(place * capacity_)], filled_[as_index(place)],
                &larger[as_index(place * 2 * capacity_)]);
  slots_ = std::move(larger);
  capacity_ *= 2;
}

int Cells::copy(std::int32_t place, std::int32_t* out, int n) const {
  const std::int32_t* const from = &slots_[as_index(place * capacity_)];
  const std::int32_t many = filled_[as_index(place)];
  std::copy_n(from, 4, out + n);  // always four: one vector move instead of a loop over the count
  for (std::int32_t i = 4; i < many; ++i) out[n + i] = from[i];
  return n + many;
}

void Cells::prefetch(Cell cell) const {
  const auto [x, y, z] = split(cell);
  for (const std::int32_t layer :
       {lower_neighbour_[2][as_index(z)], z, upper_neighbour_[2][as_index(z)]})
    for (const std::int32_t row :
         {lower_neighbour_[1][as_index(y)], y, upper_neighbour_[1][as_index(y)]}) {
      if (layer < 0 || row < 0) continue;
      const std::int32_t middle = cell_index(x, row, layer);
      __builtin_prefetch(&filled_[as_index(middle)]);
      __builtin_prefetch(&slots_[as_index(middle * capacity_)]);
    }
}

int Cells::near(Cell cell, std::int32_t* out) const {
  const auto [x, y, z] = split(cell);
  const std::int32_t left = lower_neighbour_[0][as_index(x)],
                     right = upper_neighbour_[0][as_index(x)];
  int n = 0;
  for (const std::int32_t layer :
       {lower_neighbour_[2][as_index(z)], z, upper_neighbour_[2][as_index(z)]}) {
    if (layer < 0) continue;
    for (const std::int32_t row :
         {lower_neighbour_[1][as_index(y)], y, upper_neighbour_[1][as_index(y)]}) {
      if (row < 0) continue;
      const std::int32_t first = cell_index(0, row, layer);
      n = copy(left < 0 ? 0 : first + left, out, n);
      n = copy(first + x, out, n);
      n = copy(right < 0 ? 0 : first + right, out, n);
    }
  }
  return n;
}

int Cells::newly_near(Cell cell, Cell before, std::int32_t* out) const {
  const auto now = split(cell), was = split(before);
  struct Axis {
    std::array<std::int32_t, 3> at;
    int count;
  };
  std::array<Axis, 3> along;
  int moves = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t down = lower_neighbour_[axis][as_index(now[axis])],
                       up = upper_neighbour_[axis][as_index(now[axis])];
    along[axis] = {{down, now[axis], up}, 3};
    if (now[axis] == was[axis]) continue;
    ++moves;
    if (was[axis] == down) along[axis] = {{up}, 1};  // only the layer ahead is new
    if (was[axis] == up) along[axis] = {{down}, 1};
  }
  if (moves != 1) return near(cell, out);
  const auto& [x, y, z] = along;
  int n = 0;
  for (int k = 0; k < z.count; ++k)
    for (int j = 0; j < y.count; ++j)
      for (int i = 0; i < x.count; ++i) {
        const std::int32_t column = x.at[as_index(i)], row = y.at[as_index(j)],
                           layer = z.at[as_index(k)];
        const bool outside = (column | row | layer) < 0;
        n = copy(outside ? 0 : cell_index(column, row, layer), out, n);
      }
  return n;
}

void Cells::within(const Vec3& low, const Vec3& high, std::vector<std::int32_t>& out) const {
  /// First index and number of cells; a periodic grid wraps around.
  const auto range = [&](double from, double to, double inverse_side, std::int32_t n) {
    const double first = std::floor(from * inverse_side), last = std::floor(to * inverse_side);
    if (!periodic_) {
      const auto a = static_cast<std::int32_t>(std::clamp(first, 0.0, n - 1.0));
      const auto b = static_cast<std::int32_t>(std::clamp(last, 0.0, n - 1.0));
      return std::array{a, b - a + 1};
    }
    if (last - first + 1 >= n) return std::array{0, n};
    const auto a = static_cast<std::int32_t>(first - n * std::floor(first / n));
    return std::array{std::min(a, n - 1), static_cast<std::int32_t>(last - first) + 1};
  };
  const Vec3 from = low - low_, to = high - low_;
  const auto [x, xs] = range(from.x, to.x, per_side_.x, counts_[0]);
  const auto [y, ys] = range(from.y, to.y, per_side_.y, counts_[1]);
  const auto [z, zs] = range(from.z, to.z, per_side_.z, counts_[2]);
  for (std::int32_t k = z; k < z + zs; ++k)
    for (std::int32_t j = y; j < y + ys; ++j)
      for (std::int32_t i = x; i < x + xs; ++i) {
        const std::int32_t where = cell_index(i % counts_[0], j % counts_[1], k % counts_[2]);
        const auto first = slots_.begin() + where * capacity_;
        out.insert(out.end(), first, first + filled_[as_index(where)]);
      }
}

void Cells::serialize(Archive& archive) {
  archive(capacity_)(filled_)(slots_);
  if (!archive.reading()) return;
  const auto places = static_cast<std::size_t>(count()) + 1;
  const auto fits = [&](std::int32_t n) { return n >= 0 && n <= capacity_; };
  if (capacity_ < 4 || filled_.size() != places ||
      slots_.size() != places * static_cast<std::size_t>(capacity_) + 4 || filled_[0] != 0 ||
      !std::ranges::all_of(filled_, fits))
    throw Archive::broken();
}

bool Cells::contains(std::int32_t ball, Cell cell) const {
  const auto [x, y, z] = split(cell);
  if (cell < 0 || x >= counts_[0] || y >= counts_[1] || z >= counts_[2]) return false;
  const auto first = slots_.begin() + std::int64_t{cell_index(cell)} * capacity_;
  return std::count(first, first + filled_[as_index(cell_index(cell))], ball) == 1;
}

std::int64_t Cells::ball_count() const {
  return std::accumulate(filled_.begin(), filled_.end(), std::int64_t{0});
}

Cells::Borders Cells::borders(Cell cell) const {
  const auto [x, y, z] = split(cell);
  const auto least = [&](std::int32_t i, double low, double side) {
    return !periodic_ && i == 0 ? -unbounded : low + i * side - slack_;
  };
  const auto most = [&](std::int32_t i, std::int32_t n, double low, double side) {
    return !periodic_ && i == n - 1 ? unbounded : low + (i + 1) * side + slack_;
  };
  return {{least(x, low_.x, side_.x), least(y, low_.y, side_.y), least(z, low_.z, side_.z)},
          {most(x, counts_[0], low_.x, side_.x), most(y, counts_[1], low_.y, side_.y),
           most(z, counts_[2], low_.z, side_.z)}};
}

}  // namespace mahlwerk::event
