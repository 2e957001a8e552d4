// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/claims.hpp"
#include "mahlwerk/report/paper/paper.hpp"

// Rules that have files of their own; claims.cpp chooses among all. docs/papers.md states them.
namespace mahlwerk::report {

/// A claim with its campaign.
struct ClaimContext {
  const Claim& claim;
  const Campaign& campaign;
  std::string unit;  ///< of the quantity

  std::string text(double value, double ci95) const;
  /// The interval does not leave the range of the quantity.
  std::string text(const LinePoint& s) const;
  std::string key() const;  ///< `against` in words: "speed"
};

/// Curvature of a line or exponent of a power law, by its interval.
Verdict judge_law(const ClaimContext& c, const ClaimLine& line);

/// Whether the largest value of a line, within its interval, lies in a range of the key.
Verdict judge_maximum(const ClaimContext& c, const ClaimLine& line);

/// The band over all lines (keys that are assumed) against measured values.
Verdict judge_measured(ClaimContext c, std::vector<ClaimLine> lines, const Measurement& measured);

}  // namespace mahlwerk::report
