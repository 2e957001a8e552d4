// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/rolling.hpp"
#include "mahlwerk/contact/twisting.hpp"

namespace mahlwerk::contact {

/// The contact model of the soft engine: a law with its parameters, rolling resistance, and
/// switches that apply to every law. The event engine reads `twisting`.
struct ContactModel {
  Indirect<AnyLaw> law;
  Rolling rolling = Rolling::cdt;
  double rolling_damping = 0.2;     ///< [1] eta of epsd (dem.25), fraction of critical damping
  bool curved_walls = false;        ///< R* at a wall includes the wall's curvature
  bool rescaled_unloading = false;  ///< rescale the tangential spring on unloading (dem.21)
  bool partial_slip = false;        ///< the tangential spring softens as slip spreads (dem.40)
  Twisting twisting = Twisting::none;
  bool operator==(const ContactModel&) const = default;
};

}  // namespace mahlwerk::contact
