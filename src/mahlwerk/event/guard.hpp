// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::event {

/// The Zeno guard's message: at `time` [s] since the start events piled up within `within` [s].
RunError pile_up(double time, double within);

}  // namespace mahlwerk::event
