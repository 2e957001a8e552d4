// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// report.html of one outcome: results with intervals, plots, and origin of the inputs. Without
/// `film` it has no replay and is a seventh as large.
std::string report_page(const results::Outcome& outcome, std::string_view version,
                        bool film = true);

/// The result in a sentence: collision rate, energies and dissipated power.
std::string sentence(const results::Outcome& outcome);

/// Writes all files of a result: those of results::write and report.html. `below` is a prefix of
/// their paths.
void write(const results::Folder& folder, const results::Outcome& outcome, std::string_view version,
           std::string_view below = "", bool film = true);

}  // namespace mahlwerk::report
