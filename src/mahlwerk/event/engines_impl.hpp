// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/event/engines.hpp"
#include "mahlwerk/event/one_ball.hpp"
#include "mahlwerk/kinematics/vibration.hpp"

namespace mahlwerk::event {

// One vibrated ball has the shortest search of all. A function call for the motion would slow it by
// a sixth, so Vibration is known at compile time. All other motions are chosen at run time.
template <class S>
std::unique_ptr<scene::Engine> one_ball_in(const S& shape, const scene::Chamber& chamber,
                                           const scene::Ball& ball, const Rules& rules,
                                           double start) {
  const auto engine = [&]<class M>(const M& motion) -> std::unique_ptr<scene::Engine> {
    return std::make_unique<OneBall<S, M>>(TypedChamber<S, M>(shape, motion, chamber), ball, rules,
                                           start);
  };
  const auto* shaken = kinematics::as<kinematics::Vibration>(*chamber.motion);
  if (shaken != nullptr && !kinematics::speed_varies(*chamber.motion)) return engine(*shaken);
  return engine(kinematics::CachedMotion(chamber.motion));
}

template <class S>
std::unique_ptr<const MovingWall> moving_wall_of(const S& shape, const scene::Chamber& chamber) {
  using M = kinematics::CachedMotion;
  return std::make_unique<ChamberWall<S, M>>(TypedChamber<S, M>(shape, M(chamber.motion), chamber));
}

}  // namespace mahlwerk::event
