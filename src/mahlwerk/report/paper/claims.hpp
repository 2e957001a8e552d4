// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <string_view>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/paper.hpp"

// Test of a paper's claims against campaigns just run. The rules are in docs/papers.md.
namespace mahlwerk::report {

enum class Holds { yes, partly, no, undecided };  ///< undecided: the runs do not decide it

struct Verdict {
  std::string finding;  ///< sentence with numbers from the campaign
  Holds holds = Holds::undecided;
  /// [1] Largest relative deviation of the predicted band from measured values; NaN without these.
  double deviation = std::numeric_limits<double>::quiet_NaN();
};

/// Tests a claim against the points of its campaign; `measured` holds the values of a claim of kind
/// `measured`.
Verdict judge(const Claim& claim, const Campaign& campaign, const Measurement* measured = nullptr);

std::string_view word(Holds holds);  ///< "yes", "partly", "no", "undecided"

}  // namespace mahlwerk::report
