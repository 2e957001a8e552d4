// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/kernels.hpp"

#include <algorithm>
#include <cstring>
#include <variant>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/soft/device/ball_kernels.hpp"
#include "mahlwerk/soft/device/device_shape.hpp"
#include "mahlwerk/soft/device/wall_kernels.hpp"

namespace mahlwerk::soft {

Kernel kernel_of(std::string_view of, const char* name, decltype(Kernel::call) call) {
  std::string module(of);
  std::ranges::replace(module, '-', '_');
  return {module, name + ('_' + module), call};
}

ShapeKernels shape_kernels(const geometry::AnyShape& shape) {
  return std::visit(
      []<class S>(const S&) {
        using D = DeviceShape<S>;
        return ShapeKernels{kernel_of(S::name, "find_wall_point", find_wall_point<D>),
                            kernel_of(S::name, "count_walls", count_walls<D>),
                            kernel_of(S::name, "fill_walls", fill_walls<D>)};
      },
      shape);
}

std::vector<unsigned char> shape_for_kernels(const geometry::AnyShape& shape,
                                             const Upload& upload) {
  const auto copy = [&]<class T>(const std::vector<T>& all) {
    return static_cast<const T*>(upload(all.data(), all.size() * sizeof(T)));
  };
  std::vector<unsigned char> bytes;
  std::visit(
      [&](const auto& own) {
        const auto flat = device_shape(own, copy);
        bytes.resize(sizeof flat);
        std::memcpy(bytes.data(), &flat, sizeof flat);
      },
      shape);
  return bytes;
}

const CommonKernels& common_kernels() {
  static const auto kernel = [](const char* name, auto* call) {
    return Kernel{"common", name, call};
  };
  static const CommonKernels all{.move_ball = kernel("move_ball", move_ball),
                                 .end_step = kernel("end_step", end_step),
                                 .sum_balls = kernel("sum_balls", sum_balls),
                                 .sum_work = kernel("sum_work", sum_work<false>),
                                 .collect_work = kernel("collect_work", sum_work<true>),
                                 .find_corners = kernel("find_corners", find_corners),
                                 .count_cells = kernel("count_cells", count_cells),
                                 .fill_cells = kernel("fill_cells", fill_cells),
                                 .sort_cell = kernel("sort_cell", sort_cell),
                                 .sort_balls = kernel("sort_balls", sort_balls),
                                 .sum_segment = kernel("sum_segment", sum_segment),
                                 .scan_segments = kernel("scan_segments", scan_segments),
                                 .scan_segment = kernel("scan_segment", scan_segment),
                                 .count_pairs = kernel("count_pairs", count_pairs),
                                 .fill_pairs = kernel("fill_pairs", fill_pairs),
                                 .count_incoming = kernel("count_incoming", count_incoming),
                                 .fill_incoming = kernel("fill_incoming", fill_incoming),
                                 .sort_incoming = kernel("sort_incoming", sort_incoming)};
  return all;
}

}  // namespace mahlwerk::soft
