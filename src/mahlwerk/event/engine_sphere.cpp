// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/engines_impl.hpp"
#include "mahlwerk/geometry/sphere.hpp"

namespace mahlwerk::event {

template std::unique_ptr<scene::Engine> one_ball_in(const geometry::Sphere&, const scene::Chamber&,
                                                    const scene::Ball&, const Rules&, double);
template std::unique_ptr<const MovingWall> moving_wall_of(const geometry::Sphere&,
                                                          const scene::Chamber&);

}  // namespace mahlwerk::event
