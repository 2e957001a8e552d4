// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results::frames_test {
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

TEST(FrameTimes, begin_when_counting_does_and_end_with_it) {
  cases::Case mill_case;
  constexpr double settling = 0.5;
  mill_case.run.time = 0.3;
  EXPECT_EQ(FrameTimes(mill_case).next(), INFINITY);
  mill_case.observe.frames = 0.1;
  FrameTimes times(mill_case);
  EXPECT_EQ(times.next(), INFINITY);
  times.begin(settling);
  for (const double expected : {0.5, 0.6, 0.7, 0.8}) {
    EXPECT_NEAR(times.next(), expected, 1e-15);
    EXPECT_LE(times.next(), settling + mill_case.run.time);
    times.advance();
  }
  EXPECT_EQ(times.next(), INFINITY);
  mill_case.observe.frames = 1;  // longer than the run
  FrameTimes one(mill_case);
  one.begin(settling);
  one.advance();
  EXPECT_EQ(one.next(), INFINITY);
}

TEST_F(FramesTest, say_where_the_balls_and_the_jar_are) {
  FrameFiles frames(scratch() / frames_name(0),
                    fake_outcome().mill_case);  // shakes at 10 Hz, 25 mm
  const fs::path file = scratch() / "frames-1.xyz";
  frames.add(0.025, {ball(0.001), ball(0.5)});
  EXPECT_EQ(read(file),
            "2\nLattice=\"0.048 0 0 0 0.048 0 0 0 0.048\" Origin=\"-0.024 -0.024 -0.024\" "
            "pbc=\"F F F\" Properties=id:I:1:species:S:1:pos:R:3:radius:R:1:velo:R:3:"
            "angular_velocity:R:3 Time=0.025 axes=\"of the laboratory, origin at the centre of the "
            "jar\" jar_centre=\"0 0 0.025\" jar_x=\"1 0 0\" jar_y=\"0 1 0\" jar_z=\"0 0 1\"\n"
            "1 2 0.001 -0.002 0.003 0.004 1 2 3 10 -20 30.5\n"
            "2 2 0.5 -0.002 0.003 0.004 1 2 3 10 -20 30.5\n");
  frames.add(0.05, {ball(0.002)}, {{0.5, -1, 2}});  // written at once
  EXPECT_NE(read(file).find(":angular_velocity:R:3:forces:R:3 Time=0.05"), std::string::npos);
  EXPECT_TRUE(read(file).ends_with(" 10 -20 30.5 0.5 -1 2\n"));
}

TEST_F(FramesTest, of_a_drum_without_ends_have_its_period_along_the_axis) {
  cases::Case drum = fake_outcome().mill_case;
  drum.mill.motion = kinematics::Tumbling{1};
  drum.mill.jar_axis = {1, 0, 0};
  drum.jar.shape = geometry::PeriodicCylinder{0.03, 0.04};  // reaches to 25 mm
  FrameFiles frames(scratch() / "frames-1", drum);
  frames.add(0.1, {ball(0.001)});
  EXPECT_NE(read(scratch() / "frames-1.xyz")
                .find("Lattice=\"0.04 0 0 0 0.05 0 0 0 0.05\" Origin=\"-0.02 -0.025 -0.025\" "
                      "pbc=\"T F F\""),
            std::string::npos)
      << read(scratch() / "frames-1.xyz");
}

TEST_F(FramesTest, read_back_as_the_same_doubles) {
  FrameFiles frames(scratch() / "frames-1", fake_outcome().mill_case);
  const double odd = 1.0 / 3;
  frames.add(0.1 + 0.2, {ball(odd)});
  const std::string text = read(scratch() / "frames-1.xyz");
  EXPECT_NE(text.find("\n1 2 0.3333333333333333 "), std::string::npos) << text;
  EXPECT_NE(text.find(" Time=0.30000000000000004 "), std::string::npos) << text;
}

TEST_F(FramesTest, for_paraview_are_a_list_and_a_file_for_each_frame) {
  FrameFiles frames(scratch() / "frames-1", fake_outcome().mill_case);
  const auto list = [&] { return read(scratch() / "frames-1.pvd"); };
  const std::string begin =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<Collection>\n";
  const std::string end = "</Collection>\n</VTKFile>\n";
  EXPECT_EQ(list(), begin + end);
  frames.add(0.025, {ball(0.001), ball(0.5)});
  const std::string first =
      "<DataSet timestep=\"0.025\" part=\"0\" name=\"balls\" file=\"frames-1/balls-00000.vtp\"/>\n"
      "<DataSet timestep=\"0.025\" part=\"1\" name=\"jar\" file=\"frames-1/jar-00000.vtp\"/>\n";
  EXPECT_EQ(list(), begin + first + end);
  frames.add(0.05, {ball(0.002)});
  EXPECT_NE(list().find("timestep=\"0.05\" part=\"0\" name=\"balls\" "
                        "file=\"frames-1/balls-00001.vtp\""),
            std::string::npos);
  EXPECT_TRUE(list().ends_with(end));
  const std::string balls = read(scratch() / "frames-1" / "balls-00000.vtp");
  EXPECT_NE(balls.find("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">0.025<"),
            std::string::npos);
  EXPECT_NE(balls.find("NumberOfPoints=\"2\" NumberOfVerts=\"2\""), std::string::npos);
  // 16 as UInt64, 0.004 twice as Float64 (0x3f70624dd2f1a9fc), by the table of RFC 4648.
  EXPECT_NE(balls.find("Name=\"radius\" NumberOfComponents=\"1\" "
                       "format=\"binary\">EAAAAAAAAAD8qfHSTWJwP/yp8dJNYnA/<"),
            std::string::npos)
      << balls;
  // A vial that does not turn is drawn once.
  EXPECT_TRUE(fs::exists(scratch() / "frames-1" / "jar-00000.vtp"));
  EXPECT_FALSE(fs::exists(scratch() / "frames-1" / "jar-00001.vtp"));
}

TEST_F(FramesTest, are_written_as_the_case_asks) {
  cases::Case mill_case = fake_outcome().mill_case;
  mill_case.observe.frames_format = cases::FramesFormat::xyz;
  FrameFiles(scratch() / "a", mill_case).add(0, {ball(0)});
  mill_case.observe.frames_format = cases::FramesFormat::vtk;
  FrameFiles(scratch() / "b", mill_case).add(0, {ball(0)});
  EXPECT_TRUE(fs::exists(scratch() / "a.xyz"));
  EXPECT_FALSE(fs::exists(scratch() / "a.pvd"));
  EXPECT_FALSE(fs::exists(scratch() / "b.xyz"));
  EXPECT_TRUE(fs::exists(scratch() / "b.pvd"));
}

/// Size on disk of `folder` over the size that the program estimates.
double room(const fs::path& folder, const cases::Case& mill_case, bool forces) {
  fs::create_directory(folder);
  std::vector<scene::Ball> balls(static_cast<std::size_t>(mill_case.balls[0].count),
                                 ball(-1.0 / 3000));
  for (scene::Ball& b : balls) b.velocity = b.spin = {-1.0 / 3, 1.0 / 7, -1.0 / 70};
  FrameFiles files(folder / "frames-1", mill_case);
  const std::vector<Vec3> pushes(forces ? balls.size() : 0, {1.0 / 3, -1.0 / 7, 1.0 / 70});
  constexpr int frames = 10;
  for (int i = 0; i < frames; ++i) files.add(1.0 / 3, balls, pushes);
  double size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) size += static_cast<double>(entry.file_size());
  return size / frames / cases::frame_bytes(mill_case);
}

TEST_F(FramesTest, take_about_the_room_that_is_reckoned_with) {
  cases::Case mill_case = fake_outcome().mill_case;
  mill_case.balls[0].count = 100;
  mill_case.run.engine = cases::EngineName::event;
  mill_case.observe.frames_format = cases::FramesFormat::xyz;
  EXPECT_NEAR(room(scratch() / "xyz", mill_case, false), 1, 0.2);
  mill_case.jar.shape = geometry::Box{0.02, 0.02, 0.02};
  mill_case.observe.frames_format = cases::FramesFormat::vtk;
  EXPECT_NEAR(room(scratch() / "vtk", mill_case, false), 1, 0.2);
  mill_case.observe.frames_format = cases::FramesFormat::both;
  mill_case.run.engine = cases::EngineName::soft;
  EXPECT_NEAR(room(scratch() / "both", mill_case, true), 1, 0.2);
  mill_case.mill.motion = kinematics::Tumbling{5};  // about a transverse axis: a jar per frame
  mill_case.mill.jar_axis = {0, 0, 1};
  mill_case.observe.frames_format = cases::FramesFormat::vtk;
  int number = 0;
  geometry::LifterCylinder lifters;
  lifters.diameter = 0.2, lifters.height = 0.1, lifters.lifters = 30, lifters.lifter_height = 0.01;
  lifters.lifter_width = 0.01, lifters.lifter_face_angle = 1.5;
  geometry::Attritor stirrer;
  stirrer.diameter = 0.1, stirrer.height = 0.12, stirrer.shaft_diameter = 0.02;
  stirrer.shaft_clearance = 0.01, stirrer.arms = 4, stirrer.arm_diameter = 0.008;
  stirrer.arm_span = 0.08, stirrer.arm_clearance = 0.02, stirrer.arm_spacing = 0.02;
  for (const geometry::AnyShape& shape :
       {geometry::AnyShape(geometry::Sphere{0.02}),
        geometry::AnyShape(geometry::Capsule{0.02, 0.02}),
        geometry::AnyShape(geometry::Box{0.02, 0.02, 0.02}), geometry::AnyShape(lifters),
        geometry::AnyShape(stirrer)}) {
    mill_case.jar.shape = shape;
    EXPECT_NEAR(room(scratch() / std::to_string(++number), mill_case, true), 1, 0.25)
        << geometry::name_of(shape);
  }
}

TEST_F(FramesTest, say_when_they_cannot_be_written) {
  EXPECT_THROW(FrameFiles(scratch() / "no" / "folder", fake_outcome().mill_case), InputError);
  const std::vector<scene::Ball> balls{ball(0)};
  const std::vector<Vec3> none;
  const Frame frame{0, balls, none, {}, {}};
  XyzFrames full("/dev/full", geometry::Sphere{0.02});
  EXPECT_THROW(full.add(frame), InputError);
  VtkFrames gone(scratch() / "gone.pvd", {geometry::Sphere{0.02}, kinematics::Still{}, {}, {}},
                 true);
  fs::remove(scratch() / "gone");
  EXPECT_THROW(gone.add(frame), InputError);
}

TEST(Stopped, every_ball_is_a_row) {
  Replicate r(0.1);
  r.balls_at_stop = {ball(0.001), ball(NAN)};
  const Table table = balls_at_stop(r);
  EXPECT_EQ(csv(table).substr(csv(table).find('\n') + 1),
            "1,2,0.004,0.001,-0.002,0.003,1,2,3,10,-20,30.5\n"
            "2,2,0.004,,-0.002,0.003,1,2,3,10,-20,30.5\n");
  EXPECT_EQ(table.columns.size(), table.rows[0].size());
  EXPECT_EQ(stopped_name(4), "stopped-5");
}

}  // namespace
}  // namespace mahlwerk::results::frames_test
