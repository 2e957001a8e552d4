// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "mahlwerk/kinematics/any_motion.hpp"
#include "mahlwerk/kinematics/arc_shaker.hpp"
#include "mahlwerk/kinematics/circular.hpp"
#include "mahlwerk/kinematics/drive.hpp"
#include "mahlwerk/kinematics/figure_eight.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/kinematics/still.hpp"
#include "mahlwerk/kinematics/tabulated.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/kinematics/vibration.hpp"

namespace mahlwerk::kinematics {

/// The register of all motions. To add one, write its file and add its name here.
using Motions = std::variant<Still, Vibration, Planetary, Tumbling, ArcShaker, FigureEight,
                             Circular, Tabulated>;
/// A class rather than an alias, so that any_motion.hpp can declare it.
struct AnyMotion : Motions {
  using Models = Motions;
  using Models::Models;
  SpeedProgram program;  ///< of its speed in this run; empty: the full one throughout
  /// The motor that turns the mill in this run (drive.hpp), shared by copies; null: its speed is
  /// given.
  std::shared_ptr<Drive> drive;
};

}  // namespace mahlwerk::kinematics
