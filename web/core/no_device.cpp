// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A page computes with the processor alone (soft/on_device.hpp).
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/soft/on_device.hpp"

namespace mahlwerk::soft {

class Device {};

std::shared_ptr<Device> graphics_card() {
  throw InputError(Fault{"run.device", "a page cannot use the graphics card",
                         "write device = \"cpu\", or run the case with the program",
                         "no-graphics-card"});
}
std::string graphics_card_name() {
  graphics_card();
  return {};
}
double free_card_memory() {
  graphics_card();
  return 0;
}
double card_memory_per_ball(const Settings&) {
  return 0;
}
std::string device_lacks(const scene::Chamber&, const Settings&) {
  return {};
}
std::unique_ptr<scene::Engine> make_device_engine(const scene::Chamber&,
                                                  const std::vector<scene::Ball>&, const Settings&,
                                                  const contact::PairTable&, double) {
  graphics_card();
  return nullptr;
}

}  // namespace mahlwerk::soft
