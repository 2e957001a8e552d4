// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <tuple>

#include "mahlwerk/base/index.hpp"
#include "mahlwerk/event/many_balls.hpp"
#include "mahlwerk/geometry/safe_time.hpp"

// Cells and neighbour lists of the balls: how long they hold, and their renewal.
namespace mahlwerk::event {

/// Time for which all balls that a ball can touch are certainly among its candidates [s].
double ManyBalls::neighbourhood_safe_time(std::int32_t ball, const BallState& where) const {
  return lists_ != nullptr ? lists_->safe_time(ball, where.position, where.velocity)
                           : cell_safe_time(ball, where);
}

/// Time for which a ball certainly stays in its cell [s].
double ManyBalls::cell_safe_time(std::int32_t ball, const BallState& where) const {
  const Cells::Borders b =
      grid_->borders(level(ball), predictions_[static_cast<std::size_t>(ball)].cell);
  const Vec3 &v = where.velocity, &a = max_acceleration_.components;
  Vec3 x = where.position;
  // A ball may be beyond a periodic border and still belong to its cell; its position is folded, so
  // use the image nearest to the cell.
  if (periodic_) {
    const Vec3 middle = 0.5 * (b.low + b.high);
    x = middle + nearest_image(x - middle, periods_);
  }
  const auto along = [](double low, double high, double place, double speed,
                        double max_acceleration) {
    double ahead = high - place, behind = place - low;
    if (speed < 0) std::swap(ahead, behind);
    speed = std::abs(speed);
    if (max_acceleration == 0) return speed > 0 ? std::max(ahead, 0.0) / speed : never;
    const double to =
        ahead < never ? geometry::plane_safe_time(ahead, speed, max_acceleration) : never;
    if (behind >= ahead) return to;  // not reached before the border ahead
    return std::min(to, geometry::plane_safe_time(behind, -speed, max_acceleration));
  };
  return std::min({along(b.low.x, b.high.x, x.x, v.x, a.x), along(b.low.y, b.high.y, x.y, v.y, a.y),
                   along(b.low.z, b.high.z, x.z, v.z, a.z)});
}

bool ManyBalls::has_left(std::int32_t ball, const BallState& where) const {
  if (lists_ != nullptr) return lists_->has_left(ball, where.position);
  const Cell cell = predictions_[static_cast<std::size_t>(ball)].cell;
  return grid_->cell_at(level(ball), where.position) != cell;
}

void ManyBalls::renew_neighbourhood(std::int32_t ball, const BallState& where) {
  if (lists_ == nullptr) return change_cell(ball, where);
  renew_list(ball, where.position);
  predict_collisions_with(ball, lists_->of(ball));
}

/// Gives a ball a new sphere and a new neighbour list. The grid holds the centres of the spheres.
void ManyBalls::renew_list(std::int32_t ball, const Vec3& position) {
  Prediction& p = prediction_of(ball);
  if (const Cell cell = grid_->cell_at(level(ball), position); cell != p.cell) {
    grid_->remove(level(ball), ball, p.cell);
    grid_->insert(level(ball), ball, cell);
    p.cell = cell;
  }
  lists_->renew(ball, position, grid_->near(level(ball), p.cell));
}

void ManyBalls::change_cell(std::int32_t ball, const BallState& where) {
  Prediction& p = prediction_of(ball);
  const Cell before = p.cell, cell = grid_->cell_at(level(ball), where.position);
  grid_->remove(level(ball), ball, before);
  grid_->insert(level(ball), ball, cell);
  p.cell = cell;
  // In a box of few cells, balls that stay near may collide as another image from now on.
  predict_collisions_with(ball, grid_->needs_all_images()
                                    ? grid_->near(level(ball), cell)
                                    : grid_->newly_near(level(ball), cell, before));
}

/// Sorts the balls in memory by cell.
void ManyBalls::sort() {
  const auto count = trajectories_.size();
  if (count < 512) return;
  std::vector<std::int32_t> order(count), place(count);
  std::vector<std::tuple<int, Cell, std::int32_t>> keys(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto ball = static_cast<std::int32_t>(i);
    keys[i] = {level(ball), prediction_of(ball).cell, ball};
  }
  std::ranges::sort(keys);
  std::ranges::transform(keys, order.begin(), [](const auto& key) { return std::get<2>(key); });
  for (std::size_t i = 0; i < count; ++i) place[as_index(order[i])] = static_cast<std::int32_t>(i);
  const auto permute = [&](auto& list) {
    std::remove_reference_t<decltype(list)> sorted;
    sorted.reserve(count);
    for (const std::int32_t i : order) sorted.push_back(list[as_index(i)]);
    list = std::move(sorted);
  };
  permute(trajectories_);
  permute(predictions_);
  permute(collision_data_);
  if (lists_ != nullptr) lists_->renumber(place);
  grid_->clear();
  for (std::int32_t ball = 0; ball < std::ssize(trajectories_); ++ball) {
    Prediction& p = prediction_of(ball);
    if (p.partner >= 0) p.partner = place[as_index(p.partner)];
    grid_->insert(level(ball), ball, p.cell);
  }
}

void ManyBalls::make_neighbourhoods() {
  grid_->clear();
  for (std::int32_t ball = 0; ball < std::ssize(trajectories_); ++ball) {
    const Vec3 position = ball_state(ball).position;
    prediction_of(ball).cell = grid_->cell_at(level(ball), position);
    grid_->insert(level(ball), ball, prediction_of(ball).cell);
    if (lists_ != nullptr) lists_->place(ball, trajectory(ball).species, position);
  }
  if (lists_ == nullptr) return;
  for (std::int32_t ball = 0; ball < std::ssize(trajectories_); ++ball)
    renew_list(ball, lists_->centre(ball));
}

}  // namespace mahlwerk::event
