// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Plots of papers: intervals, bands over free numbers, measured values, and their numbers as CSV.
#include "mahlwerk/report/paper/figure_plot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mahlwerk/report/paper/band.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report::figure_plot_test {
namespace {

struct Row {
  std::string x;
  std::string f_mat;
  double value, ci95;
};

/// Points over a frequency and a free number, with the quantity `name` in `unit`.
Campaign campaign(const std::string& name, const std::string& unit, const std::vector<Row>& rows) {
  Campaign c{.title = "c"};
  c.columns = {{name, unit, ""}, {"replicates", "1", ""}};
  for (const Row& row : rows)
    c.points.push_back({.number = c.points.size() + 1,
                        .values = {row.x, row.f_mat},
                        .value = {row.value, 5},
                        .ci95 = {row.ci95, NAN}});
  c.keys = campaign_keys({"mill.frequency", "breakage.f_mat"}, c.points);
  return c;
}

PaperFigure figure(const std::string& quantity) {
  PaperFigure made;
  made.number = "1";
  made.quantity = quantity;
  made.against = "mill.frequency";
  return made;
}

const Series& named(const Plot& plot, Mark mark) {
  const auto at = std::ranges::find(plot.series, mark, &Series::mark);
  if (at == plot.series.end()) throw std::out_of_range("no such series");
  return *at;
}

/// The cells of the rows of CSV with `kind`.
std::vector<std::vector<double>> rows(const std::string& csv, const std::string& kind) {
  std::vector<std::vector<double>> list;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("," + kind + ",");
    if (at == std::string::npos) continue;
    std::istringstream cells(line.substr(at + kind.size() + 2));
    std::vector<double>& row = list.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell.empty() ? NAN : std::stod(cell));
    row.resize(4, NAN);
  }
  return list;
}

TEST(FigurePlot, no_interval_leaves_the_range_of_its_quantity) {
  const std::vector<Row> points{{"10 Hz", "1", 0.23, 0.25}, {"20 Hz", "1", 0.9, 0.2}};
  const auto ends = [&](const char* quantity, const char* unit) {
    const FigurePlot made = figure_plot(figure(quantity), campaign(quantity, unit, points));
    const Series& s = named(made.plot, Mark::points);
    const auto csv = rows(made.csv, "mean");
    for (std::size_t i = 0; i < 2; ++i) {
      const Interval drawn = interval_at(s, i, made.plot.y);
      EXPECT_EQ(drawn.low, csv[i][2]);  // the multiple of the unit is 1
      EXPECT_EQ(drawn.high, csv[i][3]);
    }
    return csv;
  };
  const auto speed = ends("ball_speed_seen_from_carrier", "m/s");
  EXPECT_EQ(speed[0][2], 0);
  EXPECT_DOUBLE_EQ(speed[0][3], 0.48);
  EXPECT_DOUBLE_EQ(speed[1][3], 1.1);
  const auto share = ends("flight_share", "1");
  EXPECT_EQ(share[0][2], 0);
  EXPECT_EQ(share[1][3], 1);
  const auto torque = ends("shaft_torque", "m/s");  // on average the shaft drives the charge
  EXPECT_EQ(torque[0][2], 0);
  const auto imbalance = ends("power_imbalance", "1");  // signed
  EXPECT_DOUBLE_EQ(imbalance[0][2], 0.23 - 0.25);
}

TEST(FigurePlot, says_quantity_unit_number_of_replicates_and_law) {
  std::vector<Row> points;
  for (const double f : {10.0, 13.0, 16.0, 20.0, 25.0})
    points.push_back({fmt::format("{} Hz", f), "1", 1e-5 * f * f, 1e-5});
  PaperFigure drawn = figure("energy_contact_point_mean");
  drawn.law = LawForm::power;
  const FigurePlot made = figure_plot(drawn, campaign("energy_contact_point_mean", "J", points));
  EXPECT_EQ(made.plot.x.label, "vibration frequency, $f$ (Hz)");
  EXPECT_EQ(made.plot.y.label, "mean contact-point energy, $E_{c}$ (mJ)");
  EXPECT_EQ(named(made.plot, Mark::dots).name, "mean of 5 replicates, bars: 95 % interval");
  const std::string& law = named(made.plot, Mark::line).name;
  EXPECT_TRUE(law.starts_with("$E_{c}$ = ")) << law;
  EXPECT_NE(law.find("^{2}, $R$²"), std::string::npos) << law;
  EXPECT_TRUE(made.csv.starts_with(
      "series,kind,mill_frequency_Hz,energy_contact_point_mean_J,low_J,high_J\n"))
      << made.csv;
}

TEST(FigurePlot, of_several_lines_each_is_named_once_in_legend_and_csv) {
  std::vector<Row> points;
  for (const char* f_mat : {"1", "2"})
    for (const double f : {10.0, 13.0, 16.0, 20.0, 25.0})
      points.push_back({fmt::format("{} Hz", f), f_mat, f * f, 1});
  PaperFigure drawn = figure("collision_rate");
  const Campaign c = campaign("collision_rate", "1/s", points);
  const auto legend = [&] {
    std::vector<std::string> names;
    for (const Series& s : figure_plot(drawn, c).plot.series)
      if (!s.name.empty()) names.push_back(s.name);
    return names;
  };
  EXPECT_EQ(legend(),
            (std::vector<std::string>{"f mat 1", "f mat 2",
                                      "points: mean of 5 replicates, bars: 95 % interval"}));
  drawn.law = LawForm::power;
  const std::vector<std::string> names = legend();
  ASSERT_EQ(names.size(), 3U);
  EXPECT_TRUE(names[1].starts_with("f mat 2: $n$ = ")) << names[1];
  const std::string csv = figure_plot(drawn, c).csv;
  EXPECT_NE(csv.find("\nf mat 2,mean,10,100,99,101\n"), std::string::npos) << csv;
}

TEST(FigurePlot, the_csv_has_the_drawn_numbers) {
  const std::vector<Row> points{{"10 Hz", "1", 0.002, 0.0001}, {"20 Hz", "1", 0.003, 0.0002}};
  PaperFigure drawn = figure("energy_normal_mean");
  drawn.measured = {
      {"measured (X 1999)", {12, 18}, {0.0021, 0.0024}, {0.0005, 0.003}, {0.0001, 0.0002}}};
  const FigurePlot made = figure_plot(drawn, campaign("energy_normal_mean", "J", points));
  for (const auto& [mark, kind] :
       {std::pair{Mark::points, "mean"}, std::pair{Mark::squares, "measured"}}) {
    const Series& s = named(made.plot, mark);
    const auto csv = rows(made.csv, kind);
    ASSERT_EQ(csv.size(), s.x.size());
    for (std::size_t i = 0; i < csv.size(); ++i) {
      const Interval ends = interval_at(s, i, made.plot.y);
      EXPECT_EQ(csv[i][0], s.x[i]);
      EXPECT_DOUBLE_EQ(csv[i][1] / 1e-3, s.y[i]);  // drawn in mJ
      EXPECT_DOUBLE_EQ(csv[i][2] / 1e-3, ends.low);
      EXPECT_DOUBLE_EQ(csv[i][3] / 1e-3, ends.high);
    }
  }
  const auto measured = rows(made.csv, "measured");
  EXPECT_DOUBLE_EQ(measured[0][2], 0.0016);
  EXPECT_EQ(measured[1][2], 0) << "an energy is not negative";
  EXPECT_NE(svg(made.plot).find(">measured (X 1999)<"), std::string::npos);
}

const std::vector<Row> free_numbers{{"10 Hz", "1", 5, 1},   {"10 Hz", "2", 7, 2},
                                    {"10 Hz", "3", 2, 3},   {"20 Hz", "1", 8, 0.5},
                                    {"20 Hz", "2", 9, NAN}, {"20 Hz", "3", 8.5, 1}};

TEST(FigurePlot, a_band_holds_all_values_of_the_free_numbers_with_their_intervals) {
  PaperFigure drawn = figure("d90");
  drawn.band_over = {"breakage.f_mat"};
  drawn.nominal = {{"breakage.f_mat", "2"}};
  const Campaign c = campaign("d90", "m", free_numbers);
  const FigurePlot made = figure_plot(drawn, c);
  const auto band = rows(made.csv, "band");
  ASSERT_EQ(band.size(), 2U);
  // 2 - 3 is cut at 0, 7 + 2; 8 - 0.5, 8.5 + 1.
  EXPECT_EQ(band[0][2], 0);
  EXPECT_EQ(band[0][3], 9);
  EXPECT_EQ(band[1][2], 7.5);
  EXPECT_EQ(band[1][3], 9.5);
  const auto nominal = rows(made.csv, "mean");
  ASSERT_EQ(nominal.size(), 2U);
  EXPECT_EQ(nominal[0][1], 7);
  EXPECT_EQ(nominal[1][1], 9);
  EXPECT_EQ(named(made.plot, Mark::area).name, "all values of $f_{Mat}$, with 95 % intervals");
  drawn.nominal.clear();
  EXPECT_TRUE(rows(figure_plot(drawn, c).csv, "mean").empty());
}

TEST(FigurePlot, a_band_keeps_lines_of_other_keys_and_the_selected_points) {
  Campaign c = campaign("d90", "m", free_numbers);
  for (Point& p : c.points) p.values.emplace_back("steel");
  const std::size_t all = c.points.size();
  for (std::size_t i = 0; i < all; ++i) {
    c.points.push_back(c.points[i]);
    c.points.back().values.back() = "agate";
    c.points.back().value[0] += 100;
  }
  c.keys = campaign_keys({"mill.frequency", "breakage.f_mat", "jar.material"}, c.points);
  PaperFigure drawn = figure("d90");
  drawn.band_over = {"breakage.f_mat"};
  drawn.at = {{"breakage.f_mat", {"1", "2"}}};
  const std::vector<BandLine> bands = bands_along(drawn, c);
  ASSERT_EQ(bands.size(), 2U);
  EXPECT_EQ(bands[0].others, "material steel");
  EXPECT_EQ(bands[1].others, "material agate");
  EXPECT_EQ(bands[0].points[0].low, 4);  // without the third value, 2 - 3
  EXPECT_EQ(bands[1].points[0].low, 104);
}

TEST(FigurePlot, bands_over_keys_that_do_not_vary_are_faults) {
  cases::Case mill_case;
  mill_case.sweep.keys = {{.key = "mill.frequency", .values = {"10 Hz", "20 Hz"}},
                          {.key = "breakage.f_mat", .values = {"1", "2"}}};
  const auto codes = [&](const std::string& more) {
    const Paper paper = read_paper_text(
        "title = \"T\"\nsource = \"S\"\n[[figure]]\nnumber = \"1\"\ntitle = \"t\"\ncampaign = "
        "\"c\"\nquantity = \"d90\"\nagainst = \"mill.frequency\"\n" +
            more,
        "paper.toml");
    std::vector<std::string> list;
    for (const Fault& fault : band_faults(paper, {{"c", mill_case}})) {
      EXPECT_EQ(fault.where, "paper.toml:3");
      list.push_back(fault.code);
    }
    return list;
  };
  using Codes = std::vector<std::string>;
  const std::string sound = "band_over = [\"breakage.f_mat\"]\n";
  EXPECT_EQ(codes(sound + "nominal = { \"breakage.f_mat\" = 2 }\n"), Codes{});
  EXPECT_EQ(codes("band_over = [\"breakage.x\"]\n"), Codes{"paper-unknown-key"});
  EXPECT_EQ(codes("band_over = [\"mill.frequency\"]\n"), Codes{"paper-unknown-key"});
  EXPECT_EQ(codes(sound + "nominal = { \"mill.frequency\" = \"10 Hz\" }\n"),
            Codes{"paper-unknown-key"});
  EXPECT_EQ(codes(sound + "nominal = { \"breakage.f_mat\" = 3 }\n"), Codes{"paper-unknown-value"});
  EXPECT_THROW(codes("band_over = \"breakage.f_mat\"\n"), InputError);
  EXPECT_THROW(codes(sound + "nominal = 3\n"), InputError);
}

TEST(Readable, an_interval_that_leaves_the_range_is_written_by_its_ends) {
  const results::Range positive{.least = 0}, share{0, 1};
  EXPECT_EQ(readable_within(0.23, 0.25, "m/s", positive).text(), "0.23 (0 to 0.48) m/s");
  EXPECT_EQ(readable_within(0.23, 0.25, "m/s", {}).text(), "0.23 ± 0.25 m/s");
  EXPECT_EQ(readable_within(0.167, 0.077, "1", share).text(), "0.167 ± 0.077");
  EXPECT_EQ(readable_within(0.95, 0.12, "1", share).text(), "0.95 (0.83 to 1)");
  EXPECT_EQ(readable_within(2e-3, 3e-3, "J", positive).text(), "2.0 (0 to 5.0) mJ");
  EXPECT_EQ(readable_within(1e-5, 1.8e-4, "1", share).text(), "[0.1 (0 to 1.9)] × 10⁻⁴");
  EXPECT_EQ(readable_within(0.5, NAN, "1", share).text(), readable(0.5, NAN, "1").text());
}

}  // namespace
}  // namespace mahlwerk::report::figure_plot_test
