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

/// Energies of collisions in the order of time, in fixed memory: 8 MB. When it is full every second
/// is dropped, and from then on one of twice as many is kept.
class StressStream {
 public:
  enum class Energy { normal, contact_point, lost };
  static constexpr std::size_t most = std::size_t{1} << 20U;
  struct Hit {
    float energy = 0;       ///< [J]
    std::int32_t pair = 0;  ///< as StatisticsByPair numbers them
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
