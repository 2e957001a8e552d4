// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::observe {

/// Gap over the ball's diameter below which a body supports a ball of the bed.
constexpr double support_gap = 0.1;

/// [kg] Mass of the balls outside the bed (obs.18): those with fewer than three bodies within
/// support_gap, and not at the jar's side. `own` turns the jar's own axes into those of the balls'
/// positions. A mesh counts as the cylinder of `radius` [m] about the jar's axis.
double mass_outside_bed(const std::vector<scene::Ball>& balls, const geometry::AnyShape& jar,
                        const Rotation& own, double radius);

}  // namespace mahlwerk::observe
