// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/quaternion.hpp"
#include "mahlwerk/base/vec3.hpp"

// The section [run] of a case: engine, times, and how the balls and the mill start.
namespace mahlwerk::cases {

/// Frame of reference of the starting speeds.
enum class StartFrame {
  laboratory,
  jar  ///< moves with the jar's centre, without rotation
};

/// Arrangement of the balls at the start.
enum class StartLayout {
  random,
  layers,  ///< the first ball set lowest, each set above the one before
  ramp     ///< anywhere, while the mill comes to its speed from rest
};

/// State of a ball at the start of a run, in the axes of the jar's carrier.
struct BallState {
  double radius = 0;            ///< [m]
  std::int32_t kind = 0;        ///< ball set, from 0
  Vec3 position;                ///< [m] from the jar's centre
  Vec3 velocity;                ///< [m/s] relative to the jar's centre
  Vec3 spin;                    ///< [rad/s]
  Quaternion orientation = {};  ///< of a body that is no sphere
  bool operator==(const BallState&) const = default;
};

/// Initial states of all balls, from the end of another run.
struct StartStates {
  std::string file;     ///< file or result folder as written; relative to the case file; or empty
  bool folder = false;  ///< whether it is a folder, with one state for each replicate
  /// By replicate; shared by the copies of a case. Null without `file` or after a fault.
  std::shared_ptr<const std::vector<std::vector<BallState>>> states = {};
  bool operator==(const StartStates& o) const {
    return file == o.file && folder == o.folder &&
           (states == o.states || (states && o.states && *states == *o.states));
  }
};

/// Ends a replicate once the confidence interval of a quantity is narrow enough.
struct StopCriterion {
  double within = 0;     ///< half-width of the 95 % confidence interval over the mean
  std::string quantity;  ///< "dissipated_power"
  bool operator==(const StopCriterion&) const = default;
};

/// The engine requested by a case; "auto" chooses event or soft.
enum class EngineName { event, soft, automatic, lammps };
std::string_view name_of(EngineName engine);  ///< "event", "soft", "auto", "lammps"
/// Whether it is a DEM, which resolves contacts in time steps.
constexpr bool in_time_steps(EngineName engine) {
  return engine == EngineName::soft || engine == EngineName::lammps;
}

/// Whether a single run also computes what its assumed values decide: always, never, or where this
/// simulates less time than the run itself.
enum class SensitivityMode { automatic, on, off };

/// What computes a run of the soft engine: the processor, or a graphics card. "auto" is the
/// processor until times on cards are known (docs/performance.md).
enum class DeviceName { automatic, cpu, gpu };

struct Run {
  EngineName engine = EngineName::event;
  double time = 0;                                    ///< [s] counted; with `until`: at most
  std::optional<StopCriterion> until = std::nullopt;  ///< ends each replicate sooner
  /// [s] settling time before, not counted; none: "auto", until the mill has settled
  std::optional<double> settle = 0.0;
  std::int64_t replicates = 1;
  double start_speed = 0;  ///< [m/s] initial speeds are uniform between 0 and this
  double start_spin = 0;   ///< [rad/s] initial spins are uniform between 0 and this
  StartFrame start_frame = StartFrame::laboratory;  ///< of start_speed
  StartLayout start = StartLayout::random;
  double ramp_time = 2;       ///< [s] in which the mill comes to its speed, with StartLayout::ramp
  double settle_at_rest = 0;  ///< [s] before the mill starts, with the mill standing still
  StartStates start_from = {};                     ///< replaces random positions, speeds and spins
  std::optional<double> time_step = std::nullopt;  ///< [s] of the soft engine; none: it chooses one
  /// [1] for the step the engine chooses: largest mean error of a collision (soft::StepError)
  double step_error = 0.01;
  double time_step_fraction = 0.25;  ///< of the Rayleigh time, at most, for the same step
  bool free_flight_skip = true;  ///< whether the soft engine skips steps in free flight and at rest
  DeviceName device = DeviceName::automatic;
  SensitivityMode sensitivity = SensitivityMode::automatic;  ///< to assumed values
  bool operator==(const Run&) const = default;
};

/// Counting begins after `settle` [s], without a ramp: the mill runs at its speed from the start.
inline void settle_at_speed(Run& run, double settle) {
  run.settle = settle;
  if (run.start == StartLayout::ramp) run.start = StartLayout::random;
}

}  // namespace mahlwerk::cases
