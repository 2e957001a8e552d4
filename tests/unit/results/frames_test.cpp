// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/fields.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/tables.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results {
namespace {

namespace fs = std::filesystem;

class FramesTest : public ScratchTest {};

scene::Ball ball(double x) {
  return {.radius = 0.004,
          .density = 7850,
          .position = {x, -0.002, 0.003},
          .velocity = {1, 2, 3},
          .spin = {10, -20, 30.5},
          .kind = 1};
}

TEST(FrameTimes, BeginWhenCountingDoesAndEndWithIt) {
  cases::Case what;
  what.run.settle = 0.5;
  what.run.time = 0.3;
  EXPECT_EQ(FrameTimes(what).next(), INFINITY);
  what.observe.frames = 0.1;
  FrameTimes times(what);
  for (const double expected : {0.5, 0.6, 0.7, 0.8}) {
    EXPECT_NEAR(times.next(), expected, 1e-15);
    EXPECT_LE(times.next(), what.run.settle + what.run.time);
    times.go_on();
  }
  EXPECT_EQ(times.next(), INFINITY);
  what.observe.frames = 1;  // longer than the run
  FrameTimes one(what);
  one.go_on();
  EXPECT_EQ(one.next(), INFINITY);
}

TEST_F(FramesTest, SayWhereTheBallsAndTheJarAre) {
  const fs::path file = scratch() / frames_name(0);
  FrameFile frames(file, fake_outcome().what);  // shakes at 10 Hz, 25 mm
  frames.add(0.025, {ball(0.001), ball(0.5)});
  EXPECT_EQ(read(file),
            "2\nLattice=\"0.048 0 0 0 0.048 0 0 0 0.048\" Origin=\"-0.024 -0.024 -0.024\" "
            "pbc=\"F F F\" Properties=id:I:1:species:S:1:pos:R:3:radius:R:1:velo:R:3:"
            "angular_velocity:R:3 Time=0.025 axes=\"of the laboratory, origin at the centre of the "
            "jar\" jar_centre=\"0 0 0.025\" jar_x=\"1 0 0\" jar_y=\"0 1 0\" jar_z=\"0 0 1\"\n"
            "1 2 0.001 -0.002 0.003 0.004 1 2 3 10 -20 30.5\n"
            "2 2 0.5 -0.002 0.003 0.004 1 2 3 10 -20 30.5\n");
  frames.add(0.05, {ball(0.002)});  // there at once
  EXPECT_NE(read(file).find("Time=0.05"), std::string::npos);
}

TEST_F(FramesTest, TakeAboutTheRoomThatIsReckonedWith) {
  FrameFile frames(scratch() / "one.xyz", fake_outcome().what);
  std::vector<scene::Ball> balls(100, ball(-1.0 / 3000));
  for (scene::Ball& b : balls) b.velocity = b.spin = {-1.0 / 3, 1.0 / 7, -1.0 / 70};
  frames.add(1.0 / 3, balls);
  const auto size = static_cast<double>(fs::file_size(scratch() / "one.xyz"));
  EXPECT_NEAR(size, cases::frame_bytes + 100 * cases::ball_bytes, 0.2 * size);
}

TEST_F(FramesTest, SayWhenTheyCannotBeWritten) {
  EXPECT_THROW(FrameFile(scratch() / "no" / "folder.xyz", fake_outcome().what), InputError);
  FrameFile full("/dev/full", fake_outcome().what);
  EXPECT_THROW(full.add(0, {ball(0)}), InputError);
}

TEST(Stopped, EveryBallIsARow) {
  Replicate r(0.1);
  r.at_stop = {ball(0.001), ball(NAN)};
  const Table table = balls_at_stop(r);
  EXPECT_EQ(csv(table).substr(csv(table).find('\n') + 1),
            "1,2,0.004,0.001,-0.002,0.003,1,2,3,10,-20,30.5\n"
            "2,2,0.004,,-0.002,0.003,1,2,3,10,-20,30.5\n");
  EXPECT_EQ(table.columns.size(), table.rows[0].size());
  EXPECT_EQ(stopped_name(4), "stopped-5.csv");
}

}  // namespace
}  // namespace mahlwerk::results
