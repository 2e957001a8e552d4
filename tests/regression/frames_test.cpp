// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Output of a run for viewing: frames for replay, and the state of the balls when a physical fault
// stopped the run.
#include <algorithm>
#include <cmath>
#include <vector>

#include "program.hpp"

namespace mahlwerk::tests::frames_test {
namespace {

struct Frame {
  double time = NAN;
  std::string about;
  std::vector<std::vector<double>> balls;
};

/// Extended XYZ, read as a viewer does.
std::vector<Frame> frames(const std::string& text) {
  std::vector<Frame> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    Frame frame;
    const int count = std::stoi(line);
    std::getline(in, frame.about);
    const auto at = frame.about.find(" Time=");
    if (at != std::string::npos) frame.time = std::stod(frame.about.substr(at + 6));
    for (int i = 0; i < count && std::getline(in, line); ++i) {
      std::istringstream row(line);
      frame.balls.emplace_back();
      for (double x = 0; row >> x;) frame.balls.back().push_back(x);
    }
    all.push_back(std::move(frame));
  }
  return all;
}

class Frames : public ProgramTest {
 protected:
  std::string short_ = example("05-planetary-soft") +
                       " --quiet --set run.time=\"30 ms\" --set run.settle=\"5 ms\" --set "
                       "run.replicates=2 ";
};

TEST_F(Frames, are_as_many_as_asked_for_and_change_nothing) {
  for (const std::string engine : {"event", "soft"}) {
    const std::string words = "run " + short_ + "--set run.engine=" + engine + " --out " + engine;
    ASSERT_EQ(mahlwerk(words).code, 0);
    ASSERT_EQ(mahlwerk(words + "-frames --set observe.frames=\"0.7 ms\"").output, "");
    for (const char* file : {"/replicates.csv", "/timeseries.csv", "/spectrum.csv"}) {
      EXPECT_GT(text(engine + file).size(), 100U);
      EXPECT_EQ(text(engine + file), text(engine + "-frames" + file)) << file;
    }
    EXPECT_FALSE(exists(engine + "/frames-1.xyz"));
    const std::vector<Frame> read = frames(text(engine + "-frames/frames-2.xyz"));
    ASSERT_EQ(read.size(), 43U) << engine;
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_NEAR(read[i].time, 0.005 + 0.0007 * static_cast<double>(i), 1.1e-6);
      ASSERT_EQ(read[i].balls.size(), 5U);
      for (const std::vector<double>& b : read[i].balls) {
        ASSERT_EQ(b.size(), engine == "soft" ? 15U : 12U);  // forces
        EXPECT_EQ(b[5], 0.0075);
        EXPECT_LT(std::hypot(b[2], b[3]), 0.021 - 0.0075 + 1e-4);
      }
    }
  }
}

TEST_F(Frames, say_where_the_jar_is_and_move_as_the_balls_do) {
  ASSERT_EQ(mahlwerk("run " + short_ + "--out out --set observe.frames=\"10 us\"").code, 0);
  const std::vector<Frame> read = frames(text("out/frames-1.xyz"));
  ASSERT_EQ(read.size(), 3001U);
  for (const char* key : {"Lattice=\"", "pbc=\"F F F\"", "Properties=id:I:1:species:S:1:pos:R:3:",
                          "jar_centre=\"", "jar_x=\"", "axes=\""})
    EXPECT_NE(read[0].about.find(key), std::string::npos) << read[0].about;
  int fits = 0;  // at nearly all times only the jar's motion accelerates a ball
  for (std::size_t i = 1; i < read.size(); ++i) {
    const auto &a = read[i - 1].balls[0], &b = read[i].balls[0];
    const double dt = read[i].time - read[i - 1].time;
    fits += std::abs(b[2] - a[2] - 0.5 * (a[6] + b[6]) * dt) < 1e-7 ? 1 : 0;
  }
  EXPECT_GT(fits, 2800);
}

TEST_F(Frames, are_there_when_the_run_is_killed) {
  const ProgramResult e =
      mahlwerk("--version; '" MAHLWERK_PROGRAM "' run " + example("01-one-ball") +
               " --set run.time=\"100000 s\" --set observe.frames=\"1 s\" --set run.replicates=1 "
               "--out out & while kill -0 $! && [ $(cat .out.partial-*/frames-1.xyz 2> /dev/null | "
               "grep -c Lattice) -lt 12 ]; do sleep 0.02; done; kill -KILL $!; wait $!");
  std::string found;
  for (const auto& entry : std::filesystem::directory_iterator(here_))
    if (entry.is_directory()) found = (entry.path().filename() / "frames-1.xyz").string();
  EXPECT_GT(frames(text(found)).size(), 10U) << found << e.output;
}

TEST_F(Frames, too_many_are_refused_and_so_are_checkpoints) {
  expect_refused("run " + short_ + "--out out --set observe.frames=\"0.01 us\"", "too-many-frames");
  expect_refused("run " + short_ + "--out out --set observe.frames=\"1 ms\" --checkpoint 10",
                 "bad-checkpoint");
  expect_refused("run " + short_ + "--out out --set observe.frames=\"0 s\"", "frames");
}

TEST_F(Frames, a_run_that_physics_stops_leaves_its_balls) {
  const std::string wrong =
      "run " + short_ + "--out out --set contact.law=sjkr --set contact.cohesion=\"3e9 J/m3\" ";
  const ProgramResult e = mahlwerk(wrong + "--set observe.frames=\"0.1 ms\"");
  EXPECT_EQ(e.code, 3) << e.output;
  EXPECT_NE(e.output.find("became unstable"), std::string::npos) << e.output;
  EXPECT_NE(e.output.find("stopped-1.csv"), std::string::npos) << e.output;
  const std::string table = text("out/stopped-1.csv");
  EXPECT_TRUE(table.starts_with("ball,kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,")) << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 6);
  EXPECT_EQ(mahlwerk(wrong + "--force").code, 3) << "a result like others, and replaceable";
}

}  // namespace
}  // namespace mahlwerk::tests::frames_test
