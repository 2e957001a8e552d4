// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/observe/pair_statistics.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// Energies of collisions in order of time, in fixed memory of 8 MB. When the memory is full, every
/// second record is dropped, and the stride between kept collisions doubles.
class StressStream {
 public:
  enum class Energy { normal, contact_point, lost };
  static constexpr std::size_t most = std::size_t{1} << 20U;
  struct Hit {
    float energy = 0;       ///< [J]
    std::int32_t pair = 0;  ///< index of the pair in StatisticsByPair
  };

  void collisions(std::span<const scene::Collision> finished, const StatisticsByPair& pairs,
                  Energy energy);
  const std::vector<Hit>& hits() const { return hits_; }
  std::int64_t stride() const { return stride_; }  ///< collisions that a hit stands for
  void serialize(Archive& archive) { archive(hits_)(stride_)(received_); }

 private:
  std::vector<Hit> hits_;
  std::int64_t stride_ = 1, received_ = 0;
};

}  // namespace mahlwerk::observe
