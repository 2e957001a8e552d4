// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/measure/mill_motion.hpp"
#include "mahlwerk/measure/oscillation.hpp"
#include "mahlwerk/measure/propagation.hpp"

// Parts of the analysis of a film: numbers of fits as findings.
namespace mahlwerk::measure {

/// The common oscillation of the first `marks` marks: coordinates x1, y1, x2, y2.
Oscillation oscillation_of(const MarkTracks& tracks, std::size_t marks);

Finding frequency_finding(const Oscillation& of);
Finding speed_finding(const TurningVector& vector, int freedom);

/// Radius of a turning vector times the scale [m], with half-widths of both.
observe::Estimate radius_times(const TurningVector& vector, int freedom,
                               const observe::Estimate& scale);

/// Cosine and sine of x, then of y, of a mark, each with its 95 % half-width.
std::vector<observe::Estimate> phasor_inputs(const Oscillation& of, std::size_t mark);

/// Half axes of the ellipse x = xc cos + xs sin, y = yc cos + ys sin, the longer first.
std::array<double, 2> ellipse_of(double xc, double xs, double yc, double ys);

/// Swing of a rigid body about a pivot (mea.6).
struct RigidArc {
  double swing = 0;   ///< [rad] to either side
  double arm = 0;     ///< from the pivot to the first mark, in the unit of the marks
  double strain = 0;  ///< oscillation of the marks' distance, relative to it; 0 for a rigid body
};
/// From the amplitudes of both marks, as complex numbers, and the difference of their means.
RigidArc rigid_arc(Complex x1, Complex y1, Complex x2, Complex y2, double apart_x, double apart_y);

/// Adds arm and swing of `both`, with their covariance, and the half stroke, their product.
void add_arm_and_swing(const Propagated& both, Findings& found);

/// Remarks on rotations: too few frames per second, too few turns.
void remark_turning(const MarkTracks& tracks, const Turning& of, Findings& found);

}  // namespace mahlwerk::measure
