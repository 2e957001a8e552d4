// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Makes the project's own headers device code, compiled by clang alone (cmake/device_code.cmake):
// standard headers first, as host code; then everything is for both sides. No header of CUDA is
// read. Functions of the standard library that kernels call are replaced by instructions.
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))

#include <stdlib.h>  // first: the wrappers of clang name malloc and free

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace std {
static inline __device__ double sqrt(double a) { return __nvvm_sqrt_rn_d(a); }
static inline __device__ double copysign(double a, double b) { return __builtin_copysign(a, b); }
// Ends of the range of our elementary functions. Powers of 0 occur; the others do not.
static inline __device__ double pow(double x, double y) {
  return x == 0 && y > 0 ? 0 : __builtin_nan("");
}
static inline __device__ double ldexp(double, int) { return __builtin_nan(""); }
static inline __device__ double sin(double) { return __builtin_nan(""); }
static inline __device__ double cos(double) { return __builtin_nan(""); }
static inline __device__ double atan2(double, double) { return __builtin_nan(""); }
}  // namespace std

/// The text of a module tells for which arrays it was made: "mahlwerk_layout = 1408;".
#define MAHLWERK_LAYOUT \
  extern "C" __device__ int mahlwerk_layout = sizeof(mahlwerk::soft::DeviceArrays);

/// A kernel, which calls FUNCTION(arrays, index).
#define MAHLWERK_KERNEL(NAME, FUNCTION)                                                        \
  extern "C" __global__ void NAME(const mahlwerk::soft::DeviceArrays* arrays,                  \
                                  std::int64_t count) {                                        \
    const std::int64_t index =                                                                 \
        std::int64_t{__nvvm_read_ptx_sreg_ctaid_x()} * __nvvm_read_ptx_sreg_ntid_x() +         \
        __nvvm_read_ptx_sreg_tid_x();                                                          \
    if (index < count) FUNCTION(*arrays, index);                                                \
  }
