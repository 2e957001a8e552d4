// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "mahlwerk/soft/device/device.hpp"

namespace mahlwerk::soft {

/// The first graphics card of this machine, by the driver library that the environment variable
/// MAHLWERK_CUDA_DRIVER names, else libcuda.so.1. Throws InputError where there is none, or it is
/// too old.
std::unique_ptr<Device> graphics_card();

}  // namespace mahlwerk::soft
