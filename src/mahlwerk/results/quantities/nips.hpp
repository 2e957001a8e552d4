// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::results {

/// Where powder is caught between each kind of pair of a tally, balls of their mean size. A face
/// whose curvature is not the same everywhere counts as its mean, by where it is hit hardest
/// (cap.3, cap.4). A radius of 0 where nothing is: pairs with grains of the powder.
std::vector<powder::Nip> nips(const cases::Case& what, const observe::CollisionStatistics& tally);

/// [m] The effective radius of a ball of that `radius` [m] and a face of the jar, likewise.
double effective_radius(const geometry::AnyShape& shape, int face, double radius,
                        const observe::WallMap& hits);

}  // namespace mahlwerk::results
