// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::event {

/// The Zeno guard's message: at `time` [s] since the start events piled up within `within` [s].
RunError pile_up(double time, double within);
/// The same for many balls, `events` of which took place.
RunError pile_up_of_many(double time, double within, std::int64_t events);

}  // namespace mahlwerk::event
