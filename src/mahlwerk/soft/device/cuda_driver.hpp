// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

// The part of the CUDA driver interface that Mahlwerk calls, of the library that a driver installs.
// It is opened at run time: the program needs neither CUDA's headers nor its libraries.
namespace mahlwerk::soft {

/// Names of the interface: a status, 0 for success, and handles.
using CudaStatus = int;
using CudaPointer = unsigned long long;
struct CudaContext;
struct CudaModule;
struct CudaFunction;
struct CudaStream;

constexpr CudaStatus cuda_out_of_memory = 2;
/// Attributes of a device.
constexpr int cuda_major_version = 75, cuda_minor_version = 76;

/// Calls X(name, parameters) for each function.
#define MAHLWERK_CUDA_FUNCTIONS(X)                                                              \
  X(cuInit, (unsigned))                                                                         \
  X(cuDeviceGetCount, (int*))                                                                   \
  X(cuDeviceGet, (int*, int))                                                                   \
  X(cuDeviceGetName, (char*, int, int))                                                         \
  X(cuDeviceGetAttribute, (int*, int, int))                                                     \
  X(cuDevicePrimaryCtxRetain, (CudaContext**, int))                                             \
  X(cuCtxSetCurrent, (CudaContext*))                                                            \
  X(cuMemGetInfo_v2, (std::size_t*, std::size_t*))                                              \
  X(cuMemAlloc_v2, (CudaPointer*, std::size_t))                                                 \
  X(cuMemFree_v2, (CudaPointer))                                                                \
  X(cuMemcpyHtoD_v2, (CudaPointer, const void*, std::size_t))                                   \
  X(cuMemcpyDtoH_v2, (void*, CudaPointer, std::size_t))                                         \
  X(cuMemsetD8_v2, (CudaPointer, unsigned char, std::size_t))                                   \
  X(cuModuleLoadData, (CudaModule**, const void*))                                              \
  X(cuModuleGetFunction, (CudaFunction**, CudaModule*, const char*))                            \
  X(cuLaunchKernel, (CudaFunction*, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, \
                     unsigned, CudaStream*, void**, void**))                                    \
  X(cuCtxSynchronize, ())                                                                       \
  X(cuGetErrorString, (CudaStatus, const char**))

/// The functions of an opened driver library, which stays open.
struct CudaDriver {
// NOLINTNEXTLINE(bugprone-macro-parentheses): a declaration
#define MAHLWERK_CUDA_MEMBER(NAME, PARAMETERS) CudaStatus(*NAME) PARAMETERS = nullptr;
  MAHLWERK_CUDA_FUNCTIONS(MAHLWERK_CUDA_MEMBER)
#undef MAHLWERK_CUDA_MEMBER
};

/// Opens a driver library. Throws InputError where there is none, or it lacks a function.
CudaDriver open_cuda_driver(const std::string& library);

}  // namespace mahlwerk::soft
