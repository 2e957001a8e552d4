// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/search/optimise.hpp"
#include "mahlwerk/report/plot/plot.hpp"

// Result of a search for the best settings: text for the terminal, CSV table, page.
namespace mahlwerk::report {

using campaign::KeyOptimum, campaign::Optimum, campaign::OptimumCheck, campaign::OptimumLimit,
    campaign::Trial;

/// Probability that the best setting tried is the best of those tried, as a sentence. Requires
/// `found.best`.
std::string chance_sentence(const Optimum& found);
/// Sentences on the validity of the best setting's runs and the result of the check; empty if they
/// are valid.
std::vector<std::string> validity_sentences(const Optimum& found);
/// Sentences on the certainty of the result.
std::vector<std::string> sentences(const Optimum& found);

std::string optimum_table(const Optimum& found);  ///< for the terminal
std::string optimum_csv(const Optimum& found);    ///< settings.csv (docs/formats.md)
/// A self-contained page. `extra` (HTML) comes before the settings.
std::string optimum_page(const Optimum& found, std::string_view version,
                         std::string_view extra = "");
/// The plots of the page: history, then the quantity over each key.
std::vector<Plot> optimum_plots(const Optimum& found);

}  // namespace mahlwerk::report
