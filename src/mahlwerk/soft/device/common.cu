// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/device_code.cuh"
#pragma clang force_cuda_host_device begin
#include "mahlwerk/soft/device/ball_kernels.hpp"
#include "mahlwerk/soft/device/list_kernels.hpp"
#pragma clang force_cuda_host_device end

namespace soft = mahlwerk::soft;
MAHLWERK_LAYOUT
MAHLWERK_KERNEL(move_ball, soft::move_ball)
MAHLWERK_KERNEL(end_step, soft::end_step)
MAHLWERK_KERNEL(sum_balls, soft::sum_balls)
MAHLWERK_KERNEL(sum_work, soft::sum_work<false>)
MAHLWERK_KERNEL(collect_work, soft::sum_work<true>)
MAHLWERK_KERNEL(find_corners, soft::find_corners)
MAHLWERK_KERNEL(count_cells, soft::count_cells)
MAHLWERK_KERNEL(fill_cells, soft::fill_cells)
MAHLWERK_KERNEL(sort_cell, soft::sort_cell)
MAHLWERK_KERNEL(sort_balls, soft::sort_balls)
MAHLWERK_KERNEL(sum_segment, soft::sum_segment)
MAHLWERK_KERNEL(scan_segments, soft::scan_segments)
MAHLWERK_KERNEL(scan_segment, soft::scan_segment)
MAHLWERK_KERNEL(count_pairs, soft::count_pairs)
MAHLWERK_KERNEL(fill_pairs, soft::fill_pairs)
MAHLWERK_KERNEL(count_incoming, soft::count_incoming)
MAHLWERK_KERNEL(fill_incoming, soft::fill_incoming)
MAHLWERK_KERNEL(sort_incoming, soft::sort_incoming)
