// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
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
};

/// Tests a claim against the points of its campaign.
Verdict judge(const Claim& claim, const Campaign& campaign);

std::string_view word(Holds holds);  ///< "yes", "partly", "no", "undecided"

}  // namespace mahlwerk::report
