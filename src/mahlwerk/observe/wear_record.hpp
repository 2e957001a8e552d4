// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/observe/wall_map.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::observe {

/// A body whose shape follows its wear: a range of the faces that balls hit, and the cells of its
/// surface, which are sides of a section or vertices of a mesh.
struct WornBody {
  int first_face = 0, end_face = 0;  ///< among the faces of jar and parts
  std::size_t cells = 0;
  std::function<std::size_t(const Vec3& where)> cell_of;  ///< of a point [m] in the body's own axes
};

/// [1] Load times distance over tangential loss (wea.3) of a kind of ball on a face.
struct LoadFactors {
  std::vector<int> kind_of_ball;
  std::vector<std::vector<double>> of_kind;  ///< by kind, then face
  double of(int ball, int face) const {
    const auto kind = static_cast<std::size_t>(kind_of_ball[static_cast<std::size_t>(ball)]);
    return of_kind[kind][static_cast<std::size_t>(face)];
  }
};

/// What hits have done to each cell of the worn bodies, in fixed memory. Sums are those of one
/// replicate.
struct WearSums {
  std::vector<std::vector<WallSums>> of_body;
};

class WearRecord final : public scene::Observer {
 public:
  WearRecord(std::shared_ptr<const std::vector<WornBody>> bodies,
             std::shared_ptr<const LoadFactors> factors, std::shared_ptr<WearSums> sums);
  void collisions(std::span<const scene::Collision> finished) override;

 private:
  std::shared_ptr<const std::vector<WornBody>> bodies_;
  std::shared_ptr<const LoadFactors> factors_;
  std::shared_ptr<WearSums> sums_;
};

}  // namespace mahlwerk::observe
