// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/walls/moving_wall_of.hpp"

namespace mahlwerk::soft {

template std::unique_ptr<const Surroundings> surroundings_of(const geometry::RoundedCylinder&,
                                                             const scene::Chamber&);

}  // namespace mahlwerk::soft
