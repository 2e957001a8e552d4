// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/soft/diagnostics.hpp"
#include "mahlwerk/soft/few/solver.hpp"

// Neighbour list with a skin: pairs that can touch before a ball has moved half the skin have a
// lane of a packet. Other pairs are not tested until the list is rebuilt.
namespace mahlwerk::soft {
namespace {

constexpr std::size_t all_pairs_limit = 8;  // up to this many balls, all pairs are tested

}  // namespace

bool FewBodySolver::rebuild_neighbour_list(std::size_t) {
  rebuild_neighbour_list();
  return true;
}

void FewBodySolver::rebuild_neighbour_list() {
  find_pairs();
  if (lanes_due()) update_lanes();
  update_slacks();
}

/// Finds all pairs whose gap is within the skin. Stops the run if the state of a ball is invalid.
void FewBodySolver::find_pairs() {
  for (std::size_t b = 0; b < particles_.balls.size(); ++b)
    particles_.balls[b].list_position = particles_.bodies[b].position;
  particles_.list_step = particles_.step;
  particles_.wall_points_due = true;
  found_pairs_.clear();
  if (particles_.count <= all_pairs_limit) {
    for (std::size_t b = 0; b < particles_.count; ++b) {
      find_wall_pairs(b);
      for (std::size_t other = b + 1; other < particles_.count; ++other) test_pair(b, other);
    }
    return;
  }
  find_ball_pairs();
  for (std::size_t b = 0; b < particles_.count; ++b) find_wall_pairs(b);
  std::ranges::sort(found_pairs_);
}

/// Of the pairs to faces: how far the ball must move before it can touch.
void FewBodySolver::update_slacks() {
  if (jar_->max_wall_speed() > 0) return;  // the wall itself moves towards the balls
  for (WallNeighbour& n : particles_.wall_neighbours)
    n.slack = gaps_[static_cast<std::size_t>(n.ball * jar_->faces() + n.face)] - pull_off_distance_;
}

/// Finds the faces near a ball.
void FewBodySolver::find_wall_pairs(std::size_t b) {
  const Vec3 x = particles_.position(b);
  if (!std::isfinite(squared(x)) || !std::isfinite(squared(particles_.velocity(b))))
    stop(b, not_finite_message);
  const auto faces = static_cast<std::size_t>(jar_->faces());
  const std::span<double> gaps(gaps_.data() + b * faces, faces);
  const double radius = initial_balls_[b].radius;
  jar_->distances(x, jar_->axes(mill_time(particles_.step)), radius + skin_ + pull_off_distance_,
                  gaps);
  for (int face = 0; face < jar_->faces(); ++face) {
    const double gap = gaps[static_cast<std::size_t>(face)] -= radius;
    if (gap > skin_ + pull_off_distance_ || !jar_->can_touch(face, radius)) continue;
    if (!(gap > -radius)) stop(b, outside_message);
    found_pairs_.push_back({static_cast<std::int32_t>(b), -1, face});
  }
}

/// Adds the pair i < j to the found pairs if its gap is within the skin.
void FewBodySolver::test_pair(std::size_t i, std::size_t j) {
  const Vec3 separation = nearest(particles_.position(j) - particles_.position(i));
  const double far =
      initial_balls_[i].radius + initial_balls_[j].radius + skin_ + pull_off_distance_;
  if (squared(separation) < far * far)
    found_pairs_.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), -1});
}

/// Sort and sweep: balls are sorted by x, and only pairs whose intervals in x are near are tested.
/// If the box is periodic along x, all pairs are tested.
void FewBodySolver::find_ball_pairs() {
  const bool periodic = std::isfinite(jar_->periods().x);
  double largest = 0;
  for (const Species& s : pairs_.all_species()) largest = std::max(largest, s.radius);
  std::vector<std::int32_t> order(particles_.count);
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> x;
  for (std::size_t b = 0; b < particles_.count; ++b) x.push_back(particles_.position(b).x);
  std::ranges::sort(
      order, [&](std::int32_t a, std::int32_t b) { return x[a] != x[b] ? x[a] < x[b] : a < b; });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      if (!periodic && x[order[b]] - x[order[a]] > 2 * largest + skin_ + pull_off_distance_) break;
      test_pair(static_cast<std::size_t>(std::min(order[a], order[b])),
                static_cast<std::size_t>(std::max(order[a], order[b])));
    }
}

}  // namespace mahlwerk::soft
