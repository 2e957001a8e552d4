// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/campaign/search/gaussian_process.hpp"

// Emulator of one outcome of runs: a Gaussian process of its mean over replicates
// (docs/theory/optimum.md).
namespace mahlwerk::campaign {

/// Replicates of one setting: their number, their mean, and the sum of squares about it.
struct SettingSample {
  DesignPoint point;
  double count = 0, mean = 0, squares = 0;
};
/// The sample of these values. Values that are not finite are left out.
SettingSample sample_of(DesignPoint point, const std::vector<double>& replicates);

/// A Gaussian process of (value - centre)/scale.
struct OutcomeModel {
  GaussianProcess process;
  double centre = 0, scale = 1;
  double noise = 0;  ///< variance of the mean of two replicates, in units of scale squared

  Posterior at(const DesignPoint& point) const;  ///< posterior of the value itself
};

/// The model with the most probable kernel. The scatter of replicates is pooled over the settings
/// (opt.9). Requires samples with a count above 0, at least one.
OutcomeModel outcome_model(const std::vector<SettingSample>& samples);

}  // namespace mahlwerk::campaign
