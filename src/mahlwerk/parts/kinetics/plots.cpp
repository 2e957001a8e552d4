// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/kinetics/plots.hpp"

#include <fmt/format.h>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/kinetics.hpp"

namespace mahlwerk::parts::kinetics {
namespace {

using report::column;
using report::largest;
using report::Mark;
using report::Multiple;
using report::multiple;
using report::time_unit;
using results::Table;

Plot over_time(const results::Outcome& outcome, std::string_view name, double factor) {
  const Table table = results::conversion(outcome);
  const Multiple unit = time_unit(largest(column(table, "time")));
  return {
      .title = "",
      .x = report::Axis{.label = fmt::format("time of milling ({})", unit.unit), .least = 0},
      .y = report::Axis{.label = ""},
      .series =
          {{"", column(table, "time", unit.factor), column(table, name, factor), {}, Mark::line}},
      .shape = 0.39};
}

}  // namespace

Plot conversion_plot(const results::Outcome& outcome) {
  const powder::AnyKinetics& model = *outcome.mill_case.kinetics->model;
  const bool by_dose = powder::name_of(model) == "dose";
  Plot plot = over_time(outcome, "conversion", 0.01);
  plot.title = by_dose ? "Conversion by dose" : "Conversion over time";
  plot.y.label = "conversion (%)";
  if (!powder::has_second_product(model)) return plot;
  plot.y.label = "share (%)";
  plot.series[0].name = "conversion";
  for (const auto& [name, words] :
       {std::pair{"yield", "first product"}, std::pair{"second_yield", "second product"}}) {
    plot.series.push_back(over_time(outcome, name, 0.01).series[0]);
    plot.series.back().name = words;
  }
  return plot;
}

Plot property_plot(const results::Outcome& outcome) {
  const cases::Kinetics& k = *outcome.mill_case.kinetics;
  const bool by_dose = powder::name_of(*k.model) == "dose";
  Plot plot = over_time(outcome, "property", 1);
  plot.title = k.property + (by_dose ? " by dose" : " over time");
  plot.y.label = k.property;
  return plot;
}

}  // namespace mahlwerk::parts::kinetics
