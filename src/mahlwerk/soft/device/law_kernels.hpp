// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/device/contact_kernels.hpp"
#include "mahlwerk/soft/device/kernels.hpp"

namespace mahlwerk::soft {

template <class Law>
LawKernels law_kernels() {
  return {kernel_of(Law::name, "compute_contact", compute_contact<Law>),
          kernel_of(Law::name, "sum_contacts", sum_contacts<Law>),
          kernel_of(Law::name, "begin_counting", begin_counting<Law>)};
}

}  // namespace mahlwerk::soft
