// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

// Costs of a run, known before they are paid: time and disk. run/memory.hpp has the memory.
namespace mahlwerk::campaign {

/// What a short pilot run on this machine tells about a run on all its cores.
struct Forecast {
  double each = 0;         ///< [s] of a thread for one replicate, where replicates run together
  std::int64_t share = 1;  ///< replicates of the thread that has most
  double settling = 0;     ///< [s] simulated before counting begins
  double collisions = 0;   ///< [1/s] simulated, of one replicate; a record each
};

/// Runs `decided`, a case with a chosen engine, for about `patience` of wall time; with the soft
/// engine from a settled state where it is soon reached: a bed takes more time than balls that
/// fall.
Forecast forecast(const cases::Case& decided,
                  std::chrono::milliseconds patience = std::chrono::milliseconds{700});

/// [bytes] of the files of a run, about: its tables and report, its frames, and with
/// observe.collisions the records of `collisions` [1/s] of each replicate.
double disk_needed(const cases::Case& mill_case, double collisions);

/// [bytes] free on the disk of `folder`, or of its nearest parent that exists; empty if the system
/// does not tell.
std::optional<double> disk_available(const std::filesystem::path& folder);

/// A fault if the frames and records of all points need more than `available` [bytes], or more than
/// largest_records where there are records. `collisions` is of each replicate of any point.
std::vector<Fault> disk_faults(const std::vector<cases::Case>& points, double collisions,
                               std::optional<double> available);

constexpr double largest_records = 50e9;  ///< [bytes] of a run; more is taken for a mistake

/// disk_faults() of a run into `folder`, after a short pilot if the first case records collisions.
/// Throws them as an InputError.
void check_disk(const std::vector<cases::Case>& points, const std::filesystem::path& folder);

}  // namespace mahlwerk::campaign
