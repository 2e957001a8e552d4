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
/// Its name; its free memory [bytes]. Both throw as graphics_card().
std::string graphics_card_name();
double free_card_memory();
/// What of a run kernels do not compute, in words; empty if they compute all.
std::string device_lacks(const scene::Chamber& chamber, const Settings& settings);

/// Memory of a card for each ball of a dense charge [bytes] (docs/performance.md): more where
/// contacts have more history, or reach across gaps.
double card_memory_per_ball(const Settings& settings);

/// The soft engine on Settings::device.
std::unique_ptr<scene::Engine> make_device_engine(const scene::Chamber& chamber,
                                                  const std::vector<scene::Ball>& balls,
                                                  const Settings& settings,
                                                  const contact::PairTable& pairs, double start);

}  // namespace mahlwerk::soft
