// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::results {

/// The nip of each kind of pair, for balls of their mean size. A face with varying curvature has
/// its mean effective radius, weighted by the power of hits (cap.3, cap.4). The radius is 0 for
/// pairs with powder grains, which capture nothing.
std::vector<powder::Nip> nips(const cases::Case& mill_case,
                              const observe::CollisionStatistics& tally);

/// [m] Effective radius of a ball of `radius` [m] on a face of the jar, likewise; face -1: all.
double effective_radius(const geometry::AnyShape& shape, int face, double radius,
                        const observe::WallMap& hits);

}  // namespace mahlwerk::results
