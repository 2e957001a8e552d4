// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/wear_record.hpp"

#include <utility>

#include "mahlwerk/powder/wear.hpp"

namespace mahlwerk::observe {

WearRecord::WearRecord(std::shared_ptr<const std::vector<WornBody>> bodies,
                       std::shared_ptr<const LoadFactors> factors, std::shared_ptr<WearSums> sums)
    : bodies_(std::move(bodies)), factors_(std::move(factors)), sums_(std::move(sums)) {
  sums_->of_body.clear();
  for (const WornBody& body : *bodies_) sums_->of_body.emplace_back(body.cells);
}

void WearRecord::collisions(std::span<const scene::Collision> finished) {
  for (const scene::Collision& c : finished) {
    if (c.other >= 0) continue;
    const int face = ~c.other;
    for (std::size_t b = 0; b < bodies_->size(); ++b) {
      const WornBody& body = (*bodies_)[b];
      if (face < body.first_face || face >= body.end_face) continue;
      WallSums hit{.count = 1, .energy_normal = c.energy_normal(), .lost = c.lost()};
      hit.load_distance = factors_->of(c.ball, face) * c.lost_tangential;
      hit.erosion = c.mass * (c.approach * c.approach + c.slip * c.slip) *
                    powder::finnie(c.approach, c.slip);  // (wea.4)
      WallSums::add_to(sums_->of_body[b][body.cell_of(c.where)], hit);
    }
  }
}

}  // namespace mahlwerk::observe
