// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/cuda_driver.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::soft {
namespace {

InputError no_card(const std::string& why) {
  return InputError(Fault{"run.device", "no graphics card can be used: " + why,
                          "use a machine with an NVIDIA card and its driver, or write device = "
                          "\"cpu\"",
                          "no-graphics-card"});
}

template <class Function>
void find(void* library, const std::string& path, const char* name, Function*& function) {
  function = reinterpret_cast<Function*>(dlsym(library, name));
  if (function == nullptr)
    throw no_card(fmt::format("the driver library {} has no function {}", path, name));
}

}  // namespace

CudaDriver open_cuda_driver(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw no_card(fmt::format("there is no driver library {}", path));
  CudaDriver driver;
#define MAHLWERK_CUDA_FIND(NAME, PARAMETERS) find(library, path, #NAME, driver.NAME);
  MAHLWERK_CUDA_FUNCTIONS(MAHLWERK_CUDA_FIND)
#undef MAHLWERK_CUDA_FIND
  const auto fail = [&](CudaStatus status) {
    const char* words = nullptr;
    driver.cuGetErrorString(status, &words);
    throw no_card(words != nullptr ? words : fmt::format("error {} of the driver", status));
  };
  if (const CudaStatus status = driver.cuInit(0); status != 0) fail(status);
  int cards = 0;
  if (const CudaStatus status = driver.cuDeviceGetCount(&cards); status != 0) fail(status);
  if (cards == 0) throw no_card("the driver finds none");
  return driver;
}

}  // namespace mahlwerk::soft
