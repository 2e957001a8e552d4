// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/case.hpp"

// Times that follow from run.settle = "auto" (docs/theory/statistics.md, "Settling").
namespace mahlwerk::cases {

/// [s] One turn of a drum, of the disc of a planetary mill or of a rotor; one oscillation of
/// another mill; of a speed over time at its last speed, or one repetition. Infinite for a jar at
/// rest.
double mill_period(const Case& c);

/// Blocks of time in which run.settle = "auto" looks for a trend.
struct SettlingBlocks {
  double begin = 0;                ///< [s] before the first block: of a mill that speeds up
  double length = 0;               ///< [s] of a block
  int most = 0;                    ///< blocks after which counting begins in any case
  static constexpr int least = 8;  ///< blocks before counting may begin
};

/// Whether counting begins once the mill has settled: run.settle is "auto", the mill moves, and the
/// case does not give the velocities of the balls.
bool settles(const Case& c);
/// The blocks of a case that settles().
SettlingBlocks settling_blocks(const Case& c);
/// [s] Time before counting: run.settle, or the least that "auto" takes.
double least_settling(const Case& c);

/// [s] Counted time: run.time; of a case that settles(), whole periods of the mill, at least three
/// turns of a drum (sta.10).
double counted_time(const Case& c);

/// [s] Counted time to plan with: counted_time(); a tenth of it where time = "until ..." ends the
/// run and run.longest is not given, a limit that few runs need.
double expected_time(const Case& c);

/// [s] Simulated time of a replicate: that before counting, at least, and the counted time.
double simulated_time(const Case& c);

}  // namespace mahlwerk::cases
