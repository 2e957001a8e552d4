// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/contact/lubrication.hpp"
#include "mahlwerk/contact/pair_table.hpp"

namespace mahlwerk::event {

/// Treatment of inelastic collapse, where bounces become infinitely many and ever smaller
/// (docs/theory/event.md, "Collapse"): begin a sustained contact, apply the TC rule, or do nothing.
enum class SustainedContactMode { roll, tc, none };

/// Collision rules of one ball and its jar, and the treatment of inelastic collapse. The engine for
/// many balls reads only the latter, `threshold` and `elastic`; its collision rules are in a
/// BounceTable.
struct Rules {
  contact::BounceRule bounce;
  std::vector<contact::BounceRule> faces;  ///< by face of the jar; empty: all as `bounce`
  /// Coulomb's mu in sustained contacts, also where the collision rule has no Coulomb limit
  /// (evt.15).
  double sustained_friction = 0.3;
  double rolling_friction = 0;  ///< mu_r of sustained contacts
  SustainedContactMode sustained_mode = SustainedContactMode::roll;
  /// [m/s] a ball that is pressed to the wall and rebounds more slowly begins a sustained contact
  /// (evt.19).
  double sustained_speed = 1e-4;
  double contact_time = 1e-4;  ///< [s] t_c of the TC rule
  double threshold = 0;        ///< [m/s] slower collisions are not counted in hits_within
  /// Moduli of the pairs of many balls: bounces of one contact are joined to one record (man.9).
  /// None: each bounce is a record.
  std::optional<contact::PairTable> elastic = std::nullopt;
  /// Moduli of the pairs, for twisting friction (evt.24 to evt.27). None: bodies turn freely about
  /// the normal.
  std::optional<contact::PairTable> twisting = std::nullopt;

  /// Films on the bodies, which slow them down before they touch (liq.3); none: dry. The engine
  /// takes films that cavitate on rebound; it has no liquid around the balls.
  std::optional<contact::Liquid> liquid = std::nullopt;

  /// Speed [m/s] at which bodies touch that approach at `approach` [m/s].
  double touch_speed(double effective_radius, double effective_mass, double approach) const {
    return liquid ? liquid->touch_speed(effective_radius, effective_mass, approach) : approach;
  }
  const contact::BounceRule& wall(int face) const {
    return faces.empty() ? bounce : faces[static_cast<std::size_t>(face)];
  }
};

}  // namespace mahlwerk::event
