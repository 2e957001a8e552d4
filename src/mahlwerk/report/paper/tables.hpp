// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "mahlwerk/report/paper/page.hpp"

// Tables of a paper (docs/papers.md).
namespace mahlwerk::report {

/// A table from the campaign just run.
MadeTable made_table(const PaperTable& table, const RunCampaign& run);

/// The same of kind `captured`: a row for each decade of energy, with both bounds, the grains at
/// each point, the rate of collisions, and the energy that a grain receives.
MadeTable captured_table(const PaperTable& table, const RunCampaign& run);

/// Whether all bins of energy of all pairs and points lie between the bounds.
Verdict judge_capture_bounds(const Claim& claim, const RunCampaign& run);

/// Whether the bounds are known for this case: Barrios' bed, and a cylinder.
bool has_capture_bounds(const cases::Case& mill_case);

/// Bounds of the number of captured grains, from the Hertz contact and the least and the greatest
/// deformation of a bed (cap.1, cap.5 to cap.8). The strength of the grains does not enter.
/// Computed apart from powder/capture and results/quantities/nips, to check them.
struct CaptureBounds {
  double low = 0, high = 0;  ///< [1] grains
};
/// Bounds for a collision of `energy` [J] > 0 of the pair `one` ("balls.1") with `other`
/// ("balls.2", "jar.side", "jar.bottom", "jar.top"); nullopt for other pairs.
std::optional<CaptureBounds> capture_bounds(const cases::Case& mill_case, std::string_view one,
                                            std::string_view other, double energy);

}  // namespace mahlwerk::report
