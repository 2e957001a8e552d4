// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engines_impl.hpp"
#include "mahlwerk/geometry/periodic_box.hpp"

namespace mahlwerk::event {

template std::unique_ptr<const MovingWall> moving_wall_of(const geometry::PeriodicBox&,
                                                          const scene::Chamber&);

}  // namespace mahlwerk::event
