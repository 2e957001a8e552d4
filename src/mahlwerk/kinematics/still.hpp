// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/kinematics/motion.hpp"

namespace mahlwerk::kinematics {

/// A jar at rest.
struct Still : NonRotating {
  static constexpr std::string_view name = "still";
  static constexpr std::string_view about = "a jar at rest";
  static constexpr Vec3 jar_axis = upright;
  static constexpr auto fields() { return std::array<Field<Still>, 0>{}; }

  FrameMotion frame_motion(double) const { return {}; }
  Bounds bounds() const { return {}; }
  double period() const { return no_period; }
  bool operator==(const Still&) const = default;
};

}  // namespace mahlwerk::kinematics
