// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/rolling.hpp"

namespace mahlwerk::contact {

/// The contact model of the soft engine: a law with its numbers, rolling resistance, and switches
/// that hold under every law.
struct ContactModel {
  Indirect<AnyLaw> law;
  Rolling rolling = Rolling::cdt;
  double rolling_damping = 0.2;     ///< [1] eta_r of epsd, share of critical damping
  bool curved_walls = false;        ///< R* of a ball at a wall takes the wall's curvature in
  bool rescaled_unloading = false;  ///< the tangential spring weakens on unloading (dem.21)
  bool operator==(const ContactModel&) const = default;
};

}  // namespace mahlwerk::contact
