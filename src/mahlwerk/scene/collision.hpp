// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/body_feature.hpp"

namespace mahlwerk::scene {

/// Record of one finished collision, of either engine.
struct Collision {
  double time = 0;             ///< [s] of first touch, since the start of the run
  double duration = 0;         ///< [s] in the event engine from first to last bounce
  std::int32_t ball = 0;       ///< index of the ball
  std::int32_t other = 0;      ///< index of the other ball; < 0: jar face ~other
  Vec3 where;                  ///< [m] point of contact, in the jar's own axes
  Vec3 normal;                 ///< unit, from the ball to the contact, same axes
  double mass = 0;             ///< [kg] effective; against the jar the ball's own
  double approach = 0;         ///< [m/s] u_n > 0, normal speed at first touch
  double slip = 0;             ///< [m/s] |u_t| of the touching surfaces, spin included
  double glide = 0;            ///< [m/s] tangential speed of the centres, spin left out
  double impulse = 0;          ///< [N s] normal
  double lost_normal = 0;      ///< [J] dissipated along the normal
  double lost_tangential = 0;  ///< [J] dissipated along the wall
  /// Where the ball and the other one were hit; as `where`, at the end of the contact.
  BodyFeature feature = BodyFeature::none, other_feature = BodyFeature::none;

  double energy_normal() const { return 0.5 * mass * approach * approach; }  // (evt.9) [J]
  double energy_contact_point() const {                                      // (evt.10) [J]
    return 0.5 * mass * (approach * approach + slip * slip);
  }
  double energy_centre() const {  // (evt.11) [J]
    return 0.5 * mass * (approach * approach + glide * glide);
  }
  double lost() const { return lost_normal + lost_tangential; }  // [J]
};

}  // namespace mahlwerk::scene
