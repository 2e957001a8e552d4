// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/walls/moving_wall_of.hpp"

namespace mahlwerk::soft {

template std::unique_ptr<const MovingWall> moving_wall(const geometry::Attritor&,
                                                       const scene::Chamber&);

}  // namespace mahlwerk::soft
