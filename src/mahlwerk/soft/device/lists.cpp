// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/device/solver.hpp"
#include "mahlwerk/soft/diagnostics.hpp"

// Lists of pairs: balls are sorted into cells, and contacts move with them.
namespace mahlwerk::soft {
namespace {

constexpr double most_cells_per_ball = 8;

}  // namespace

/// Builds the lists for a step, at its positions.
void DeviceSolver::rebuild_lists(std::int64_t step) {
  if (arrays_.list.touch != nullptr) {
    collect_sums();
    tune_skin(step - reference_step_);
  }
  control_.write({Control{.step = step}});
  const auto check = [&](const char* why) {
    const std::int32_t bad = control_.read(1).front().bad_ball;
    if (bad != Control::no_ball) stop(static_cast<std::size_t>(bad), why);
  };
  const Corners all = corners();
  check(not_finite_message);
  set_grids(all);
  sort_into_cells();
  find_pairs();
  check(outside_message);
  find_incoming();
  reference_step_ = step;
  lists_due_ = false;
}

/// A list should last some tens of steps: shorter lived ones cost their building, longer lived ones
/// the tests of pairs that do not touch.
void DeviceSolver::tune_skin(std::int64_t lasted) {
  constexpr std::int64_t few_steps = 16, many_steps = 48;
  if (lasted < few_steps) arrays_.skin = std::min(1.15 * arrays_.skin, 0.8 * smallest_radius_);
  if (lasted > many_steps) arrays_.skin = std::max(arrays_.skin / 1.15, 0.02 * smallest_radius_);
}

Corners DeviceSolver::corners() const {
  const std::vector<Corners> all = partial_sums<Corners>(common_kernels().find_corners, arrays_);
  Corners c = all.front();
  for (const Corners& more : all) {
    c.low = {std::min(c.low.x, more.low.x), std::min(c.low.y, more.low.y),
             std::min(c.low.z, more.low.z)};
    c.high = {std::max(c.high.x, more.high.x), std::max(c.high.y, more.high.y),
              std::max(c.high.z, more.high.z)};
  }
  return c;
}

/// Cells for each size class, wider where there would be many more than balls.
void DeviceSolver::set_grids(const Corners& c) {
  const Vec3 periods = jar_->periods();
  const double low[3] = {c.low.x, c.low.y, c.low.z}, high[3] = {c.high.x, c.high.y, c.high.z},
               period[3] = {periods.x, periods.y, periods.z};
  std::int32_t first = 0;
  for (int k = 0; k < arrays_.classes; ++k) {
    CellGrid& g = arrays_.grid[k];
    double size = 2 * arrays_.class_radius[k] + arrays_.skin + arrays_.pull_off_distance;
    double* const origin[3] = {&g.low.x, &g.low.y, &g.low.z};
    double* const inverse[3] = {&g.inverse_size.x, &g.inverse_size.y, &g.inverse_size.z};
    for (;; size *= 1.26) {
      double cells = 1;
      for (int axis = 0; axis < 3; ++axis) {
        g.wrapped[axis] = std::isfinite(period[axis]);
        const double length = g.wrapped[axis] ? period[axis] : high[axis] - low[axis];
        const double count = std::clamp(std::floor(length / size), 1.0, 1e9);
        g.count[axis] = static_cast<std::int32_t>(count);
        *origin[axis] = g.wrapped[axis] ? -0.5 * length : low[axis];
        *inverse[axis] = length > 0 ? count / length : 0;
        cells *= count;
      }
      if (cells <= most_cells_per_ball * arrays_.balls + 64) break;
    }
    g.first = first;
    first += g.cells();
  }
}

/// Sorts the balls by their cells, and each cell by the ids of its balls.
void DeviceSolver::sort_into_cells() {
  const CommonKernels& kernels = common_kernels();
  const CellGrid& last = arrays_.grid[arrays_.classes - 1];
  const std::int32_t cells = last.first + last.cells();
  const auto count = static_cast<std::size_t>(cells);
  arrays_.cell_first = cell_first_.zeroed(count + 1);
  run(kernels.count_cells, arrays_.balls);
  scan(arrays_.cell_first, cells);
  arrays_.cursor = cursor_.zeroed(std::max(count, static_cast<std::size_t>(arrays_.balls)));
  run(kernels.fill_cells, arrays_.balls);
  run(kernels.sort_cell, cells);
  run(kernels.sort_balls, arrays_.balls);
  std::swap(balls_, sorted_);
  std::swap(arrays_.now, arrays_.sorted);
}

/// Replaces each of the numbers by the sum of those before it, and writes the sum of all behind.
void DeviceSolver::scan(std::int32_t* numbers, std::int32_t count) {
  const CommonKernels& kernels = common_kernels();
  arrays_.scanned = numbers, arrays_.scan_count = count;
  run(kernels.sum_segment, arrays_.partials);
  run(kernels.scan_segments, 1);
  run(kernels.scan_segment, arrays_.partials);
}

std::int32_t DeviceSolver::last_of(const std::int32_t* numbers, std::int32_t count) const {
  std::int32_t sum = 0;
  device_->read(&sum, numbers + count, sizeof sum);
  return sum;
}

/// Lists the pairs within the skin. Contacts of the old list keep their history.
void DeviceSolver::find_pairs() {
  std::swap(list_, old_list_);
  arrays_.old_list = arrays_.list;
  ContactList& list = arrays_.list = {};
  const auto balls = static_cast<std::size_t>(arrays_.balls);
  list.pair_first = list_->pair_first.reserve(balls + 1);
  list.wall_first = list_->wall_first.reserve(balls + 1);
  run(common_kernels().count_pairs, arrays_.balls);
  scan(list.pair_first, arrays_.balls);
  run(shape_.count_walls, arrays_.balls);
  scan(list.wall_first, arrays_.balls);
  list.pairs = last_of(list.pair_first, arrays_.balls);
  list.walls = last_of(list.wall_first, arrays_.balls);
  reserve_pairs(list.size());
  run(common_kernels().fill_pairs, arrays_.balls);
  run(shape_.fill_walls, arrays_.balls);
}

/// Memory for the listed pairs, and for what they may hand over before the host takes it.
void DeviceSolver::reserve_pairs(std::int32_t size) {
  ContactList& list = arrays_.list;
  const auto count = static_cast<std::size_t>(size);
  list.i = list_->i.reserve(count), list.j = list_->j.reserve(count);
  list.touch = list_->touch.reserve(count + 1);  // never null
  list.state = list_->state.reserve(count);
  if (has_history_) list.optional = list_->optional.reserve(count);
  if (has_friction_history_) list.friction = list_->friction.reserve(count);
  const auto walls = static_cast<std::size_t>(list.walls);
  list.normals = list_->normals.reserve(walls);
  arrays_.wall_points = wall_points_.reserve(walls);
  arrays_.forces = forces_.reserve(count);
  arrays_.sums = sums_.reserve(count);
  arrays_.incoming = incoming_.reserve(static_cast<std::size_t>(list.pairs));
  const std::size_t room = count + count / 4 + 1024;
  arrays_.ended = ended_.reserve(room);
  arrays_.most_ended = static_cast<std::int64_t>(room);
}

void DeviceSolver::find_incoming() {
  const CommonKernels& kernels = common_kernels();
  const auto balls = static_cast<std::size_t>(arrays_.balls);
  arrays_.incoming_first = incoming_first_.zeroed(balls + 1);
  run(kernels.count_incoming, arrays_.list.pairs);
  scan(arrays_.incoming_first, arrays_.balls);
  arrays_.cursor = cursor_.zeroed(balls);
  run(kernels.fill_incoming, arrays_.list.pairs);
  run(kernels.sort_incoming, arrays_.balls);
}

/// Throws InputError if balls of the start overlap by more than the limit: a large overlap would
/// eject them at high speed. Sums the energy of those that overlap less.
void DeviceSolver::check_start() {
  const HostBalls all = read_balls();
  const auto size = static_cast<std::size_t>(arrays_.list.size());
  const std::vector<std::int32_t> i = list_->i.read(size), j = list_->j.read(size);
  const WallAxes axes = jar_->axes(mill_time(0));
  for (std::size_t p = 0; p < size; ++p) {
    const auto row = static_cast<std::size_t>(i[p]), other = static_cast<std::size_t>(j[p]);
    const bool wall = p >= static_cast<std::size_t>(arrays_.list.pairs);
    const BallRecord& ball = all.rows[row];
    const std::int32_t of = all.species[row];
    double depth = ball.radius, smaller = ball.radius;
    if (wall) {
      depth -= jar_->gap(j[p], ball.position(), axes, ball.radius).distance;
    } else {
      Vec3 apart = all.rows[other].position() - ball.position();
      if (arrays_.constants.periodic) apart = nearest_image(apart, jar_->periods());
      smaller = std::min(ball.radius, all.rows[other].radius);
      depth += all.rows[other].radius - norm(apart);
    }
    if (depth > settings_.max_initial_overlap * smaller)
      throw overlap_error(static_cast<std::size_t>(all.id[row]),
                          wall ? "the jar" : fmt::format("ball {}", all.id[other] + 1),
                          depth / smaller, wall ? "its radius" : "the smaller radius");
    const std::int32_t pair =
        wall ? pairs_.wall_pair_index(of, j[p]) : pairs_.ball_pair_index(of, all.species[other]);
    const Species* partner = wall ? nullptr : &pairs_.species(all.species[other]);
    if (depth > 0)
      start_energy_ += soft::energy_at_start(
          pair_parameters(pairs_[pair], pairs_.species(of), partner, settings_), depth,
          *settings_.model.law);
  }
}

}  // namespace mahlwerk::soft
