// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "mahlwerk/results/summary.hpp"

// Replicates that fall into two states by their dissipated power
// (docs/theory/statistics.md, "Two states").
namespace mahlwerk::results {

/// Some of the replicates, and the quantities of summary.json over them alone.
struct State {
  std::vector<std::size_t> replicates;  ///< their numbers, from 1
  std::vector<Quantity> quantities;

  const Quantity& named(std::string_view name) const;
};

struct TwoStates {
  std::array<State, 2> states;  ///< less power first
  double chance = 0;            ///< (sta.7)

  /// [1] of the replicates that means are taken over.
  double share(const State& state) const;
};

/// Nothing where the replicates show one state, or are too few to tell.
std::optional<TwoStates> two_states(const Outcome& outcome);

/// The notice of them; none where there is one state.
Notices state_notices(const Outcome& outcome);

}  // namespace mahlwerk::results
