// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/contact/law.hpp"

// The history of one contact, where contacts are not in lanes of packets.
namespace mahlwerk::soft {

/// History of a contact, and its sums since the onset.
struct ContactState {
  Vec<double> spring{};  ///< [m] half a step ahead; with partial slip its force [N]
  double impulse = 0, lost_normal = 0, lost_tangential = 0;  ///< [N s], [J], [J]
  std::int64_t onset_step = 0;
  double approach = 0, slip = 0, glide = 0;  ///< [m/s] at the onset
  bool tensile = false;                      ///< the load was < 0 at the last step
};
/// History that only some laws and rolling models need.
struct OptionalState {
  double law_history[contact::law_history_size]{};
  Vec<double> rolling_spring_torque{};
  double stiffness = 0;
};
/// History that only partial slip and twisting friction need (FrictionHistory).
struct FrictionState {
  Vec<double> turning_force{};
  double load = 0, twist = 0;
};

}  // namespace mahlwerk::soft
