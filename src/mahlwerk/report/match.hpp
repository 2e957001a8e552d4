// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/optimum.hpp"

// Result of matching mill B to mill A: text for the terminal and page.
namespace mahlwerk::report {

struct MatchReport {
  std::string title_a, title_b, file_a, file_b;
  bool by_powder = false;                          ///< doses are per mass of powder, else powers
  observe::Estimate dose_a = {}, dose_b = {};      ///< [W/kg], or [W]
  observe::Estimate energy_a = {}, energy_b = {};  ///< [J] mean energy lost in a collision
  observe::IntervalEstimate dose = {}, half_power = {};  ///< mill B over mill A
  double overlap = unknown, spectral = unknown, distance = unknown, p_value = unknown;  ///< [1]
  bool within_scatter = false;
  std::vector<double> edges = {};                    ///< [J] bin edges, one more than shares
  std::vector<double> shares_a = {}, shares_b = {};  ///< [1] shares of the collision power by bin
  OptimumReport search = {};                         ///< the search that found the settings
  results::NoticeCounts notices = {};                ///< of the two mills
};

std::vector<std::string> sentences(const MatchReport& found);
std::string match_table(const MatchReport& found);  ///< for the terminal
std::string match_page(const MatchReport& found, std::string_view version);
Plot match_plot(const MatchReport& found);  ///< power spectra of both mills

}  // namespace mahlwerk::report
