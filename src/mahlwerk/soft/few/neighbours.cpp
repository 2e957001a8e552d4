// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mahlwerk/soft/few/solver.hpp"

// Who is near whom: pairs that may touch before a ball has moved half a skin sit in the lanes of
// packets; all others are left alone until then.
namespace mahlwerk::soft {
namespace {

constexpr std::size_t few = 8;  // balls all of whose pairs are tested

}  // namespace

void FewBodySolver::rebuild_neighbour_list() {
  for (std::size_t b = 0; b < particles_.blocks; ++b)
    particles_.list_positions.put(b, particles_.position.at(b));
  list_step_ = particles_.step;
  particles_.wall_points_due = true;
  wanted_.clear();
  if (particles_.balls <= few) {
    for (std::size_t b = 0; b < particles_.balls; ++b) {
      near_walls(b);
      for (std::size_t other = b + 1; other < particles_.balls; ++other) near_ball(b, other);
    }
  } else {
    near_balls();
    for (std::size_t b = 0; b < particles_.balls; ++b) near_walls(b);
    std::ranges::sort(wanted_);
  }
  const bool same = wanted_ == listed_;
  if (!same) {
    listed_ = wanted_;
    fill_lanes(wanted_);
  }
  if (touching_first() || !same) {
    find_wall_points();
    find_owners();
  }
  if (jar_->sweep() > 0) return;  // the wall comes by itself
  for (WallNeighbour& n : particles_.near)
    n.slack = gaps_[static_cast<std::size_t>(n.ball * jar_->faces() + n.face)] - reach_;
}

/// Finds a ball that has gone wrong, too.
void FewBodySolver::near_walls(std::size_t b) {
  const Vec3 x = particles_.position.one(b);
  if (!std::isfinite(squared(x)) || !std::isfinite(squared(particles_.velocity.one(b))))
    stop(b, "its place or speed is no number");
  const auto faces = static_cast<std::size_t>(jar_->faces());
  const std::span<double> gaps(gaps_.data() + b * faces, faces);
  const double radius = made_of_[b].radius;
  jar_->distances(x, clock(particles_.step), radius + skin_ + reach_, gaps);
  for (int face = 0; face < jar_->faces(); ++face) {
    const double gap = gaps[static_cast<std::size_t>(face)] -= radius;
    if (gap > skin_ + reach_ || !jar_->meets(face, radius)) continue;
    if (!(gap > -radius)) stop(b, "it is outside the jar");
    wanted_.push_back({static_cast<std::int32_t>(b), -1, face});
  }
}

/// i < j.
void FewBodySolver::near_ball(std::size_t i, std::size_t j) {
  const Vec3 apart = nearest(particles_.position.one(j) - particles_.position.one(i));
  const double far = made_of_[i].radius + made_of_[j].radius + skin_ + reach_;
  if (squared(apart) < far * far)
    wanted_.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), -1});
}

/// All pairs along a line: sorted by x, only those whose intervals of x are near are tested. Where
/// the box repeats along x, every pair is.
void FewBodySolver::near_balls() {
  const bool repeats = std::isfinite(jar_->periods().x);
  double largest = 0;
  for (const Species& s : pairs_.all_species()) largest = std::max(largest, s.radius);
  std::vector<std::int32_t> order(particles_.balls);
  std::iota(order.begin(), order.end(), 0);
  const double* x = numbers(particles_.position.x);
  std::ranges::sort(
      order, [&](std::int32_t a, std::int32_t b) { return x[a] != x[b] ? x[a] < x[b] : a < b; });
  for (std::size_t a = 0; a < order.size(); ++a)
    for (std::size_t b = a + 1; b < order.size(); ++b) {
      if (!repeats && x[order[b]] - x[order[a]] > 2 * largest + skin_ + reach_) break;
      near_ball(static_cast<std::size_t>(std::min(order[a], order[b])),
                static_cast<std::size_t>(std::max(order[a], order[b])));
    }
}

}  // namespace mahlwerk::soft
