// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mahlwerk::event {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::size_t at(std::int32_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

Cells::Cells(const Vec3& low, const Vec3& size, bool periodic, double side, double slack,
             double most)
    : low_(low), slack_(slack), periodic_(periodic) {
  const double room = size.x * size.y * size.z;
  side = std::max(side, std::cbrt(room / std::max(most, 1.0)));
  const auto count = [&](double width) {
    return static_cast<std::int32_t>(std::clamp(std::floor(width / side), 1.0, 1000.0));
  };
  counts_ = {count(size.x), count(size.y), count(size.z)};
  side_ = {size.x / counts_[0], size.y / counts_[1], size.z / counts_[2]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t n = counts_[axis];
    for (std::int32_t i = 0; i < n; ++i) {
      const bool round = periodic && n > 1;
      before_[axis].push_back(i > 0 ? i - 1 : round && n > 2 ? n - 1 : -1);
      after_[axis].push_back(i < n - 1 ? i + 1 : round && n > 2 ? 0 : -1);
    }
  }
  filled_.assign(at(this->count() + 1), 0);
  slots_.assign(at((this->count() + 1) * capacity_ + 4), -1);
}

std::int32_t Cells::cell_at(const Vec3& place) const {
  const Vec3 p = place - low_;
  const auto index = [](double x, double side, std::int32_t n) {
    return static_cast<std::int32_t>(std::clamp(std::floor(x / side), 0.0, n - 1.0));
  };
  return (index(p.z, side_.z, counts_[2]) * counts_[1] + index(p.y, side_.y, counts_[1])) *
             counts_[0] +
         index(p.x, side_.x, counts_[0]);
}

std::array<std::int32_t, 3> Cells::split(std::int32_t cell) const {
  const std::int32_t row = cell / counts_[0];
  return {cell % counts_[0], row % counts_[1], row / counts_[1]};
}

void Cells::clear() {
  std::fill(filled_.begin(), filled_.end(), 0);
}

void Cells::insert(std::int32_t ball, std::int32_t cell) {
  std::int32_t& n = filled_[at(cell + 1)];
  if (n == capacity_) grow();
  slots_[at((cell + 1) * capacity_ + n)] = ball;
  ++n;
}

void Cells::remove(std::int32_t ball, std::int32_t cell) {
  std::int32_t* const first = &slots_[at((cell + 1) * capacity_)];
  std::int32_t& n = filled_[at(cell + 1)];
  std::int32_t* const place = std::find(first, first + n, ball);
  *place = first[--n];
}

void Cells::grow() {
  std::vector<std::int32_t> roomy(at((count() + 1) * 2 * capacity_ + 4), -1);
  for (std::int32_t cell = 0; cell <= count(); ++cell)
    std::copy_n(&slots_[at(cell * capacity_)], filled_[at(cell)], &roomy[at(cell * 2 * capacity_)]);
  slots_ = std::move(roomy);
  capacity_ *= 2;
}

int Cells::copy(std::int32_t cell, std::int32_t* out, int n) const {
  const std::int32_t* const from = &slots_[at(cell * capacity_)];
  const std::int32_t many = filled_[at(cell)];
  std::copy_n(from, 4, out + n);  // without asking how many: four places are one move
  for (std::int32_t i = 4; i < many; ++i) out[n + i] = from[i];
  return n + many;
}

int Cells::near(std::int32_t cell, std::int32_t* out) const {
  const auto [x, y, z] = split(cell);
  const std::array<std::int32_t, 3> xs{before_[0][at(x)], x, after_[0][at(x)]};
  int n = 0;
  for (const std::int32_t layer : {before_[2][at(z)], z, after_[2][at(z)]}) {
    if (layer < 0) continue;
    for (const std::int32_t row : {before_[1][at(y)], y, after_[1][at(y)]}) {
      if (row < 0) continue;
      const std::int32_t base = (layer * counts_[1] + row) * counts_[0] + 1;
      for (const std::int32_t column : xs)
        n = copy(column < 0 ? nowhere : base + column, out, n);
    }
  }
  return n;
}

int Cells::newly_near(std::int32_t cell, std::int32_t before, std::int32_t* out) const {
  const auto now = split(cell), was = split(before);
  std::array<std::array<std::int32_t, 3>, 3> along{};
  int moved = -1, moves = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along[axis] = {before_[axis][at(now[axis])], now[axis], after_[axis][at(now[axis])]};
    if (now[axis] == was[axis]) continue;
    moved = static_cast<int>(axis);
    ++moves;
  }
  if (moves != 1) return near(cell, out);
  auto& across = along[static_cast<std::size_t>(moved)];
  const std::int32_t from = was[static_cast<std::size_t>(moved)];
  if (across[0] == from)
    across = {across[2], -1, -1};  // only the layer ahead is new
  else if (across[2] == from)
    across = {across[0], -1, -1};
  int n = 0;
  for (const std::int32_t layer : along[2])
    for (const std::int32_t row : along[1])
      for (const std::int32_t column : along[0])
        if (layer >= 0 && row >= 0 && column >= 0)
          n = copy((layer * counts_[1] + row) * counts_[0] + column + 1, out, n);
  return n;
}

Cells::Borders Cells::borders(std::int32_t cell) const {
  const auto [x, y, z] = split(cell);
  const auto least = [&](std::int32_t i, std::int32_t n, double low, double side) {
    return n == 1 || (!periodic_ && i == 0) ? -unbounded : low + i * side - slack_;
  };
  const auto most = [&](std::int32_t i, std::int32_t n, double low, double side) {
    return n == 1 || (!periodic_ && i == n - 1) ? unbounded : low + (i + 1) * side + slack_;
  };
  return {{least(x, counts_[0], low_.x, side_.x), least(y, counts_[1], low_.y, side_.y),
           least(z, counts_[2], low_.z, side_.z)},
          {most(x, counts_[0], low_.x, side_.x), most(y, counts_[1], low_.y, side_.y),
           most(z, counts_[2], low_.z, side_.z)}};
}

}  // namespace mahlwerk::event
