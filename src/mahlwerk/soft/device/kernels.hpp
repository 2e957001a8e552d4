// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/soft/device/common_kernels.hpp"
#include "mahlwerk/soft/device/device.hpp"

// The kernels by their names. kernels.cu.in compiles the same functions for graphics cards, a
// module for each law, each shape, and what all share.
namespace mahlwerk::soft {

/// A kernel of the law or shape `of`, whose module is named after it, with underscores.
Kernel kernel_of(std::string_view of, const char* name, decltype(Kernel::call) call);

/// Kernels that know the contact law.
struct LawKernels {
  Kernel compute_contact, sum_contacts, begin_counting;
};
/// Those of a law (contact_kernels.hpp), compiled for the host with its loops.
template <class Law>
LawKernels law_kernels();

/// Kernels that know the shape of the jar (wall_kernels.hpp).
struct ShapeKernels {
  Kernel find_wall_point, count_walls, fill_walls;
};
ShapeKernels shape_kernels(const geometry::AnyShape& shape);

/// Copies bytes to the memory of a device, for a whole run; returns their address there.
using Upload = std::function<const void*(const void* from, std::size_t bytes)>;
/// The shape as its kernels read it, with its arrays where `upload` has put them.
std::vector<unsigned char> shape_for_kernels(const geometry::AnyShape& shape, const Upload& upload);

/// Kernels that know neither.
struct CommonKernels {
#define MAHLWERK_KERNEL_MEMBER(NAME, FUNCTION) Kernel NAME;
  MAHLWERK_COMMON_KERNELS(MAHLWERK_KERNEL_MEMBER)
#undef MAHLWERK_KERNEL_MEMBER
};
const CommonKernels& common_kernels();

}  // namespace mahlwerk::soft
