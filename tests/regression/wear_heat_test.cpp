// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Wear and heat, from the case file to the numbers and tables of the result.
#include <cmath>
#include <numbers>
#include <vector>

#include "mahlwerk/powder/heat.hpp"
#include "program.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::wear_heat_test {
namespace {

constexpr const char* mill = R"toml(
title = "Wears and warms"
[mill]
kind = "vibration"
frequency = "20 Hz"
amplitude = "10 mm"
[jar]
kind = "cylinder"
diameter = "40 mm"
height = "30 mm"
density = "7700 kg/m3"
hardness = 600
heat_capacity = "500 J/kg/K"
conductivity = "20 W/m/K"
wall = "4 mm"
[[balls]]
count = 6
diameter = "8 mm"
density = "7850 kg/m3"
hardness = 700
heat_capacity = "460 J/kg/K"
conductivity = "30 W/m/K"
[powder]
mass = "2 g"
[contact]
restitution = 0.7
friction = 0.3
[run]
engine = "event"
time = "1 s"
settle = "0.2 s"
replicates = 2
)toml";
constexpr const char* wear = "[wear]\ncoefficient = 3e-4\n";
constexpr const char* heat = R"toml([heat]
ambient = "22 degC"
milling = "10 min"
pause = "5 min"
cycles = 3
cooling = "12 W/m2/K"
ball_exchange = "60 W/m2/K"
share_in_balls = 0.4
)toml";

class WearAndHeat : public ProgramTest {
 protected:
  void run(const std::string& more) const {
    std::ofstream(here_ / "case.toml") << mill << more;
    const ProgramResult e = mahlwerk("run case.toml --out out --quiet --force");
    ASSERT_EQ(e.code, 0) << e.output;
  }
  bool has(const std::string& quantity) const {
    return text("out/summary.json").find("\"" + quantity + "\": {") != std::string::npos;
  }
  double value(const std::string& quantity) const {
    const std::string all = text("out/summary.json");
    const auto at = all.find("\"" + quantity + "\": {");
    if (at == std::string::npos) throw std::out_of_range(quantity);
    return std::stod(all.substr(all.find(':', all.find("\"value\"", at)) + 1));
  }
  /// Numbers of a table, row by row; cells that are not numbers are 0.
  std::vector<std::vector<double>> rows(const std::string& file) const {
    std::istringstream lines(text("out/" + file));
    std::vector<std::vector<double>> found;
    std::string line, cell;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream cells(line);
      found.emplace_back();
      while (std::getline(cells, cell, ',')) found.back().push_back(std::atof(cell.c_str()));
    }
    return found;
  }
};

TEST_F(WearAndHeat, temperatures_are_those_of_the_power_in_the_summary) {
  run(heat);
  const double pi = std::numbers::pi, facet = 2 * pi / 96, r = 0.02, h = 0.03;
  const double wall = 96 * (2 * r * std::sin(facet / 2) * h + r * r * std::sin(facet));
  const powder::HeatNodes nodes{.balls_capacity = 6 * pi / 6 * std::pow(0.008, 3) * 7850 * 460,
                                .jar_capacity = wall * 0.004 * 7700 * 500,
                                .exchange = 60 * 6 * pi * 0.008 * 0.008,
                                .cooling = 12 * wall};
  const double power = value("dissipated_power"), air = 273.15 + 22;
  const powder::Heating on{0.4 * power, 0.6 * power};
  powder::Temperatures t{air, air}, last = t;
  for (int cycle = 0; cycle < 3; ++cycle) {
    last = powder::temperatures_after(nodes, on, air, t, 600);
    t = powder::temperatures_after(nodes, {}, air, last, 300);
  }
  EXPECT_GT(last.jar - air, 0.1) << "it warms";
  const std::string why = "hea.1 to hea.4, by hand from the case; rounding of 300 K over 6 phases";
  states("balls at the end of milling [degC]", value("temperature_balls"), last.balls - 273.15,
         1e-9, why);
  states("jar at the end of milling [degC]", value("temperature_jar"), last.jar - 273.15, 1e-9,
         why);
  const auto curve = rows("temperature.csv");
  ASSERT_GT(curve.size(), 100U);
  const std::string table = "temperature.csv, its last row";
  states("time [s]", curve.back()[0], 3 * 900, 1e-9, table);
  states("balls [degC]", curve.back()[1], t.balls - 273.15, 1e-9, table);
  states("jar [degC]", curve.back()[2], t.jar - 273.15, 1e-9, table);
  EXPECT_GT(value("flash_rise_mean"), 0);
  EXPECT_FALSE(has("wear_rate_jar"));
}

TEST_F(WearAndHeat, wear_is_that_of_the_losses_across) {
  run(wear);
  double jar = 0, balls = 0, lost_with_jar = 0, lost_between = 0;
  for (const auto& row : rows("wear.csv"))
    (row == rows("wear.csv").front() ? balls : jar) += row[2];
  states("faces over wear_rate_jar", jar / value("wear_rate_jar"), 1, 1e-12, "sum of wear.csv");
  states("set over wear_rate_balls", balls / value("wear_rate_balls"), 1, 1e-12, "wear.csv");
  // The spectrum contains the loss across the normal. A collision of two balls wears both.
  std::istringstream pairs(text("out/spectra_by_pair.csv"));
  std::string line;
  std::getline(pairs, line);
  EXPECT_TRUE(line.ends_with(",power_lost_tangential_W")) << line;
  while (std::getline(pairs, line)) {
    const double lost = std::stod(line.substr(line.rfind(',') + 1));
    (line.starts_with("balls.1,balls.1,") || line.starts_with("balls,balls,") ? lost_between
                                                                              : lost_with_jar) +=
        lost;
  }
  EXPECT_GT(lost_between, 0);
  const auto mass = [](double lost, double vickers, double density) {
    return 3e-4 * (lost / 0.3) / (9.80665e6 * vickers) * density;
  };
  const std::string why = "K W_t/(mu H) rho: wea.1 to wea.3";
  states("wear_rate_jar over that of the spectrum",
         value("wear_rate_jar") / mass(lost_with_jar, 600, 7700), 1, 1e-12, why);
  const double of_balls = mass(lost_with_jar + 2 * lost_between, 700, 7850);
  states("wear_rate_balls over that of the spectrum", value("wear_rate_balls") / of_balls, 1, 1e-12,
         why);
  states("contamination over worn mass by powder and hour",
         value("contamination_rate") /
             ((value("wear_rate_jar") + value("wear_rate_balls")) / 0.002 * 1e6 * 3600),
         1, 1e-12, "wea.7");
  EXPECT_FALSE(has("temperature_jar"));
  EXPECT_FALSE(exists("out/temperature.csv"));
}

TEST_F(WearAndHeat, are_told_to_who_asks_for_them_alone) {
  run("");
  for (const char* quantity : {"wear_rate_jar", "wear_rate_balls", "contamination_rate",
                               "temperature_balls", "temperature_jar", "flash_rise_mean"})
    EXPECT_FALSE(has(quantity)) << quantity;
  for (const char* file : {"out/wear.csv", "out/temperature.csv"})
    EXPECT_FALSE(exists(file)) << file;
  const double power = value("dissipated_power");
  run(std::string(wear) + heat);
  for (const char* quantity : {"wear_rate_jar", "wear_rate_balls", "contamination_rate",
                               "temperature_balls", "temperature_jar", "flash_rise_mean"})
    EXPECT_TRUE(has(quantity)) << quantity;
  for (const char* file : {"out/wear.csv", "out/temperature.csv"})
    EXPECT_TRUE(exists(file)) << file;
  EXPECT_EQ(value("dissipated_power"), power) << "derived after the motion";
}

}  // namespace
}  // namespace mahlwerk::tests::wear_heat_test
