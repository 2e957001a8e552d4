// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "mahlwerk/kinematics/arc_shaker.hpp"
#include "mahlwerk/kinematics/circular.hpp"
#include "mahlwerk/kinematics/figure_eight.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/still.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/kinematics/vibration.hpp"

namespace mahlwerk::kinematics {

/// The register: every motion there is. A new one is its file and its name here.
using AnyMotion = std::variant<Still, Vibration, Planetary, Tumbling, ArcShaker, FigureEight,
                               Circular, Tabulated>;

}  // namespace mahlwerk::kinematics
