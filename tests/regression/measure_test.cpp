// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The commands `measure ...` as a user types them, on the recordings of examples/measure, whose
// true numbers stand in make_examples.py.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/results/files/json_value.hpp"
#include "program.hpp"

namespace mahlwerk::measure_test {
namespace {

using results::Json;

class Measure : public tests::ProgramTest {
 protected:
  static std::string recording(const std::string& name) { return example("measure/" + name); }

  /// The value with this key, or without one with this label, as mean and half-width.
  std::array<double, 2> measured(const std::string& words, const std::string& called) const {
    const tests::ProgramResult done = mahlwerk("measure " + words + " --json");
    EXPECT_EQ(done.code, 0) << words << "\n" << done.output;
    if (done.code != 0) return {};
    const Json json = Json::parse(done.output);
    for (const Json& one : std::get<Json::Array>(json.find("values")->value())) {
      const auto* key = std::get_if<std::string>(&one.find("key")->value());
      if ((key != nullptr && *key == called) ||
          std::get<std::string>(one.find("label")->value()) == called) {
        const auto number = [&](const char* name) {
          return std::get<double>(one.find(name)->value());
        };
        return {number("value"), 0.5 * (number("high") - number("low"))};
      }
    }
    ADD_FAILURE() << "no " << called << " in\n" << done.output;
    return {};
  }
  /// The interval holds the truth and is at most `width` of it.
  void expect_measured(const std::string& words, const std::string& called, double truth,
                       double width) const {
    const auto [value, half] = measured(words, called);
    EXPECT_LE(std::abs(value - truth), half) << called << " " << value << " +- " << half;
    EXPECT_LE(half, width * std::abs(truth)) << called;
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(here_ / name, std::ios::binary) << bytes;
  }
};

TEST_F(Measure, finds_the_true_numbers_of_the_recordings_of_the_examples) {
  const std::string film = "film " + recording("film-track.csv") +
                           " --mill 'MM 400' --fps 800 --distance '60 +- 0.3 mm'";
  expect_measured(film, "mill.frequency", 25, 1e-3);
  expect_measured(film, "mill.arm", 0.136, 0.01);
  expect_measured(film, "mill.swing", 3.9 * std::numbers::pi / 180, 0.01);
  const std::string pictures = "film " + recording("film.pgm") +
                               " --kind vibration --fps 400 --scale '0.5 +- 0.01 mm' --mark 13,19 "
                               "--window 16";
  expect_measured(pictures, "mill.frequency", 62.5, 1e-3);
  expect_measured(pictures, "mill.amplitude", 0.0035, 0.03);
  expect_measured("sound " + recording("mill.wav"), "impacts, if they come at random", 60, 0.3);
  const std::string power = "power " + recording("power-log.csv");
  expect_measured(power, "power_meter.idle_power", 120, 0.02);
  expect_measured(power, "power under load", 141, 0.02);
  const std::string jar = "jar " + recording("jar.csv") + " --shape capsule";
  expect_measured(jar, "jar.diameter", 0.0267, 0.01);
  expect_measured(jar, "jar.height", 0.0269, 0.01);
  expect_measured("drop " + recording("drop-heights.csv"), "contact.restitution", 0.62, 0.05);
  expect_measured("drop " + recording("drop.wav") + " --height '300 mm'", "contact.restitution",
                  0.62, 0.05);
}

TEST_F(Measure, knows_the_rate_of_frames_from_the_frequency_that_is_set) {
  const tests::ProgramResult done =
      mahlwerk("measure film " + recording("film-track.csv") +
               " --kind arc-shaker --frequency '25 Hz' --scale '0.25 mm'");
  EXPECT_EQ(done.code, 0);
  EXPECT_NE(done.output.find("the film has 799.99 frames per second"), std::string::npos)
      << done.output;
  EXPECT_NE(done.output.find("\"0.25 mm\" counts as exact"), std::string::npos);
}

TEST_F(Measure, writes_entries_that_the_catalogue_reads) {
  std::filesystem::copy(std::filesystem::path(MAHLWERK_HOME) / "catalogue", here_ / "catalogue",
                        std::filesystem::copy_options::recursive);
  ASSERT_EQ(
      mahlwerk("measure film " + recording("film-track.csv") +
               " --mill 'MM 400' --fps 800 --distance '60 mm' --entry catalogue/mills/mine.toml")
          .code,
      0);
  ASSERT_EQ(mahlwerk("measure jar " + recording("jar.csv") +
                     " --shape capsule --material ZrO2 --entry catalogue/jars/mine-jar.toml")
                .code,
            0);
  setenv("MAHLWERK_CATALOGUE", (here_ / "catalogue").c_str(), 1);
  const tests::ProgramResult mill = mahlwerk("describe mine"), jar = mahlwerk("describe mine-jar"),
                             check = mahlwerk(
                                 "estimate mine --jar mine-jar --balls 1x10mm "
                                 "--material ZrO2 --frequency 20Hz");
  unsetenv("MAHLWERK_CATALOGUE");
  EXPECT_NE(mill.output.find("measured: 13"), std::string::npos) << mill.output;
  EXPECT_EQ(mill.output.find("arc_amplitude"), std::string::npos)
      << "it follows from the measured arm and swing";
  EXPECT_NE(jar.output.find("diameter             26.697 mm"), std::string::npos) << jar.output;
  EXPECT_EQ(check.code, 0) << check.output;
  EXPECT_EQ(check.output.find("Assumed, because"), std::string::npos)
      << "measured values are not assumed: " << check.output;
  expect_refused("measure jar " + recording("jar.csv") +
                     " --shape capsule --entry catalogue/jars/mine-jar.toml",
                 "already exists");
}

TEST_F(Measure, writes_a_case_whose_draws_have_the_measured_mean_and_interval) {
  ASSERT_EQ(mahlwerk("measure film " + recording("film-track.csv") +
                     " --mill 'MM 400' --fps 800 --distance '60 +- 0.3 mm' --case " +
                     example("02-mixer-mill") + " --out out")
                .code,
            0);
  const std::string text = this->text("out/calibrated.toml");
  EXPECT_NE(text.find("arm = \"135.96 mm\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"mill.swing\" = [\"3."), std::string::npos);
  const tests::ProgramResult check = mahlwerk("check out/calibrated.toml --set run.time='0.1 s'");
  EXPECT_EQ(check.code, 0) << check.output;
}

TEST_F(Measure, says_by_runs_what_to_measure_next) {
  const tests::ProgramResult done =
      mahlwerk("measure drop " + recording("drop-heights.csv") + " --case " +
               example("02-mixer-mill") + " --set run.time='0.2 s' --set run.settle='0 s' --next");
  EXPECT_EQ(done.code, 0) << done.output;
  EXPECT_NE(done.output.find("wide because of"), std::string::npos) << done.output;
  EXPECT_NE(mahlwerk("measure power " + recording("power-log.csv"))
                .output.find("Next, measure contact.restitution"),
            std::string::npos);
}

TEST_F(Measure, gives_rows_that_fit_reads_and_fit_finds_the_efficiency_of_the_drive) {
  const std::string power = "measure power " + recording("power-log.csv") + " --data power.csv ";
  ASSERT_EQ(mahlwerk(power + "--set mill.frequency='18 Hz'").code, 0);
  ASSERT_EQ(mahlwerk(power + "--set mill.frequency='20 Hz'").code, 0);
  expect_refused(power, "other columns");
  EXPECT_EQ(text("power.csv").substr(0, 52),
            "mill.frequency,motor_power (W),motor_power_error (W)");
  write("case.toml",
        "[mill]\nkind = \"vibration\"\nfrequency = \"20 Hz\"\namplitude = \"7 mm\"\n[jar]\nkind = "
        "\"cylinder\"\ndiameter = \"60 mm\"\nheight = \"60 mm\"\n[[balls]]\ncount = 20\ndiameter = "
        "\"12 mm\"\nmaterial = \"steel-1.4034\"\n[contact]\nrestitution = 0.6\nfriction = 0.2\n"
        "[run]\nengine = \"event\"\ntime = \"0.5 s\"\nsettle = \"0.2 s\"\nreplicates = 2\n"
        "[power_meter]\nidle_power = \"119 W\"\n[fit]\n\"power_meter.efficiency\" = [0.02, 1]\n");
  const tests::ProgramResult fit = mahlwerk("fit case.toml power.csv --settings 6 --out out");
  EXPECT_EQ(fit.code, 0) << fit.output;
  EXPECT_NE(fit.output.find("power_meter.efficiency"), std::string::npos);
  const std::string calibrated = text("out/calibrated.toml");
  EXPECT_NE(calibrated.find("# calibrated to power.csv"), std::string::npos) << calibrated;
  EXPECT_EQ(calibrated.find("[uncertainty]"), std::string::npos)
      << "only keys of [mill] and [contact] are drawn";
}

TEST_F(Measure, refuses_what_is_no_measurement) {
  write("empty", "");
  write("garbage", std::string("\x01\x00\xff\x7f", 4));
  write("row.csv", "t (s),x (mm),y (mm)\n0,1,2\n");
  write("units.csv", "t (kg),x (mm),y (mm)\n0,1,2\n");
  write("cut.wav", "RIFF\x10");
  write("cut.pgm", "P5 64 64 255\nxxx");
  const std::array<const char*, 3> faults[] = {
      {"film --kind vibration", "empty", "the file is empty"},
      {"film --kind vibration", "garbage", "no text file"},
      {"film --kind vibration", "row.csv", "at least 12 are needed"},
      {"film --kind vibration", "units.csv", "is not a time"},
      {"film --kind vibration", "missing.csv", "no such file"},
      {"film --kind vibration --mark 3,3", "cut.pgm", "picture 1: it is cut off"},
      {"film --kind vibration", "cut.pgm", "first picture are not given"},
      {"film", "row.csv", "kind of the mill is not given"},
      {"sound", "empty", "the file is empty"},
      {"sound", "cut.wav", "no WAV file"},
      {"sound", "row.csv", "no WAV file"},
      {"power", "row.csv", "no column power"},
      {"power", "garbage", "no text file"},
      {"jar --shape capsule", "row.csv", "in place of t"},
      {"drop", "row.csv", "at least 2 are needed"},
      {"drop", ".", "this is a folder"},
      {"sound --next", "empty", "the file is empty"}};
  for (const auto& [words, file, because] : faults)
    expect_refused(std::string("measure ") + words + " " + file, because);
  expect_refused("measure", "film, sound, power, jar or drop");
  expect_refused("measure jar " + recording("jar.csv") + " --shape cylinder",
                 "one of them is wrong");
  expect_refused("measure film " + recording("film-track.csv") +
                     " --fps 800 --distance '60 mm' --mill 'MM 400' --case " +
                     example("03-planetary-mill") + " --out out",
                 "with the measured mill.arm");
  expect_refused("measure sound " + recording("mill.wav") + " --next", "no case is given");
}

}  // namespace
}  // namespace mahlwerk::measure_test
