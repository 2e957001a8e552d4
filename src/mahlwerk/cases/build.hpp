// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/contact/bounce_table.hpp"
#include "mahlwerk/contact/pair_table.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::cases {

/// The jar of a case with the motion of its mill; with [drive], of one run of its own.
scene::Chamber chamber(const Case& c);

/// The section [flow] of a case that has one, in the jar frame.
scene::Flow flow_in_jar_frame(const Case& c);

/// Balls at random positions without contact, with random velocities and spins in the ranges of
/// [run] (Chen et al. 2016: 0 to 0.1 m/s in the laboratory, 0 to 0.1 rad/s). Positions given by the
/// case are kept, or those of run.start_from. The fresh feed is outside. The result depends only on
/// the seed and the replicate. Throws Interrupted once `*stop` is set.
std::vector<scene::Ball> starting_balls(const Case& c, int replicate,
                                        const std::atomic<bool>* stop = nullptr);

/// The balls of all sets in the order of starting_balls(), at rest in the middle of the jar.
std::vector<scene::Ball> balls_by_set(const std::vector<BallSet>& sets);

/// Parts the overlapping balls of a start state, for the event engine. Throws InputError
/// "bad-start-state" if that fails, Interrupted once `*stop` is set.
void remove_overlaps(const Case& c, std::vector<scene::Ball>& balls,
                     const std::atomic<bool>* stop = nullptr);

/// The shapes of the balls of each set; none if all are spheres.
std::vector<scene::BodyShape> body_shapes(const Case& c);
/// The balls as pictures show them: the spheres of bodies in their place.
std::vector<scene::Ball> drawn_spheres(const Case& c, const std::vector<scene::Ball>& balls);

/// Index of the ball set of each ball, in the order of starting_balls().
std::vector<std::int32_t> kinds_of_balls(const Case& c);

/// A sentence on the coarse-graining of the powder; empty if the powder is not simulated as grains.
std::string grains_note(const Case& c);
/// One text for each set with a size distribution: its diameters and the count of each.
std::vector<std::string> size_notes(const Case& c);

/// The bounce rule of every pair of ball sets, and of every ball set with every face of the jar.
contact::BounceTable bounce_table(const Case& c);

/// Whether the surface of the jar looks the same at all times: the jar does not rotate, or rotates
/// about its axis of symmetry, and holds no stirrer.
bool jar_mesh_is_static(const Case& c);

/// Approximate size on disk of one frame of [observe] frames [bytes].
double frame_bytes(const Case& c);

/// The pair parameters of the soft engine's contact laws: softened moduli, and the values of
/// [contact] and its pairs. A speed-dependent restitution is represented by its value().
contact::PairTable pair_table(const Case& c);

/// Warnings about the jar and the powder in it; empty if there are none.
Notices jar_warnings(const Case& c);

/// Clears the mark `assumed` of values that the engine does not read, and `assumed` and
/// `unverified` of values that only wear or heat would need.
void drop_irrelevant_assumptions(Case& c);
/// Notes on keys that the case gives and `engine` does not read, or only in part.
Notices ignored_keys(const Case& c, EngineName engine);

/// Warnings about values that are allowed but probably a mistake: a metal as light as air, a
/// planetary jar that rotates in the direction of its disc.
Notices unusual_values(const Case& c);

/// A quantity that follows from a case without a run.
struct DerivedQuantity {
  std::string name;  ///< "peak_wall_speed"
  double value = 0;  ///< in `unit`
  std::string unit;
  std::string about;  ///< description with the equation label
};

/// Peak wall speed, acceleration number, critical speed or speed ratio, expected impact energy and
/// the charge; empty for a case without balls.
std::vector<DerivedQuantity> derived_quantities(const Case& c);

}  // namespace mahlwerk::cases
