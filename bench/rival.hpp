// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace mahlwerk::bench {

/// Another event-driven program, to be timed beside Mahlwerk on the same machine. It is not part
/// of Mahlwerk: the environment variable MAHLWERK_RIVAL names an executable, usually a script
/// around the program. It is called in a new temporary folder as
///
///     $MAHLWERK_RIVAL PACKING BALLS COLLISIONS
///
/// simulates BALLS (a cube number) equal smooth elastic spheres in a periodic cube that they fill
/// to PACKING, from a simple cubic lattice with random velocities, until at least COLLISIONS
/// collisions have taken place, and prints the number of collisions that have, alone on its last
/// line. It runs on one core.
class Rival {
 public:
  /// The program that MAHLWERK_RIVAL names. If the variable is not set, says on standard error how
  /// to set it. Throws std::runtime_error if it names no executable file.
  static std::optional<Rival> from_environment();

  /// Collisions per second of CPU time, user and system, as the kernel accounts for the program
  /// and all programs that it has started and waited for. The difference between a long and a
  /// short run; so start-up and the first collisions, away from equilibrium, do not count. Throws
  /// std::runtime_error if a run fails.
  double collisions_per_second(double packing, int balls) const;

 private:
  struct Run {
    std::int64_t collisions;
    double cpu_seconds;
  };
  explicit Rival(std::filesystem::path program) : program_(std::move(program)) {}
  Run run(double packing, int balls, std::int64_t collisions) const;

  std::filesystem::path program_;
};

}  // namespace mahlwerk::bench
