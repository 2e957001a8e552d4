// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/device/ball_kernels.hpp"
#include "mahlwerk/soft/device/list_kernels.hpp"

namespace mahlwerk::soft {

/// Calls X(name, function) for each kernel that knows neither law nor shape.
#define MAHLWERK_COMMON_KERNELS(X)        \
  X(move_ball, soft::move_ball)           \
  X(end_step, soft::end_step)             \
  X(sum_balls, soft::sum_balls)           \
  X(sum_work, soft::sum_work<false>)      \
  X(collect_work, soft::sum_work<true>)   \
  X(find_corners, soft::find_corners)     \
  X(count_cells, soft::count_cells)       \
  X(fill_cells, soft::fill_cells)         \
  X(sort_cell, soft::sort_cell)           \
  X(sort_balls, soft::sort_balls)         \
  X(sum_segment, soft::sum_segment)       \
  X(scan_segments, soft::scan_segments)   \
  X(scan_segment, soft::scan_segment)     \
  X(count_pairs, soft::count_pairs)       \
  X(fill_pairs, soft::fill_pairs)         \
  X(count_incoming, soft::count_incoming) \
  X(fill_incoming, soft::fill_incoming)   \
  X(sort_incoming, soft::sort_incoming)

}  // namespace mahlwerk::soft
