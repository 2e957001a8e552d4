// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::campaign {

/// The least contact.softening that this version chooses by itself.
constexpr double least_softening = 1e-4;

/// A mill that has settled.
struct SettledState {
  cases::Case mill_case;  ///< starts from that state, and counts from the start
  double settling = 0;    ///< [s] it took
};

/// The case `mill_case`, for any engine, from a state that the soft engine computes with contacts
/// of least_softening until the mill has settled. No value if the soft engine cannot run the case,
/// if that takes more than `most_work` balls times steps, or if `stop` is set. The same on any
/// machine.
std::optional<SettledState> settled_state(const cases::Case& mill_case, double most_work,
                                          const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
