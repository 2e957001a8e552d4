// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/settings.hpp"

// What the rest of the program knows of devices (soft/device/). A page has its own file for it.
namespace mahlwerk::soft {

/// The first graphics card of this machine, by the driver library that the environment variable
/// MAHLWERK_CUDA_DRIVER names, else libcuda.so.1. Throws InputError where there is none, or it is
/// too old.
std::shared_ptr<Device> graphics_card();
/// Its name and free memory [bytes]. Throws as graphics_card().
struct CardInfo {
  std::string name;
  double free_memory = 0;
};
CardInfo graphics_card_info();
/// Memory of a card for each ball of a dense charge [bytes] (docs/performance.md).
constexpr double card_memory_per_ball = 4000;

/// What of a run kernels do not compute, in words; empty if they compute all.
std::string device_lacks(const Settings& settings);

/// The soft engine on Settings::device.
std::unique_ptr<scene::Engine> make_device_engine(const scene::Chamber& chamber,
                                                  const std::vector<scene::Ball>& balls,
                                                  const Settings& settings,
                                                  const contact::PairTable& pairs, double start);

}  // namespace mahlwerk::soft
