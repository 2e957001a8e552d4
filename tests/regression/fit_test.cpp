// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The command `fit`: parameters of a case from measurements.
#include <array>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "program.hpp"

namespace mahlwerk::tests::fit_test {
namespace {

/// The true value with which the data are generated.
constexpr double true_f_mat = 0.3;  // kg/J/m

class Fit : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("case.toml", mill + "x_w_min = \"0.01 J m/kg\"\n" + rest +
                           "\"breakage.f_mat\" = [\"0.001 kg/J/m\", \"10 kg/J/m\"]\n");
  }
  void write(const std::string& name, const std::string& said) const {
    std::ofstream(here_ / name) << said;
  }

  /// D50 and D90 [um] of a run with the true parameters at about that time [s].
  std::array<double, 2> sizes(const std::string& folder, double time) const {
    std::istringstream rows(text(folder + "/grinding.csv"));
    std::string row;
    std::getline(rows, row);
    std::array<double, 2> best{};
    double nearest = INFINITY;
    while (std::getline(rows, row)) {
      double t = 0, energy = 0, d10 = 0, d50 = 0, d90 = 0;
      std::sscanf(row.c_str(), "%lf,%lf,%lf,%lf,%lf", &t, &energy, &d10, &d50, &d90);
      if (std::abs(t - time) > nearest) continue;
      nearest = std::abs(t - time);
      best = {1e6 * d50, 1e6 * d90};
    }
    EXPECT_LT(nearest, 1e-9) << "a time that the run tells";
    return best;
  }

  /// Writes data.csv: synthetic measurements at two frequencies and four times, with noise of 3 %.
  void make_data(bool with_errors) const {
    constexpr double noise = 0.03;
    Random random(7, 0);
    const auto scattered = [&](double value) {
      const double size = std::sqrt(-2 * std::log(random.uniform()));
      return value * std::exp(noise * size * std::cos(random.uniform(0, 2 * std::numbers::pi)));
    };
    std::string table = "# made up\nmill.frequency (Hz),time (s),D50 (um),D90 (um)";
    table += with_errors ? ",D50_error (um),D90_error (um)\n" : "\n";
    for (const std::string hertz : {"16", "22"}) {
      const std::string set = "--set mill.frequency='" + hertz + " Hz' --out true" + hertz;
      const ProgramResult e = mahlwerk("run case.toml --quiet --set breakage.f_mat='" +
                                       std::to_string(true_f_mat) + " kg/J/m' " + set);
      ASSERT_EQ(e.code, 0) << e.output;
      for (const double time : {7.5, 15.0, 30.0, 60.0}) {
        const auto [d50, d90] = sizes("true" + hertz, time);
        char row[200];
        std::snprintf(row, sizeof row, "%s,%g,%.6g,%.6g", hertz.c_str(), time, scattered(d50),
                      scattered(d90));
        table += row;
        std::snprintf(row, sizeof row, ",%.6g,%.6g", noise * d50, noise * d90);
        table += with_errors ? std::string(row) + "\n" : "\n";
      }
    }
    write("data.csv", table);
  }

  /// The number after "word": in fit.json, searched from the position of `key`; NaN for null.
  double number(const std::string& key, const std::string& word) const {
    const std::string json = text("out/fit.json");
    auto at = json.find("\"" + key + "\"");
    at = json.find("\"" + word + "\": ", at);
    if (at == std::string::npos) return NAN;
    const std::string said = json.substr(at + word.size() + 4, 40);
    return said.starts_with("null") ? NAN : std::stod(said);
  }

  const std::string mill = R"(title = "Millet in a vibrating vial"
seed = 1
[mill]
kind = "vibration"
frequency = "19 Hz"
amplitude = "25 mm"
[jar]
kind = "capsule"
diameter = "12 mm"
volume = "5 ml"
[[balls]]
count = 1
diameter = "8 mm"
density = "7850 kg/m3"
[contact]
restitution = 0.9
tangential_restitution = 0.9
[run]
time = "5 s"
replicates = 3
[powder]
mass = "0.15 g"
density = "1280 kg/m3"
size = "1.34 mm"
[capture]
model = "trapped-volume"
thickness = "1.3 mm"
[breakage]
model = "vogel-peukert"
)";
  const std::string rest = R"([fragments]
model = "binary"
[grinding]
time = "60 s"
[fit]
)";
};

TEST_F(Fit, finds_what_data_were_made_with_within_its_interval) {
  for (const bool with_errors : {false, true}) {
    make_data(with_errors);
    const ProgramResult e = mahlwerk("fit case.toml data.csv --out out --force");
    ASSERT_EQ(e.code, 0) << e.output;
    const double low = number("breakage.f_mat", "low"), high = number("breakage.f_mat", "high");
    std::printf("    f_mat: made with %g, found %g, interval %g to %g\n", true_f_mat,
                number("breakage.f_mat", "value"), low, high);
    EXPECT_LT(low, true_f_mat);
    EXPECT_GT(high, true_f_mat);
    EXPECT_LT(high, 2 * low) << "and the interval says something";
    EXPECT_NE(e.output.find("16 values under 2 conditions, 15 degrees of freedom"),
              std::string::npos)
        << e.output;
    std::filesystem::remove_all(here_ / "true16");
    std::filesystem::remove_all(here_ / "true22");
  }
  EXPECT_NE(text("out/fit.json").find("\"errors_known\": true"), std::string::npos);
}

TEST_F(Fit, leaves_a_case_that_runs_a_table_and_a_page) {
  make_data(false);
  ASSERT_EQ(mahlwerk("fit case.toml data.csv --out out --quiet").output, "");
  for (const char* file : {"fit.json", "fit.csv", "fit.html", "fitted.toml"})
    EXPECT_TRUE(exists(std::string("out/") + file)) << file;
  EXPECT_TRUE(text("out/fit.csv").starts_with("line,condition,what,unit,time_s,"));
  EXPECT_EQ(text("out/fitted.toml").find("[fit]"), std::string::npos);
  EXPECT_NE(text("out/fitted.toml").find("# fitted to data.csv: "), std::string::npos);
  EXPECT_EQ(mahlwerk("run out/fitted.toml --out again --quiet").code, 0);
  EXPECT_EQ(mahlwerk("fit case.toml data.csv --out out --quiet").code, 2) << "it is there already";
  const std::string before = text("out/fit.json");
  EXPECT_EQ(mahlwerk("fit case.toml data.csv --out out --force --json --threads 2").output, before)
      << "the same, whatever the number of threads";
  EXPECT_EQ(text("out/fit.json"), before);
}

TEST_F(Fit, says_which_number_the_data_do_not_determine) {
  // The range of the least energy lies far below the energies of breaking hits: the data do not
  // depend on it.
  make_data(false);
  write("both.toml", mill + rest +
                         "\"breakage.f_mat\" = [\"0.001 kg/J/m\", \"10 kg/J/m\"]\n"
                         "\"breakage.x_w_min\" = [\"0 J m/kg\", \"0.002 J m/kg\"]\n");
  const ProgramResult e = mahlwerk("fit both.toml data.csv --out out");
  ASSERT_EQ(e.code, 0) << e.output;
  EXPECT_NE(e.output.find("NOT DETERMINED"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("breakage.x_w_min: any value of its range fits"), std::string::npos)
      << e.output;
  EXPECT_NE(text("out/fit.html").find("do not determine <code>breakage.x_w_min</code>"),
            std::string::npos);
  EXPECT_TRUE(std::isnan(number("breakage.x_w_min", "low")));
  EXPECT_TRUE(std::isnan(number("breakage.x_w_min", "high")));
  EXPECT_LT(number("breakage.f_mat", "low"), true_f_mat);
  EXPECT_GT(number("breakage.f_mat", "high"), true_f_mat);
}

TEST_F(Fit, a_number_given_on_the_command_line_is_held) {
  make_data(false);
  write("both.toml", mill + rest +
                         "\"breakage.f_mat\" = [\"0.001 kg/J/m\", \"10 kg/J/m\"]\n"
                         "\"breakage.x_w_min\" = [\"0 J m/kg\", \"1 J m/kg\"]\n");
  ASSERT_EQ(mahlwerk("fit both.toml data.csv --out out --quiet "
                     "--set breakage.x_w_min='0.01 J m/kg'")
                .code,
            0);
  const std::string held = text("out/fit.json");
  EXPECT_EQ(held.find("x_w_min"), std::string::npos);
  ASSERT_EQ(mahlwerk("fit case.toml data.csv --out out --force --quiet").code, 0);
  EXPECT_EQ(number("breakage.f_mat", "value"),
            std::stod(held.substr(held.find("\"value\": ") + 9, 30)));
}

TEST_F(Fit, refuses_what_it_cannot_fit) {
  write("data.csv", "D90 (um)\n900\n");
  expect_refused("fit case.toml nothing.csv --out out", "no such table of measurements");
  expect_refused("fit nothing.toml data.csv --out out", "no such file or folder");
  write("odd.csv", "mill.frequncy (Hz),D90 (um)\n16,900\n22,800\n");
  expect_refused("fit case.toml odd.csv --out out", "odd.csv, column mill.frequncy: unknown key");
  write("odd.csv", "D9O (um)\n900\n");
  expect_refused("fit case.toml odd.csv --out out", "did you mean \"D90 (um)\"?");
  write("odd.csv", "conversion\n0.5\n");
  expect_refused("fit case.toml odd.csv --out out", "the case has no [kinetics]");
  expect_refused("fit case.toml data.csv --out out --set breakage.f_mat='1 kg/J/m'",
                 "has no free parameter");
  write("swept.toml", text("case.toml") + "[sweep]\n\"mill.frequency\" = [\"9 Hz\", \"10 Hz\"]\n");
  expect_refused("fit swept.toml data.csv --out out", "fit takes a single case");
  expect_refused("fit . data.csv --set mill.frequency='0 Hz' --out out", "mill.frequency");
}

}  // namespace
}  // namespace mahlwerk::tests::fit_test
