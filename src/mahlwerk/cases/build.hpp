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

/// The jar of a case on its mill.
scene::Chamber chamber(const Case& c);

/// Balls at random places where they touch nothing, with random velocities and spins as the case's
/// [run] says (paper A: 0 to 0.1 m/s in the laboratory, 0 to 0.1 rad/s). Places that the case gives
/// are kept. Depends on the seed and the replicate alone. Throws Interrupted once `*stop` is set.
std::vector<scene::Ball> starting_balls(const Case& c, int replicate,
                                        const std::atomic<bool>* stop = nullptr);

/// The set each ball belongs to, in the order of starting_balls().
std::vector<std::int32_t> kinds_of_balls(const Case& c);

/// What grains stand for, in a sentence; empty where the powder is not simulated.
std::string grains_note(const Case& c);
/// For each set whose sizes differ, its sizes with their numbers.
std::vector<std::string> size_notes(const Case& c);

/// Who bounces off whom by which rule: a kind for each ball set, the faces of the jar.
contact::BounceTable bounce_table(const Case& c);

/// Whether the jar looks the same at all times: it does not turn, or about the axis it is symmetric
/// to, and nothing in it turns by itself.
bool looks_still(const Case& c);

/// About how much room one frame of [observe] frames takes on disk [bytes].
double frame_bytes(const Case& c);

/// What the soft engine's laws need of every two that may touch: moduli, softened, and the values
/// of [contact] and its pairs. A restitution that depends on the speed counts by its value().
contact::PairTable pair_table(const Case& c);

/// What a user should know of the jar before trusting a run in it; empty if all is well.
Notices jar_warnings(const Case& c);

/// What the engine does not look at, or nobody asked for, is no assumption of the results.
void drop_irrelevant_assumptions(Case& c);
/// Keys that the case gives and `engine` does not look at.
Notices ignored_keys(const Case& c, EngineName engine);

/// Values that are allowed and most likely a slip: a metal as light as air, a jar that turns with
/// its disc.
Notices unusual_values(const Case& c);

/// One thing that follows from a case before it is run.
struct DerivedQuantity {
  std::string name;  ///< "peak_wall_speed"
  double value = 0;  ///< in `unit`
  std::string unit;
  std::string about;  ///< a sentence with the formula's label
};

/// Peak wall speed, acceleration number, critical speed or speed ratio, expected impact energy,
/// charge.
std::vector<DerivedQuantity> derived_quantities(const Case& c);

}  // namespace mahlwerk::cases
