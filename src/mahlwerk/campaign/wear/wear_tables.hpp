// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/campaign/wear/wear_evolution.hpp"
#include "mahlwerk/results/files/result_tables.hpp"

// The tables of wear over the time of operation (docs/formats.md).
namespace mahlwerk::campaign {

results::Table wear_evolution_table(const WearEvolution& all);  ///< a row per stage
results::Table wear_profile_table(const WearEvolution& all);    ///< a row per corner and stage
results::Table ball_sizes_table(const WearEvolution& all);      ///< a row per cohort and stage
results::Table wear_spectra_table(const WearEvolution& all);    ///< a row per bin and stage
/// All of them that have rows, under the names of their files.
std::vector<results::NamedTable> wear_tables(const WearEvolution& all);

}  // namespace mahlwerk::campaign
