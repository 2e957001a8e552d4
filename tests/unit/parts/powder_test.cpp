// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/parts/grinding/plots.hpp"
#include "mahlwerk/parts/kinetics/plots.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/methods.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "statement.hpp"
#include "unit/report/html.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::parts::powder_test {
namespace {

using grinding::capture_plot;
using grinding::captured_energy_plot;
using grinding::captured_grains_plot;
using grinding::density_plot;
using grinding::passing_plot;
using grinding::sizes_plot;
using grinding::surface_plot;
using kinetics::conversion_plot;
using kinetics::property_plot;
using namespace report;
using results::Outcome;
using tests::states;

/// The panels of the parts that show powder.
std::string powder_panels(const Outcome& outcome) {
  std::string text;
  for (const cases::Part* part : cases::parts_of(outcome.mill_case))
    if (part->name == "grinding" || part->name == "kinetics") text += part->panel(outcome);
  return text;
}

/// The fake outcome with 0.15 g of grains of 0.5 mm, with grinding and conversion.
Outcome ground_outcome(const std::vector<int>& hits = {100, 120, 140}) {
  Outcome o = results::fake_outcome(hits);
  o.mill_case.powder = cases::Powder{
      .material = "", .mass = 1.5e-4, .size = 5e-4, .density = 1200, .feed = {.size = 5e-4}};
  o.mill_case.capture = cases::Capture{.model = powder::Barrios{1000}, .energy_share = 0.25};
  cases::Grinding g;
  g.breakage = powder::VogelPeukert{0.1, 0.05};
  g.fragments = powder::AustinFragments{0.4, 0.8, 3};
  g.time = 60;
  g.smallest = 1e-6;
  o.mill_case.grinding = g;
  o.mill_case.kinetics = cases::Kinetics{.model = powder::DoseKinetics{.dose_constant = 1e6},
                                         .time = 60,
                                         .property = "amorphous content",
                                         .initial = 0,
                                         .final = 100};
  int index = 0;
  for (results::Replicate& r : o.replicates) results::grind(o.mill_case, r, index++);
  return ended(std::move(o));
}

double quantity(const Outcome& o, std::string_view name) {
  const auto list = results::summarise(o).quantities;
  return std::ranges::find(list, name, &results::Quantity::name)->value;
}

TEST(PowderReport, curves_of_sizes_end_in_the_numbers_of_the_summary) {
  const Outcome o = ground_outcome();
  const Plot sizes = sizes_plot(o);
  ASSERT_EQ(sizes.series.size(), 3U);
  const std::array<std::string_view, 3> names{"d90", "d50", "d10"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(sizes.series[i].name, label(names[i]));
    const double expected = quantity(o, names[i]);
    states(std::string(names[i]), 1e-6 * sizes.series[i].y.back(), expected, 1e-12 * expected,
           "summary; tolerance: a mean summed in another order");
    EXPECT_LT(sizes.series[i].y.back(), sizes.series[i].y.front()) << "it grinds";
  }
  const double surface = quantity(o, "specific_surface");
  states("specific surface", surface_plot(o).series.at(0).y.back(), surface, 1e-12 * surface,
         "summary");
  const double converted = quantity(o, "conversion");
  states("conversion", 0.01 * conversion_plot(o).series.at(0).y.back(), converted,
         1e-12 * converted, "summary");
}

TEST(PowderReport, passing_crosses_half_at_d50_and_density_holds_all_the_mass) {
  const Outcome o = ground_outcome({100});  // with one replicate D50 is exact, not a mean of three
  const Series milled = passing_plot(o).series.back();
  const double d50 = 1e6 * quantity(o, "d50");
  const auto above =
      static_cast<std::size_t>(std::ranges::lower_bound(milled.x, d50) - milled.x.begin());
  const double part =
      std::log(d50 / milled.x[above - 1]) / std::log(milled.x[above] / milled.x[above - 1]);
  states("finer than D50 (%)", std::lerp(milled.y[above - 1], milled.y[above], part), 50, 1e-9,
         "(siz.2): straight over the logarithm");
  states("finer than the coarsest (%)", milled.y.back(), 100, 1e-9, "mass is kept");
  for (const Series& density : density_plot(o).series) {
    double sum = 0;
    for (const double d : density.y) sum += d * std::log(2) / 6;
    states("area below the density at " + density.name, sum, 1, 1e-11,
           "(siz.1): classes of a sixth of an octave");
  }
}

TEST(PowderReport, catches_of_one_kind_of_pair_need_no_legend_and_shares_add_up) {
  const Outcome o = ground_outcome();
  ASSERT_EQ(capture_plot(o).series.size(), 1U);
  EXPECT_EQ(capture_plot(o).series[0].name, "");
  const Series energy = captured_energy_plot(o).series.at(0), grains = capture_plot(o).series.at(0);
  const double each = 1200 * std::numbers::pi / 6 * std::pow(5e-4, 3);
  const double joules = 1e-3;  // the axis is in mJ: the hard hits are of 4 mJ
  for (std::size_t i = 0; i < energy.x.size(); ++i) {
    const double expected = 0.25 * joules * energy.x[i] / (grains.y[i] * each) / 1000;
    states("J/g that captured grains receive", energy.y[i], expected, 1e-12 * expected,
           "energy_share E/(N m_1)");
  }
  for (const Series& share : captured_grains_plot(o).series) {
    double sum = 0;
    for (const double s : share.y) sum += s;
    states("shares " + share.name + " (%)", sum, 100, 1e-9, "all collisions");
    EXPECT_EQ(share.x.size(), share.y.size() + 1);
  }
}

TEST(PowderReport, begins_with_few_key_numbers_and_has_every_quantity_once_in_a_group) {
  const std::string html = report_page(ground_outcome(), "1");
  const std::string_view results = std::string_view(html).substr(html.find("<h2>Results</h2>"));
  const std::string_view key = results.substr(0, results.find("<details"));
  std::size_t rows = 0;
  for (std::size_t at = 0; (at = key.find("<th scope=\"row\">", at)) != key.npos; ++at) ++rows;
  EXPECT_GE(rows, 5U);
  EXPECT_LE(rows, 13U) << "they fit on a screen";
  for (const results::Quantity& q : results::summarise(ground_outcome()).quantities) {
    const std::string cell = "data-quantity=\"" + q.name + "\"";
    const std::size_t first = html.find(cell);
    EXPECT_TRUE(first == html.npos || html.find(cell, first + 1) == html.npos) << q.name;
  }
}

TEST(PowderReport, sections_are_there_for_what_the_case_asks_and_no_other) {
  const std::string all = report_page(ground_outcome(), "1");
  for (const char* part : {"<h2>Powder captured by collisions", "<h2>Fineness", "<h2>Dose", ">D90<",
                           "the grains receive 25 % of it", "amorphous content"})
    EXPECT_TRUE(has(all, part)) << part;
  EXPECT_FALSE(has(all, "nan"));
  EXPECT_FALSE(has(all, "d90 "));
  EXPECT_EQ(powder_panels(results::fake_outcome()), "");
  Outcome caught = ground_outcome();
  caught.mill_case.grinding.reset();
  caught.mill_case.kinetics.reset();
  const std::string part = powder_panels(ended(caught));
  EXPECT_TRUE(has(part, "Powder captured by collisions"));
  EXPECT_FALSE(has(part, "Fineness"));
  EXPECT_FALSE(has(part, "Dose"));
  Outcome nothing = ground_outcome();
  for (results::Replicate& r : nothing.replicates) r.grinding.reset();
  EXPECT_EQ(powder_panels(ended(nothing)), "");
}

TEST(PowderReport, says_where_grains_get_more_than_the_mill_gives_off) {
  Outcome o = ground_outcome();
  const double gets = 1.5e-4 * 1000 * quantity(o, "captured_dose_rate");
  const double share = 100 * gets / quantity(o, "dissipated_power");
  EXPECT_TRUE(
      has(powder_panels(o), fmt::format("That is {:.0f} % of the dissipated power", share)));
  // The normal energy is 2 mJ per hit on average, of which 1 mJ is lost: at most a half may be
  // given.
  EXPECT_FALSE(has(powder_panels(o), "more than the mill dissipates"));
  o.mill_case.capture->energy_share = 1;
  for (results::Replicate& r : o.replicates) results::grind(o.mill_case, r, 0);
  EXPECT_TRUE(has(powder_panels(ended(o)), "more than the mill dissipates"));
}

TEST(PowderReport, methods_name_models_and_numbers) {
  const std::string text = methods(ground_outcome(), "1");
  for (const char* part :
       {"barrios (fracture energy 1 kJ/kg)", "25 % of the energy of the normal motion",
        "vogel-peukert (f_mat 0.1 kg/J/m, x_w_min 0.05 J m/kg)",
        "austin (share 0.4, gamma 0.8, beta 3)", "60 s of milling by a population balance",
        "dose D of energy dissipated"})
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
  Outcome strong = ground_outcome();
  strong.mill_case.capture->model = powder::Barrios{0};  // strength from breakage model
  EXPECT_TRUE(has(methods(strong, "1"), "model barrios;"));
  EXPECT_FALSE(has(methods(results::fake_outcome(), "1"), "capture"));
}

TEST(PowderReport, methods_state_the_time_of_the_dose_and_the_assumed_numbers_of_wear_and_heat) {
  Outcome o = ground_outcome();
  EXPECT_TRUE(has(methods(o, "1"), "dissipated energy of 1 min of milling over the mass"));
  EXPECT_FALSE(has(methods(o, "1"), "Temperatures"));
  EXPECT_FALSE(has(methods(o, "1"), "Wear"));
  o.mill_case.heat.emplace();
  o.mill_case.parts.set(cases::Wear{.coefficient = 1e-3});
  o.mill_case.origins.push_back(
      {.key = "wear.coefficient", .value = "1e-3", .source = "default", .assumed = true});
  EXPECT_TRUE(has(methods(o, "1"), "Wear by Archard, with a coefficient of 0.001*."));
  EXPECT_TRUE(has(methods(o, "1"), "coefficients of 15 W/m2/K from the jar to air of 20 °C"))
      << methods(o, "1");
}

TEST(PowderReport, table_groups_rows_and_calls_them_by_their_names) {
  const auto list = results::summarise(ground_outcome()).quantities;
  const std::string text = table(list, 0.1);
  for (const char* line : {"\n\nFineness\n  D10 ", "\n  D50 ", "\n  D90 ",
                           "\n\nPowder captured by collisions\n  powder captured ",
                           "\n  amorphous content ", "\n\nPower and contacts\n  dissipated power "})
    EXPECT_TRUE(has(text, line)) << line << "\n" << text;
  EXPECT_EQ(readable(0.00243, NAN, "kg/s").text(), "2.430 g/s");
  EXPECT_EQ(readable(2.5e-10, NAN, "kg/s").text(), "900.0 µg/h");
}

TEST(PowderReport, campaigns_show_sizes_where_they_grind) {
  const auto campaign = [](Outcome (*outcome)(const std::vector<int>&)) {
    Campaign c{.title = "Speeds"};
    for (const int hits : {100, 200})
      add(c, {.number = c.points.size() + 1, .values = {fmt::format("{} rpm", hits)}},
          results::summarise(outcome({hits, hits + 10})).quantities);
    c.keys = campaign_keys({"mill.speed"}, c.points);
    return c;
  };
  const Campaign grinds = campaign(ground_outcome), flies = campaign(results::fake_outcome);
  const auto drawn = [](const Campaign& c, const std::string& title) {
    const auto all = pictures_in(campaign_page(c, "1"));
    return std::ranges::count_if(all, [&](const auto& one) {
      return one["title"] == title && one["series"][0].contains("low");  // with error bars
    });
  };
  for (const char* title : {"D50", "D90", "powder captured"}) {
    EXPECT_EQ(drawn(grinds, title), 1) << title;
    EXPECT_EQ(drawn(flies, title), 0) << title;
  }
  EXPECT_FALSE(has(campaign_page(flies, "1"), "D90"));
  EXPECT_TRUE(has(campaign_table(grinds), "D90"));
  EXPECT_FALSE(has(campaign_table(flies), "D90"));
}

class PowderFiles : public results::ScratchTest {};

TEST_F(PowderFiles, a_result_that_ground_may_be_replaced) {
  for (int run = 0; run < 2; ++run) {
    results::Folder folder(scratch() / "result", true);  // refuses what Mahlwerk did not write
    write(folder, ground_outcome(), "1", "", false);
    folder.commit();
    for (const char* name : {"capture.csv", "captured_grains.csv", "grinding.csv",
                             "size_distribution.csv", "conversion.csv"})
      EXPECT_TRUE(std::filesystem::exists(scratch() / "result" / name)) << name;
  }
}

}  // namespace
}  // namespace mahlwerk::parts::powder_test
