// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sensitivity analysis of campaigns with a sensitivity design.
#include <cmath>

#include "mahlwerk/campaign/sweep/sensitivity.hpp"
#include "mahlwerk/commands/campaigns/campaign_pages.hpp"
#include "mahlwerk/results/quantities/means.hpp"

namespace mahlwerk::commands {
namespace {

using report::Effect;
using report::Sensitivity;

/// Values or half-widths of a column at all points; NaN for missing ones.
std::vector<double> of_points(const report::Campaign& campaign, std::size_t column,
                              std::vector<double> report::Point::*list) {
  std::vector<double> numbers;
  for (const report::Point& point : campaign.points)
    numbers.push_back(column < (point.*list).size() ? (point.*list)[column] : NAN);
  return numbers;
}

std::size_t column_of(const report::Campaign& campaign, std::string_view name) {
  const auto column = std::ranges::find(campaign.columns, name, &report::Column::name);
  return static_cast<std::size_t>(column - campaign.columns.begin());
}

/// Effects of the keys on one column of the campaign.
class SensitivityAnalysis {
 public:
  SensitivityAnalysis(const report::Campaign& campaign, const cases::Sweep& sweep,
                      const campaign::DesignMatrix& design, std::size_t column)
      : sweep_(sweep),
        design_(design),
        outcomes_(of_points(campaign, column, &report::Point::value)),
        widths_(of_points(campaign, column, &report::Point::ci95)),
        replicates_(of_points(campaign, column_of(campaign, "replicates"), &report::Point::value)) {
    result_.quantity = campaign.columns[column].name;
    result_.unit = campaign.columns[column].unit;
  }

  Sensitivity result() {
    for (const cases::SweptKey& key : sweep_.keys)
      result_.effects.push_back(
          {.key = key.key, .low_end = key.values[0], .high_end = key.values[1]});
    if (sweep_.design == cases::Design::one_at_a_time)
      one_at_a_time();
    else if (sweep_.design == cases::Design::morris)
      morris();
    else
      sobol();
    return std::move(result_);
  }

 private:
  void one_at_a_time() {
    const campaign::Swings found = campaign::swings(outcomes_, widths_);
    result_.method = report::Method::one_at_a_time;
    result_.base = found.base;
    for (std::size_t k = 0; k < result_.effects.size(); ++k) {
      Effect& effect = result_.effects[k];
      effect.low = found.keys[k].at_low;
      effect.high = found.keys[k].at_high;
      effect.significant = found.keys[k].significant;
      effect.inactive = found.keys[k].inactive;
    }
  }
  void morris() {
    const campaign::ElementaryEffects found =
        campaign::elementary_effects(design_, outcomes_, errors());
    result_.method = report::Method::morris;
    set_mean();
    for (std::size_t k = 0; k < result_.effects.size(); ++k) {
      Effect& effect = result_.effects[k];
      const campaign::KeyEffects& of = found.keys[k];
      effect.mean_absolute = of.mean_absolute;
      effect.mean = of.mean;
      effect.deviation = of.deviation;
      effect.of_noise = of.of_noise;
      effect.count = of.count;
      effect.significant = of.significant;
      effect.inactive = of.inactive;
    }
  }
  void sobol() {
    const campaign::VarianceDecomposition found =
        campaign::variance_decomposition(sweep_.keys.size(), outcomes_, errors());
    result_.method = report::Method::sobol;
    result_.variance = found.variance;
    result_.noise = found.noise;
    set_mean();
    for (std::size_t k = 0; k < result_.effects.size(); ++k) {
      Effect& effect = result_.effects[k];
      const campaign::SobolIndices& of = found.keys[k];
      effect.first_order = of.first;
      effect.total = of.total;
      effect.count = of.count;
      effect.significant = of.significant;
      effect.inactive = of.inactive;
    }
  }

  void set_mean() {
    const results::Quantity mean = [&] {
      results::Quantity q;
      results::combine(q, outcomes_, results::Interval::of_mean);
      return q;
    }();
    result_.base = observe::IntervalEstimate::around(mean.value, mean.ci95);
  }
  std::vector<double> errors() const {
    return campaign::standard_errors(outcomes_, widths_, replicates_);
  }

  const cases::Sweep& sweep_;
  const campaign::DesignMatrix& design_;
  std::vector<double> outcomes_, widths_, replicates_;
  Sensitivity result_;
};

}  // namespace

void add_sensitivities(report::Campaign& campaign, const cases::Sweep& sweep,
                       const campaign::DesignMatrix& design) {
  using cases::Design;
  const bool made_for_it = sweep.design == Design::one_at_a_time ||
                           sweep.design == Design::morris || sweep.design == Design::sobol_indices;
  if (!made_for_it || design.size() != campaign.points.size()) return;
  for (const std::string& name : report::compared_quantities(campaign)) {
    const std::size_t column = column_of(campaign, name);
    campaign.sensitivities.push_back(SensitivityAnalysis(campaign, sweep, design, column).result());
  }
}

}  // namespace mahlwerk::commands
