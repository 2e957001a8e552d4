// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/observe/charge.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"
#include "mahlwerk/observe/replay.hpp"
#include "mahlwerk/observe/stress_stream.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/summary.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::results {

/// One stretch of a replicate's time, for the time series. Rates and powers are means over the
/// stretch.
struct Window {
  double time = 0;                  ///< [s] its end, since counting began
  double length = 0;                ///< [s] how long it was
  double collisions = 0;            ///< how many
  double above = 0;                 ///< how many with u_n above the threshold
  double energy_normal = 0;         ///< [J] sum over its collisions
  double energy_contact_point = 0;  ///< [J] sum
  double lost = 0;                  ///< [J] dissipated
  double wall_work = 0;             ///< [J] done by the jar
  double contact_time = 0;          ///< [s] in lasting contact
  double kinetic = 0;               ///< [J] at its end
};

/// What collisions catch of grains of the median size of the feed, per second.
struct CaptureRates {
  double mass = 0;    ///< [kg/s]
  double power = 0;   ///< [W] that caught grains get
  double grains = 0;  ///< [1] in a collision, mean by energy
};

/// What a replicate's collisions do to the powder.
struct GrindingOutcome {
  powder::StressSpectrum stresses;
  CaptureRates capture;                          ///< with [capture]
  double dose_rate = 0;                          ///< [W/kg] of [kinetics], or of what is caught
  std::optional<powder::SizeEvolution> balance;  ///< with [grinding] method = "balance" or "both"
  std::optional<powder::SizeEvolution> sample;   ///< with "statistical" or "both"

  /// The one that counts where there are both.
  const powder::SizeEvolution& milling() const { return balance ? *balance : *sample; }
  bool has_milling() const { return balance || sample; }
};

/// What one replicate gave. Sums are over the counted time; `energy_balance` is over the whole run.
struct Replicate {
  explicit Replicate(double threshold, observe::BallKinds kinds = {},
                     const observe::WallGrid& wall = {})
      : tally(threshold, std::move(kinds), wall) {}
  observe::CollisionStatistics tally;
  observe::Charge charge;        ///< how it lies in the jar
  observe::Replay replay;        ///< of the first replicate
  observe::StressStream stream;  ///< for a sample of the powder
  std::optional<GrindingOutcome>
      grinding;  ///< with [capture] or [kinetics], once the run has ended
  std::vector<Window> windows;
  scene::EnergyBalance energy_balance;  ///< at the end
  scene::EnergyBalance at_settled;      ///< when counting began
  bool complete = true;                 ///< false if stopped early
  bool precision_reached = true;        ///< false if a run that waits for certainty did not get it
  std::string stop_reason;              ///< why, if physics stopped it
  std::vector<scene::Ball> balls_at_stop;  ///< the balls when physics stopped it, in the jar frame
  double cpu_seconds = 0;
  double time() const { return energy_balance.time - at_settled.time; }  ///< [s] counted
};

struct Outcome {
  cases::Case what;
  std::vector<Replicate> replicates;
  cases::EngineName engine = cases::EngineName::event;  ///< that ran it: event or soft
  // Made once, when the run ends:
  Summary summary = {};  ///< its numbers (results/summarise.hpp)
  Notices notices = {};  ///< what a reader should know besides
  double wall_seconds = 0, cpu_seconds = 0;
  bool interrupted = false;
};

/// The number of one of its replicates, from 1.
inline std::size_t number_of(const Outcome& outcome, const Replicate& replicate) {
  return static_cast<std::size_t>(&replicate - outcome.replicates.data()) + 1;
}

/// The value of a quantity of its summary in one of its replicates; NaN where it has none.
double value_of(const Outcome& outcome, const Replicate& replicate, std::string_view quantity);

/// The replicates that means are taken over: those that ran to their end if there are at least two,
/// else all that counted any time.
std::vector<const Replicate*> averaged_replicates(const Outcome& outcome);
/// Those of them that have ground.
std::vector<const Replicate*> grinding_replicates(const Outcome& outcome);

/// Mean of what `of` says of each replicate; NaN of none.
template <class Of>
double mean_over(const std::vector<const Replicate*>& replicates, const Of& of) {
  double sum = 0;
  for (const Replicate* r : replicates) sum += of(*r);
  return sum / static_cast<double>(replicates.size());
}

/// True if every replicate was run, and to its end.
bool complete(const Outcome& outcome);

}  // namespace mahlwerk::results
