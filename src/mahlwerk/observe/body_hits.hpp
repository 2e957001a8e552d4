// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/observe/collision_batch.hpp"
#include "mahlwerk/observe/histogram.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// The hits that bodies get on their faces, edges, ... (bod.16). A collision of two bodies is a hit
/// of each of them. Memory is allocated at the first one.
class BodyHits {
 public:
  /// Adds record `c`, which is the i-th of `batch`.
  void add(const scene::Collision& c, const CollisionBatch& batch, std::size_t i) {
    for (const scene::BodyFeature at : {c.feature, c.other_feature})
      if (at != scene::BodyFeature::none) add(at, batch.energy_normal[i], batch.bin_normal[i]);
  }
  /// [J] Normal energies of the hits; of no feature `none`.
  const LogHistogram& energies(scene::BodyFeature feature) const;
  std::int64_t count() const;  ///< of all hits
  double energy() const;       ///< [J] the sum over all hits; each has all of its collision

  void merge(const BodyHits& other);
  void pack();    ///< nothing is added from then on
  void let_go();  ///< the hits are forgotten
  void serialize(Archive& archive);

 private:
  void add(scene::BodyFeature feature, double energy, std::int64_t bin);
  std::vector<LogHistogram> by_feature_;  // of body_features; none before the first hit
};

}  // namespace mahlwerk::observe
