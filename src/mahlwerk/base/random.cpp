// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/random.hpp"

#include <Random123/philox.h>

#include <numbers>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk {

double Random::uniform() {
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32U)}};
  const r123::Philox4x32::ctr_type counter = {
      {static_cast<std::uint32_t>(drawn_), static_cast<std::uint32_t>(drawn_ >> 32U), stream_, 0U}};
  ++drawn_;
  const auto block = r123::Philox4x32{}(counter, key);
  const std::uint64_t bits = (static_cast<std::uint64_t>(block[1]) << 32U) | block[0];
  return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
}

Vec3 Random::direction() {
  const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi);
  const double r = std::sqrt(1 - z * z);
  return {r * math::cos(angle), r * math::sin(angle), z};
}

}  // namespace mahlwerk
