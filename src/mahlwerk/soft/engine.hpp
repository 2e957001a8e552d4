// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/rules.hpp"

namespace mahlwerk::soft {

/// An engine that follows every contact in small steps of time, from `start` [s] on the mill's
/// clock. `pairs` has a kind for every Ball::kind and the faces of the jar. Throws InputError where
/// balls overlap each other or the jar by more than a hundredth of a radius.
std::unique_ptr<scene::Engine> engine(const scene::Chamber& chamber,
                                      const std::vector<scene::Ball>& balls, const Rules& rules,
                                      const contact::PairTable& pairs, double start = 0);

/// What a time step may be, for balls that meet at up to `speed` [m/s], the least over all pairs
/// (dem.28 to dem.31). All in s.
struct TimeSteps {
  double rayleigh = 0;  ///< time a surface wave takes round the smallest or softest ball
  double contact = 0;   ///< shortest collision
  double damper = 0;    ///< shortest in which the damper of a contact alone stops a ball (dem.33)
  double limit = 0;     ///< steps above this are unstable
  double overlap = 0;   ///< [1] largest overlap over the radius
  /// A fraction of rayleigh, at most contact / 50 and damper / 5.
  double recommended(double fraction) const;
};
TimeSteps time_steps(const std::vector<scene::Ball>& balls, const contact::AnyLaw& law,
                     const contact::PairTable& pairs, double speed);

}  // namespace mahlwerk::soft
