// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/wear/wear_evolution.hpp"
#include "mahlwerk/report/plot/plot.hpp"

// Wear over the time of operation: text, JSON and page.
namespace mahlwerk::report {

using campaign::WearEvolution;

/// A line per stage, and the life of each profile.
std::string wear_evolution_text(const WearEvolution& all);
std::string wear_evolution_json(const WearEvolution& all, std::string_view version);
std::vector<Plot> wear_evolution_plots(const WearEvolution& all);
std::string wear_evolution_page(const WearEvolution& all, std::string_view version);

}  // namespace mahlwerk::report
