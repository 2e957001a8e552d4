// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/few/particle_data.hpp"

// Operations on all columns of a lane of a packet.
namespace mahlwerk::soft {

/// Frees a lane. Both bodies become ball 0 with radii 0, which never touch.
void clear_lane(PairPacket& p, std::size_t lane);
void copy_lane(const PairPacket& from, std::size_t lane, PairPacket& to, std::size_t other_lane);
void swap_lanes(PairPacket& a, std::size_t lane, PairPacket& b, std::size_t other_lane);

}  // namespace mahlwerk::soft
