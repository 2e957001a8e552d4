// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How much each key matters, where a campaign's design was made to tell.
#include <cmath>

#include "campaign_folder.hpp"
#include "mahlwerk/campaign/sweep/sensitivity.hpp"

namespace mahlwerk::app {
namespace {

using report::Effect;
using report::Sensitivity;

/// Half the width of an interval, which need not lie evenly about its value.
double half(const campaign::Sure& sure) {
  return 0.5 * (sure.high - sure.low);
}

/// What the keys do to one column of the campaign.
class Answer {
 public:
  Answer(const report::Campaign& campaign, const cases::Sweep& sweep,
         const campaign::Places& design, std::size_t column)
      : sweep_(sweep), design_(design) {
    for (const report::Point& point : campaign.points) {
      const auto at = [&](const std::vector<double>& list) {
        return column < list.size() ? list[column] : NAN;
      };
      outcomes_.push_back(at(point.value));
      widths_.push_back(at(point.ci95));
    }
    said_.quantity = campaign.columns[column].name;
    said_.unit = campaign.columns[column].unit;
  }

  Sensitivity said() {
    for (const cases::SweptKey& key : sweep_.keys)
      said_.effects.push_back(
          {.key = key.key, .low_end = key.values[0], .high_end = key.values[1]});
    if (sweep_.design == cases::Design::one_at_a_time)
      one_at_a_time();
    else if (sweep_.design == cases::Design::morris)
      morris();
    else
      sobol();
    return std::move(said_);
  }

 private:
  void one_at_a_time() {
    const campaign::Swings found = campaign::swings(outcomes_, widths_);
    said_.method = report::Method::one_at_a_time;
    said_.base = found.base.value;
    said_.base_ci95 = half(found.base);
    for (std::size_t k = 0; k < said_.effects.size(); ++k) {
      Effect& effect = said_.effects[k];
      effect.low = found.keys[k].at_low.value;
      effect.low_ci95 = half(found.keys[k].at_low);
      effect.high = found.keys[k].at_high.value;
      effect.high_ci95 = half(found.keys[k].at_high);
    }
  }
  void morris() {
    const campaign::ElementaryEffects found =
        campaign::elementary_effects(design_, outcomes_, errors());
    said_.method = report::Method::morris;
    say_mean();
    for (std::size_t k = 0; k < said_.effects.size(); ++k) {
      Effect& effect = said_.effects[k];
      const campaign::Effects& of = found.keys[k];
      effect.mean_absolute = of.mean_size.value;
      effect.mean_absolute_ci95 = half(of.mean_size);
      effect.mean = of.mean.value;
      effect.mean_ci95 = half(of.mean);
      effect.deviation = of.spread.value;
      effect.deviation_ci95 = half(of.spread);
    }
  }
  void sobol() {
    const campaign::VarianceShares found =
        campaign::variance_shares(sweep_.keys.size(), outcomes_, errors());
    said_.method = report::Method::sobol;
    say_mean();
    for (std::size_t k = 0; k < said_.effects.size(); ++k) {
      Effect& effect = said_.effects[k];
      effect.first_order = found.keys[k].first.value;
      effect.first_order_ci95 = half(found.keys[k].first);
      effect.total = found.keys[k].total.value;
      effect.total_ci95 = half(found.keys[k].total);
    }
  }

  void say_mean() {
    const results::Quantity mean = [&] {
      results::Quantity q;
      results::combine(q, outcomes_);
      return q;
    }();
    said_.base = mean.value;
    said_.base_ci95 = mean.ci95;
  }
  /// Standard errors; none where intervals are missing.
  std::vector<double> errors() const {
    constexpr double widths = 1.96;  // of a normal law
    std::vector<double> list;
    for (const double width : widths_) {
      if (!std::isfinite(width)) return {};
      list.push_back(width / widths);
    }
    return list;
  }

  const cases::Sweep& sweep_;
  const campaign::Places& design_;
  std::vector<double> outcomes_, widths_;
  Sensitivity said_;
};

}  // namespace

void add_sensitivities(report::Campaign& campaign, const cases::Sweep& sweep,
                       const campaign::Places& design) {
  using cases::Design;
  const bool made_for_it = sweep.design == Design::one_at_a_time ||
                           sweep.design == Design::morris || sweep.design == Design::sobol_indices;
  if (!made_for_it || design.size() != campaign.points.size()) return;
  for (const std::string& name : report::compared_quantities(campaign)) {
    const auto column = std::ranges::find(campaign.columns, name, &report::Column::name);
    const auto at = static_cast<std::size_t>(column - campaign.columns.begin());
    campaign.sensitivities.push_back(Answer(campaign, sweep, design, at).said());
  }
}

}  // namespace mahlwerk::app
