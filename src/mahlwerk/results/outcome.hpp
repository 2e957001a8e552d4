// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/charge.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"
#include "mahlwerk/observe/motion_states.hpp"
#include "mahlwerk/observe/recorder.hpp"
#include "mahlwerk/observe/replay.hpp"
#include "mahlwerk/observe/stress_stream.hpp"
#include "mahlwerk/powder/kinetics/milling_conditions.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/summary.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/scene/wall_load.hpp"

namespace mahlwerk::results {

/// Sums over one time window of a replicate, for the time series.
struct Window {
  double time = 0;                  ///< [s] end of the window, since counting began
  double length = 0;                ///< [s] length of the window
  double collisions = 0;            ///< number of collisions
  double above = 0;                 ///< number of collisions with u_n at or above the threshold
  double energy_normal = 0;         ///< [J] sum over the collisions
  double energy_contact_point = 0;  ///< [J] sum over the collisions
  double lost = 0;                  ///< [J] dissipated energy
  double wall_work = 0;             ///< [J] work of the jar on the balls
  double flow = 0;                  ///< [J] of balls that entered, less those that left
  double contact_time = 0;          ///< [s] time in sustained contact, summed over balls
  double kinetic = 0;               ///< [J] kinetic energy at the end of the window

  double given() const { return wall_work + flow; }  ///< [J] to the balls
};

/// Capture of grains of the feed's median size, per second.
struct CaptureRates {
  double mass = 0;    ///< [kg/s] captured mass
  double power = 0;   ///< [W] power that captured grains get
  double grains = 0;  ///< [1] captured grains in a collision, mean weighted by energy
};

/// Capture, dose and grinding of the powder by one replicate's collisions.
struct GrindingOutcome {
  powder::StressSpectrum stresses;
  CaptureRates capture;                          ///< with [capture]
  double dose_rate = 0;                          ///< [W/kg] of [kinetics], or of captured grains
  powder::MillingConditions conditions;          ///< with [kinetics]
  std::optional<powder::SizeEvolution> balance;  ///< with [grinding] method = "balance" or "both"
  std::optional<powder::SizeEvolution> sample;   ///< with "statistical" or "both"

  /// The result that quantities come from: the balance if there is one, else the sample.
  const powder::SizeEvolution& milling() const { return balance ? *balance : *sample; }
  bool has_milling() const { return balance || sample; }
};

/// A point on the line from a drum's axis through the charge's centre of mass (bed.hpp).
struct BedPoint {
  double distance = 0;  ///< [m] from the axis, into the bed
  double density = 0;   ///< [kg/m2] mass per area of the cross-section
  double velocity = 0;  ///< [m/s] across the line, in the sense of rotation; NaN without mass
};

/// What is read of one replicate's maps and spectra, once these are in sums over replicates and
/// forgotten (results/quantities/summed_up.hpp).
struct ReadBefore {
  std::vector<double> values;      ///< of the quantities
  double speed_in_jar = 0;         ///< [m/s] root mean square, as in_carrier
  double speed_in_carrier = 0;     ///< [m/s]
  double largest_speed = 0;        ///< [m/s] of the fastest collisions
  double share_by_softening = 0;   ///< [1] of the balls' time
  double heat_in_balls = 0;        ///< [1] of the dissipated power, with [heat]
  std::vector<BedPoint> bed = {};  ///< of a drum
};

/// Result of one replicate. Sums are over the counted time; `energy_balance` is over the whole run.
struct Replicate {
  explicit Replicate(double threshold, observe::BallKinds kinds = {},
                     const observe::WallGrid& wall = {},
                     const std::vector<observe::PartGrid>& parts = {})
      : tally(threshold, std::move(kinds), wall, parts) {}
  observe::CollisionStatistics tally;
  observe::Charge charge;        ///< density and velocity fields of the charge
  observe::MotionStates motion;  ///< of a lying jar that is shaken
  observe::Replay replay;        ///< frames for pictures; usually of the first replicate only
  observe::StressStream stream;  ///< collisions in order of time, for a sample of the powder
  observe::Recorders recorders;  ///< of parts
  std::optional<GrindingOutcome>
      grinding;  ///< with [capture] or [kinetics], once the run has ended
  std::vector<Window> windows;
  scene::EnergyBalance energy_balance;  ///< at the end
  scene::EnergyBalance at_settled;      ///< when counting began
  /// Loads of the jar and its parts, at the end and when counting began; none without parts.
  std::vector<scene::WallLoad> loads = {}, loads_at_settled = {};
  bool settled = true;                     ///< false if run.settle = "auto" found a trend
  bool complete = true;                    ///< false if stopped early
  bool precision_reached = true;           ///< false if [run] until was not reached
  std::string stop_reason;                 ///< reason if physics stopped the run, else empty
  std::vector<scene::Ball> balls_at_stop;  ///< the balls when physics stopped it, in the jar frame
  std::vector<scene::Ball> balls_at_end;   ///< with observe.final_state: in the carrier's axes
  double cpu_seconds = 0;
  int restarts = 0;                       ///< of LAMMPS, from its restart files
  std::optional<ReadBefore> read_before;  ///< with it, maps and spectra are forgotten
  /// Gives back memory that a result does not need; nothing is added from then on.
  void pack() {
    tally.pack();
    charge.pack();
    stream = {};  // `grinding` has what comes from it
    windows.shrink_to_fit();
  }
  double time() const { return energy_balance.time - at_settled.time; }  ///< [s] counted time
};

struct SummedUp;  // results/quantities/summed_up.hpp

/// A case, its replicates and the numbers made from them.
struct Outcome {
  cases::Case mill_case;
  std::vector<Replicate> replicates;
  /// Sums over the replicates whose maps and spectra are forgotten, if there are such. They are the
  /// first ones that means are taken over.
  std::shared_ptr<const SummedUp> summed_up = nullptr;
  cases::EngineName engine = cases::EngineName::event;  ///< engine of the run, never auto
  // Computed once, when the run ends:
  Summary summary = {};  ///< quantities (results/quantities/summarise.hpp)
  Notices notices = {};  ///< warnings and notes (results/notices/warnings.hpp)
  double wall_seconds = 0, cpu_seconds = 0;
  bool interrupted = false;
};

/// The number of a replicate of the outcome, from 1.
inline std::size_t number_of(const Outcome& outcome, const Replicate& replicate) {
  return static_cast<std::size_t>(&replicate - outcome.replicates.data()) + 1;
}

/// The value of a summary quantity in one replicate; NaN where it has none.
double value_of(const Outcome& outcome, const Replicate& replicate, std::string_view quantity);

/// The replicates that means are taken over: the complete ones if there are at least two, else all
/// with a counted time above 0.
std::vector<const Replicate*> averaged_replicates(const Outcome& outcome);
/// The averaged replicates that have a GrindingOutcome.
std::vector<const Replicate*> grinding_replicates(const Outcome& outcome);

/// Mean of `of(replicate)`; NaN without replicates.
template <class Of>
double mean_over(const std::vector<const Replicate*>& replicates, const Of& of) {
  double sum = 0;
  for (const Replicate* r : replicates) sum += of(*r);
  return sum / static_cast<double>(replicates.size());
}

/// The least of `of(replicate)`, a number of samples; 0 without replicates.
template <class Of>
std::size_t fewest_over(const std::vector<const Replicate*>& replicates, const Of& of) {
  if (replicates.empty()) return 0;
  std::size_t least = of(*replicates.front());
  for (const Replicate* r : replicates) least = std::min(least, of(*r));
  return least;
}

/// True if there are replicates, and all of them ran to their end.
bool complete(const Outcome& outcome);

}  // namespace mahlwerk::results
