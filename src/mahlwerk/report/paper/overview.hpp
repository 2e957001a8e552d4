// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/report/paper/page.hpp"

// The claims of several sets of measured data side by side.
namespace mahlwerk::report {

/// One claim about measured values in the overview.
struct OverviewRow {
  std::string folder;  ///< name of the set
  std::string title;   ///< of the set
  std::string claim;   ///< what was measured
  std::string found;   ///< measured and predicted numbers
  std::string status;  ///< "verified", "quoted", "unverified"; empty without measured values
  Holds holds = Holds::undecided;
  double deviation = 0;  ///< [1] largest deviation of the band; NaN without measured values
};

/// The rows of one set, in the order of its claims.
std::vector<OverviewRow> overview_rows(const PaperResult& result, std::string_view folder);

std::string overview_markdown(const std::vector<OverviewRow>& rows);
std::string overview_csv(const std::vector<OverviewRow>& rows);
std::string overview_page(const std::vector<OverviewRow>& rows, std::string_view version);
/// "8 sets with a verdict; agrees in 7, ...; 2 within 10 %".
std::string overview_score(const std::vector<OverviewRow>& rows);

}  // namespace mahlwerk::report
