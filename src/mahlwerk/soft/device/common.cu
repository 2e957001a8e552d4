// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/device/device_code.cuh"
#pragma clang force_cuda_host_device begin
#include "mahlwerk/soft/device/common_kernels.hpp"
#pragma clang force_cuda_host_device end

namespace soft = mahlwerk::soft;
MAHLWERK_LAYOUT
MAHLWERK_COMMON_KERNELS(MAHLWERK_KERNEL)
