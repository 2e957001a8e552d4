// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace mahlwerk::event {

/// Whether the bounces after a rebound at `speed` [m/s], an infinite series at the restitution `e`,
/// end before the normal force per mass `pressing` [m/s2] can halve, or are lower than `unresolved`
/// [m] (inelastic collapse, evt.19). `rate` [m/s3] bounds the change of `pressing`.
inline bool bounces_collapse(double speed, double e, double pressing, double rate,
                             double unresolved) {
  if (!(pressing > 0)) return false;
  const double height = speed * speed / (2 * pressing);      // [m] of the first bounce
  const double duration = 2 * speed / (pressing * (1 - e));  // [s] of all
  return (e < 1 && height < unresolved) || duration * rate < 0.5 * pressing;
}

}  // namespace mahlwerk::event
