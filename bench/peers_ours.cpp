// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "peers.hpp"

namespace mahlwerk::bench {

std::optional<Ours> our_speed(const Start& /*start*/, int /*steps*/) {
  return std::nullopt;
}

std::optional<Physics> our_physics(const Start& /*start*/) {
  return std::nullopt;
}

}  // namespace mahlwerk::bench
