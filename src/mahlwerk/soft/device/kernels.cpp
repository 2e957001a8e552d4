// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/kernels.hpp"

#include <algorithm>
#include <cstring>
#include <variant>

#include "mahlwerk/geometry/shapes.hpp"
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
#define MAHLWERK_KERNEL_VALUE(NAME, FUNCTION) .NAME = {"common", #NAME, FUNCTION},
  static const CommonKernels all{MAHLWERK_COMMON_KERNELS(MAHLWERK_KERNEL_VALUE)};
#undef MAHLWERK_KERNEL_VALUE
  return all;
}

}  // namespace mahlwerk::soft
