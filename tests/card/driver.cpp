// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A driver library of a graphics card that is none: memory is the host's, filled with garbage, and
// a launch calls the kernels of the same names on the host, the last index first. It checks what it
// is given: addresses, sizes, grids, contexts, and that the device code has the kernel. Environment
// variables: MAHLWERK_CARD_FAILS="NAME N" lets the N-th call of a function fail, "NAME N+" that and
// all later ones of any function, MAHLWERK_CARD_MEMORY limits the memory [bytes], MAHLWERK_CARDS
// their number (1).
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <list>
#include <map>
#include <mutex>
#include <string>

#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/soft/device/cuda_driver.hpp"
#include "mahlwerk/soft/device/kernels.hpp"

namespace mahlwerk::soft {

struct CudaContext {};
struct CudaModule {
  std::string text;
};
struct CudaFunction {
  Kernel kernel;
};

namespace {

constexpr CudaStatus invalid_value = 1, not_found = 500, launch_failed = 719;

std::mutex mutex;
std::map<CudaPointer, std::size_t> allocations;
std::size_t used = 0;
std::map<std::string, int> calls;
bool broken = false;  // all calls fail from now on
CudaContext the_context;
std::list<CudaModule> modules;
std::list<CudaFunction> functions;
thread_local CudaContext* current = nullptr;

CudaStatus refuse(const char* what) {
  std::fprintf(stderr, "card: %s\n", what);
  return invalid_value;
}

/// Counts the calls since the environment has named one that is to fail; whether this is it.
bool fails(const char* name) {
  const std::lock_guard lock(mutex);
  static std::string last;
  const char* said = std::getenv("MAHLWERK_CARD_FAILS");
  if (const std::string now = said != nullptr ? said : ""; now != last)
    last = now, calls.clear(), broken = false;
  const int count = ++calls[name];
  if (said == nullptr) return false;
  if (broken) return true;
  char which[64] = {}, more = 0;
  int number = 0;
  const int words = std::sscanf(said, "%63s %d%c", which, &number, &more);
  const bool now = words >= 2 && std::strcmp(which, name) == 0 && number == count;
  if (now && more == '+') broken = true;
  return now;
}

std::size_t memory() {
  const char* said = std::getenv("MAHLWERK_CARD_MEMORY");
  return said != nullptr ? std::strtoull(said, nullptr, 10) : std::size_t{8} << 30;
}

/// Whether the range is within an allocation.
bool allocated(CudaPointer from, std::size_t bytes) {
  const std::lock_guard lock(mutex);
  auto at = allocations.upper_bound(from);
  if (at == allocations.begin()) return false;
  --at;
  return from + bytes <= at->first + at->second;
}

template <class... Laws>
void add_laws(std::map<std::string, Kernel>& all, const std::variant<Laws...>*) {
  const auto add = [&](const LawKernels& k) {
    for (const Kernel& one : {k.compute_contact, k.sum_contacts, k.begin_counting})
      all[one.name] = one;
  };
  (add(law_kernels<Laws>()), ...);
}
template <class... Shapes>
void add_shapes(std::map<std::string, Kernel>& all, const std::variant<Shapes...>*) {
  const auto add = [&](const ShapeKernels& k) {
    for (const Kernel& one : {k.find_wall_point, k.count_walls, k.fill_walls}) all[one.name] = one;
  };
  (add(shape_kernels(geometry::AnyShape(Shapes{}))), ...);
}
const std::map<std::string, Kernel>& kernels() {
  static const auto all = [] {
    std::map<std::string, Kernel> found;
    add_laws(found, static_cast<contact::AnyLaw::Models*>(nullptr));
    add_shapes(found, static_cast<geometry::AnyShape::Models*>(nullptr));
    const CommonKernels& c = common_kernels();
#define MAHLWERK_CARD_KERNEL(NAME, FUNCTION) found[c.NAME.name] = c.NAME;
    MAHLWERK_COMMON_KERNELS(MAHLWERK_CARD_KERNEL)
#undef MAHLWERK_CARD_KERNEL
    return found;
  }();
  return all;
}

}  // namespace
}  // namespace mahlwerk::soft

using namespace mahlwerk::soft;  // NOLINT: the functions below are those of the driver

#pragma GCC visibility push(default)
extern "C" {

CudaStatus cuInit(unsigned flags) {
  if (fails("cuInit")) return 100;
  return flags == 0 ? 0 : refuse("flags of cuInit");
}
CudaStatus cuDeviceGetCount(int* count) {
  const char* said = std::getenv("MAHLWERK_CARDS");
  *count = said != nullptr ? std::atoi(said) : 1;
  return 0;
}
CudaStatus cuDeviceGet(int* device, int number) {
  *device = number;
  return number == 0 ? 0 : refuse("number of the card");
}
CudaStatus cuDeviceGetName(char* name, int size, int) {
  std::snprintf(name, static_cast<std::size_t>(size), "Pretended Card");
  return 0;
}
CudaStatus cuDeviceGetAttribute(int* value, int attribute, int) {
  const char* said = std::getenv("MAHLWERK_CARD_VERSION");
  *value = attribute == cuda_major_version ? (said != nullptr ? std::atoi(said) : 9) : 0;
  return 0;
}
CudaStatus cuDevicePrimaryCtxRetain(CudaContext** context, int) {
  *context = &the_context;
  return 0;
}
CudaStatus cuCtxSetCurrent(CudaContext* context) {
  if (fails("cuCtxSetCurrent")) return launch_failed;
  current = context;
  return context == &the_context ? 0 : refuse("context");
}
CudaStatus cuMemGetInfo_v2(std::size_t* free, std::size_t* total) {
  const std::lock_guard lock(mutex);
  *total = memory(), *free = memory() > used ? memory() - used : 0;
  return 0;
}
CudaStatus cuMemAlloc_v2(CudaPointer* at, std::size_t bytes) {
  if (fails("cuMemAlloc_v2")) return cuda_out_of_memory;
  if (current == nullptr || bytes == 0) return refuse("allocation");
  const std::lock_guard lock(mutex);
  if (used + bytes > memory()) return cuda_out_of_memory;
  void* found = std::aligned_alloc(256, (bytes + 255) / 256 * 256);
  std::memset(found, 0xab, bytes);
  *at = reinterpret_cast<CudaPointer>(found);
  allocations[*at] = bytes;
  used += bytes;
  return 0;
}
CudaStatus cuMemFree_v2(CudaPointer at) {
  const std::lock_guard lock(mutex);
  const auto found = allocations.find(at);
  if (found == allocations.end()) return refuse("address to free");
  used -= found->second;
  allocations.erase(found);
  std::free(reinterpret_cast<void*>(at));
  return 0;
}
CudaStatus cuMemcpyHtoD_v2(CudaPointer to, const void* from, std::size_t bytes) {
  if (fails("cuMemcpyHtoD_v2")) return launch_failed;
  if (current == nullptr || !allocated(to, bytes)) return refuse("target of a copy");
  std::memcpy(reinterpret_cast<void*>(to), from, bytes);
  return 0;
}
CudaStatus cuMemcpyDtoH_v2(void* to, CudaPointer from, std::size_t bytes) {
  if (fails("cuMemcpyDtoH_v2")) return launch_failed;
  if (current == nullptr || !allocated(from, bytes)) return refuse("source of a copy");
  std::memcpy(to, reinterpret_cast<const void*>(from), bytes);
  return 0;
}
CudaStatus cuMemsetD8_v2(CudaPointer to, unsigned char value, std::size_t bytes) {
  if (!allocated(to, bytes)) return refuse("memory to clear");
  std::memset(reinterpret_cast<void*>(to), value, bytes);
  return 0;
}
CudaStatus cuModuleLoadData(CudaModule** module, const void* image) {
  if (fails("cuModuleLoadData")) return 218;
  const std::lock_guard lock(mutex);
  *module = &modules.emplace_back(CudaModule{static_cast<const char*>(image)});
  return (*module)->text.find(".target sm_80") != std::string::npos ? 0 : refuse("device code");
}
CudaStatus cuModuleGetFunction(CudaFunction** function, CudaModule* module, const char* name) {
  const auto found = kernels().find(name);
  if (found == kernels().end()) return not_found;
  if (module->text.find(".entry " + found->first + "(") == std::string::npos) return not_found;
  const std::lock_guard lock(mutex);
  *function = &functions.emplace_back(CudaFunction{found->second});
  return 0;
}
CudaStatus cuLaunchKernel(CudaFunction* function, unsigned grid_x, unsigned grid_y, unsigned grid_z,
                          unsigned block_x, unsigned block_y, unsigned block_z, unsigned shared,
                          CudaStream* stream, void** parameters, void** extra) {
  if (fails("cuLaunchKernel")) return launch_failed;
  const auto at = *static_cast<const CudaPointer*>(parameters[0]);
  const auto count = *static_cast<const std::int64_t*>(parameters[1]);
  const bool flat = grid_y == 1 && grid_z == 1 && block_y == 1 && block_z == 1;
  const std::int64_t threads = std::int64_t{grid_x} * block_x;
  if (current == nullptr || !flat || shared != 0 || stream != nullptr || extra != nullptr ||
      block_x == 0 || block_x > 1024 || threads < count || threads - count >= block_x ||
      !allocated(at, sizeof(DeviceArrays)))
    return refuse("launch");
  const auto& arrays = *reinterpret_cast<const DeviceArrays*>(at);
  for (std::int64_t k = count; k-- > 0;) function->kernel.call(arrays, k);
  return 0;
}
CudaStatus cuCtxSynchronize() {
  return fails("cuCtxSynchronize") ? launch_failed : 0;
}
CudaStatus cuGetErrorString(CudaStatus status, const char** words) {
  *words = status == launch_failed        ? "unspecified launch failure"
           : status == cuda_out_of_memory ? "out of memory"
           : status == not_found          ? "named symbol not found"
                                          : nullptr;
  return 0;
}

}  // extern "C"
#pragma GCC visibility pop
