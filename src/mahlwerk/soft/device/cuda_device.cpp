// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/soft/device/cuda_driver.hpp"
#include "mahlwerk/soft/device/device.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::soft {
namespace {

InputError no_device_code(const std::string& what, const char* why) {
  return InputError(Fault{"run.device",
                          fmt::format("the code for graphics cards {}: {}", why, what),
                          "build it: ./mahlwerk device (it needs clang)", "no-device-code"});
}

/// The text of a module of device code, made for the arrays of this program.
std::string module_text(const std::string& module) {
  const std::string file = module + ".ptx";
  std::filesystem::path folder;
  try {
    folder = data_folder("device");
  } catch (const InputError&) {
    throw no_device_code(file, "is not here");
  }
  std::ifstream in(folder / file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in || text.empty()) throw no_device_code((folder / file).string(), "cannot be read");
  const std::string layout = fmt::format("mahlwerk_layout = {};", sizeof(DeviceArrays));
  if (text.find(layout) == std::string::npos)
    throw no_device_code((folder / file).string(), "is damaged or that of another version");
  return text;
}

/// An opened card, with the modules that runs have asked for. All runs of the process share it.
class Card {
 public:
  explicit Card(const std::string& library) : driver(open_cuda_driver(library)) {
    int device = 0;
    check(driver.cuDeviceGet(&device, 0), "choose the first card");
    char text[256] = {};
    check(driver.cuDeviceGetName(text, sizeof text - 1, device), "read its name");
    name = text;
    int major = 0, minor = 0;
    check(driver.cuDeviceGetAttribute(&major, cuda_major_version, device), "read its version");
    check(driver.cuDeviceGetAttribute(&minor, cuda_minor_version, device), "read its version");
    if (major < 8)
      throw InputError(Fault{
          "run.device",
          fmt::format("the graphics card {} has compute capability {}.{}", name, major, minor),
          "use a card of 8.0 (Ampere) or later, or write device = \"cpu\"", "old-graphics-card"});
    check(driver.cuDevicePrimaryCtxRetain(&context, device), "open it");
  }

  /// Every thread that calls the driver needs the context.
  void use() const { check(driver.cuCtxSetCurrent(context), "use it"); }
  void check(CudaStatus status, const char* what) const {
    if (status == 0) return;
    const char* words = nullptr;
    driver.cuGetErrorString(status, &words);
    throw DeviceError(fmt::format("the graphics card {} failed ({}): {}", name, what,
                                  words != nullptr ? words : fmt::format("error {}", status)));
  }
  CudaFunction* function(const Kernel& kernel) {
    const std::lock_guard lock(mutex_);
    CudaFunction*& found = functions_[kernel.name];
    if (found != nullptr) return found;
    CudaModule*& module = modules_[kernel.module];
    if (module == nullptr)
      check(driver.cuModuleLoadData(&module, module_text(kernel.module).c_str()),
            ("compile " + kernel.module).c_str());
    check(driver.cuModuleGetFunction(&found, module, kernel.name.c_str()), kernel.name.c_str());
    return found;
  }

  CudaDriver driver;
  std::string name = "0";
  CudaContext* context = nullptr;

 private:
  std::mutex mutex_;
  std::map<std::string, CudaFunction*> functions_;
  std::map<std::string, CudaModule*> modules_;
};

class CudaDevice final : public Device {
 public:
  explicit CudaDevice(Card& card) : card_(card), arrays_(allocate(sizeof(DeviceArrays))) {}
  ~CudaDevice() override { release(arrays_); }
  CudaDevice(const CudaDevice&) = delete;
  CudaDevice& operator=(const CudaDevice&) = delete;

  std::string name() const override { return card_.name; }
  std::size_t free_bytes() const override {
    card_.use();
    std::size_t free = 0, total = 0;
    card_.check(card_.driver.cuMemGetInfo_v2(&free, &total), "ask for its memory");
    return free;
  }
  void* allocate(std::size_t bytes) override {
    card_.use();
    CudaPointer memory = 0;
    const CudaStatus status = card_.driver.cuMemAlloc_v2(&memory, std::max<std::size_t>(bytes, 1));
    if (status == cuda_out_of_memory)
      throw DeviceError(
          fmt::format("the memory of the graphics card {} is full: {} MB more are "
                      "needed, {} MB are free. Use fewer balls, or device = \"cpu\"",
                      card_.name, bytes / 1000000 + 1, free_bytes() / 1000000));
    card_.check(status, "reserve memory");
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the driver's addresses are numbers
    return reinterpret_cast<void*>(memory);
  }
  void release(void* memory) noexcept override {
    card_.driver.cuCtxSetCurrent(card_.context);
    card_.driver.cuMemFree_v2(address(memory));
  }
  void write(void* to, const void* from, std::size_t bytes) override {
    card_.use();
    if (bytes > 0) card_.check(card_.driver.cuMemcpyHtoD_v2(address(to), from, bytes), "write");
  }
  void read(void* to, const void* from, std::size_t bytes) override {
    card_.use();
    card_.check(card_.driver.cuCtxSynchronize(), "compute");
    if (bytes > 0) card_.check(card_.driver.cuMemcpyDtoH_v2(to, address(from), bytes), "read");
  }
  void zero(void* to, std::size_t bytes) override {
    card_.use();
    if (bytes > 0) card_.check(card_.driver.cuMemsetD8_v2(address(to), 0, bytes), "clear memory");
  }
  void run(const Kernel& kernel, const DeviceArrays& arrays, std::int64_t count) override {
    if (count == 0) return;
    card_.use();
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): other padding costs a copy, no more
    if (std::memcmp(&arrays, &last_arrays_, sizeof arrays) != 0) {
      write(arrays_, &arrays, sizeof arrays);
      std::memcpy(&last_arrays_, &arrays, sizeof arrays);
    }
    constexpr unsigned block = 128;  // contacts take some 200 registers a thread
    const auto blocks = static_cast<unsigned>((count + block - 1) / block);
    CudaPointer at = address(arrays_);
    void* parameters[] = {&at, &count};
    card_.check(card_.driver.cuLaunchKernel(card_.function(kernel), blocks, 1, 1, block, 1, 1, 0,
                                            nullptr, parameters, nullptr),
                kernel.name.c_str());
  }

 private:
  static CudaPointer address(const void* memory) { return reinterpret_cast<CudaPointer>(memory); }

  Card& card_;
  void* arrays_;  // on the card
  DeviceArrays last_arrays_;
};

/// The card, opened at the first call.
Card& opened_card() {
  static std::mutex mutex;
  static std::map<std::string, std::unique_ptr<Card>> cards;
  const char* said = std::getenv("MAHLWERK_CUDA_DRIVER");
  const bool named = said != nullptr && *said != 0;
  const std::string library = named ? said : "libcuda.so.1";
  const std::lock_guard lock(mutex);
  std::unique_ptr<Card>& card = cards[library];
  if (!card) {
    auto opened = std::make_unique<Card>(library);
    module_text("common");  // a case is refused before it runs
    card = std::move(opened);
  }
  return *card;
}

}  // namespace

std::shared_ptr<Device> graphics_card() {
  return std::make_shared<CudaDevice>(opened_card());
}

std::string graphics_card_name() {
  return opened_card().name;
}

}  // namespace mahlwerk::soft
