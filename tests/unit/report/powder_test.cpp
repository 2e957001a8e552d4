// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/powder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/campaign.hpp"
#include "mahlwerk/report/methods.hpp"
#include "mahlwerk/report/powder_plots.hpp"
#include "mahlwerk/report/readable.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/grinding.hpp"
#include "statement.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report {
namespace {

using results::Outcome;

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// The fake outcome with 0.15 g of grains of 0.5 mm in it, which grind and convert.
Outcome ground_outcome(const std::vector<int>& hits = {100, 120, 140}) {
  Outcome o = results::fake_outcome(hits);
  o.what.powder = cases::Powder{
      .material = "", .mass = 1.5e-4, .size = 5e-4, .density = 1200, .feed = {.size = 5e-4}};
  o.what.capture = cases::Capture{.model = powder::Barrios{1000}, .energy_share = 0.25};
  cases::Grinding g;
  g.breakage = powder::VogelPeukert{0.1, 0.05};
  g.fragments = powder::AustinFragments{0.4, 0.8, 3};
  g.time = 60;
  g.smallest = 1e-6;
  o.what.grinding = g;
  o.what.kinetics = cases::Kinetics{.conversion = {.dose_constant = 1e6},
                                    .time = 60,
                                    .property = "amorphous content",
                                    .initial = 0,
                                    .final = 100};
  int index = 0;
  for (results::Replicate& r : o.replicates) results::grind(o.what, r, index++);
  return o;
}

double quantity(const Outcome& o, std::string_view name) {
  const auto list = results::summarise(o);
  return std::ranges::find(list, name, &results::Quantity::name)->value;
}

TEST(PowderReport, CurvesEndInTheNumbersOfTheSummary) {
  const Outcome o = ground_outcome();
  const Plot sizes = sizes_plot(o);
  ASSERT_EQ(sizes.series.size(), 3U);
  const char* source = "both from results::summarise and results::grinding of one outcome";
  for (std::size_t i = 0; i < 3; ++i)
    MAHLWERK_EXPECT_NEAR("curve_ends_in_summary", 1e-6 * sizes.series[i].y.back(),
                         quantity(o, std::array{"d90", "d50", "d10"}[i]), 1e-12, source);
}

}  // namespace
}  // namespace mahlwerk::report
