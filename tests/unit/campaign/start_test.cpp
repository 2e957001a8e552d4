// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The balls at the start of a run: given motion, layers, settling at rest, and the end of another
// run.
#include "mahlwerk/campaign/run/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::start_test {
namespace {

using cases::sample::Folder;
using cases::sample::read_sample;
using tests::states;

class NobodyListens final : public scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

/// A case with one set of balls per entry of `balls`, which are keys of [[balls]].
std::string text(const std::string& mill, const std::vector<std::string>& balls,
                 const std::string& run, const std::string& jar = "200 mm") {
  std::string all = "title = \"Start\"\n[mill]\n" + mill +
                    "[jar]\nkind = \"cylinder\"\ndiameter = \"" + jar + "\"\nheight = \"" + jar +
                    "\"\n";
  for (const std::string& set : balls) all += "[[balls]]\ndensity = \"7800 kg/m3\"\n" + set;
  return all +
         "[contact]\nfriction = 0.3\nrestitution = 0.7\nsoftening = 0.001\n[run]\ntime = \"1 "
         "s\"\n" +
         run;
}
const std::string
    shaken = "kind = \"vibration\"\namplitude = \"5 mm\"\nfrequency = \"10 Hz\"\n",
    planetary = "kind = \"planetary\"\norbit_radius = \"70 mm\"\nspeed = \"200 rpm\"\nratio = -2\n",
    turning = "kind = \"tumbling\"\nspeed = \"30 rpm\"\n";
const std::string one_ball =
    "diameter = \"10 mm\"\npositions = [[\"10 mm\", \"20 mm\", \"0 mm\"]]\n";

std::vector<scene::Ball> start_of(const cases::Case& c, int replicate = 0) {
  return engine(c, replicate, 1, nullptr)->balls();
}

TEST(Start, given_velocities_and_spins_are_in_the_jars_axes_and_in_the_laboratory) {
  const std::string motion = one_ball +
                             "velocities = [[\"1 m/s\", \"2 m/s\", \"3 m/s\"]]\n"
                             "spins = [[\"4 rad/s\", \"5 rad/s\", \"6 rad/s\"]]\n";
  const auto drum = start_of(read_sample(text(turning, {motion}, "engine = \"event\"\n"))).front();
  const Rotation lying = scene::mounted_along({1, 0, 0});
  EXPECT_LE(norm(drum.velocity - lying * Vec3{1, 2, 3}), 1e-14) << "z is the drum's axis, x";
  EXPECT_LE(norm(drum.spin - lying * Vec3{4, 5, 6}), 1e-14);
  EXPECT_NEAR(drum.velocity.x, 3, 1e-14);
  const double jar = 2 * std::numbers::pi * 10 * 5e-3;  // [m/s] of the jar's centre at the start
  const auto in_laboratory =
      start_of(read_sample(text(shaken, {motion}, "engine = \"event\"\n"))).front();
  states("upward velocity relative to the jar [m/s]", in_laboratory.velocity.z, 3 - jar, 1e-12,
         "3 m/s in the laboratory");
  const auto in_jar = start_of(read_sample(text(shaken, {motion},
                                                "engine = \"event\"\n"
                                                "start_frame = \"jar\"\n")))
                          .front();
  states("the same with start_frame = \"jar\" [m/s]", in_jar.velocity.z, 3, 1e-12, "as given");
}

TEST(Start, settling_at_rest_is_a_fall_in_the_jar_at_rest) {
  const std::string motion = one_ball + "velocities = [[\"0.1 m/s\", \"0 m/s\", \"0 m/s\"]]\n";
  const double t = 0.1, g = 9.81, dt = 1e-4;
  for (const std::string engine_name : {"event", "soft"}) {
    const auto ball = start_of(read_sample(text(shaken, {motion},
                                                "engine = \"" + engine_name +
                                                    "\"\nsettle_at_rest = \"0.1 s\"\n")))
                          .front();
    const double jar = 2 * std::numbers::pi * 10 * 5e-3;
    // The soft engine ends at a whole step.
    const double off = engine_name == "soft" ? g * dt * t : 1e-12;
    states(engine_name + ": height [m]", ball.position.z, -0.5 * g * t * t, off, "-g t^2/2");
    states(engine_name + ": velocity relative to the jar that starts [m/s]", ball.velocity.z,
           -g * t - jar, g * off / (g * t) + 1e-12, "-g t in the laboratory");
    states(engine_name + ": across [m]", ball.position.x, 0.01 + 0.1 * t, 0.1 * dt, "0.1 m/s");
  }
}

TEST(Start, settling_at_rest_brings_a_charge_to_rest_in_the_lower_half_of_a_drum) {
  const cases::Case c = read_sample(text(turning, {"diameter = \"10 mm\"\ncount = 300\n"},
                                         "engine = \"soft\"\nsettle_at_rest = \"0.6 s\"\n"));
  double energy = 0, middle = 0;  // per mass and ball
  for (const scene::Ball& b : start_of(c))
    energy += 0.5 * squared(b.velocity) / 300, middle += b.position.z / 300;
  // 300 balls are 157 ml of 6.28 l: a heap on the lowest part of the wall.
  EXPECT_LT(energy, 0.01 * 9.81 * 0.1) << "a hundredth of that of a fall by the radius";
  EXPECT_LT(middle, -0.075) << "[m] middle of the charge";
}

TEST(Start, layers_lie_above_each_other_in_the_order_of_the_sets) {
  for (const std::string& mill : {turning, planetary}) {
    const cases::Case c = read_sample(
        text(mill,
             {"diameter = \"6 mm\"\ncount = 2000\n", "diameter = \"9 mm\"\ncount = 300\n",
              "diameter = \"5 mm\"\ncount = 1500\n"},
             "start = \"layers\"\nengine = \"soft\"\n"));
    std::array<double, 3> low{9, 9, 9}, high{-9, -9, -9};
    for (const scene::Ball& b : cases::starting_balls(c, 1)) {
      const auto set = static_cast<std::size_t>(b.kind);
      low[set] = std::min(low[set], b.position.z), high[set] = std::max(high[set], b.position.z);
    }
    EXPECT_LE(high[0], low[1]);
    EXPECT_LE(high[1], low[2]);
    EXPECT_LT(low[0], -0.08) << "the whole jar is used";
    EXPECT_GT(high[2], 0.08);
  }
}

/// A case that starts from the end of another; the state is written and read as a result does.
TEST(Start, a_run_from_the_end_of_another_moves_on_as_if_it_had_not_stopped) {
  for (const std::string& mill : {planetary, turning}) {
    const Folder folder;
    const std::string motion =
        one_ball + "velocities = [[\"0.3 m/s\", \"0.2 m/s\", \"0.1 m/s\"]]\n";
    const cases::Case first = read_sample(text(mill, {motion}, "engine = \"event\"\n"));
    const double stop = 0.03, more = 0.02;  // [s] in flight
    const auto whole = engine(first, 0, 1, nullptr);
    NobodyListens nobody;
    whole->advance(stop, nobody);
    results::Replicate end(0.1);
    end.balls_at_end = seen_from_carrier(first, whole->balls(), stop);
    folder.write("final-1.csv", results::csv(results::balls_at_end(end)));
    whole->advance(stop + more, nobody);
    EXPECT_EQ(whole->energy_balance().collisions, 0) << "else contacts would be compared";
    const cases::Case second = read_sample(text(
        mill, {"diameter = \"10 mm\"\n"},
        "engine = \"event\"\nreplicates = 1\nstart_from = \"" + folder.path().string() + "\"\n"));
    const auto rest = engine(second, 0, 1, nullptr);
    rest->advance(more, nobody);
    const scene::Ball a = seen_from_carrier(first, whole->balls(), stop + more).front(),
                      b = seen_from_carrier(second, rest->balls(), more).front();
    states("position in the carrier's axes off by [m]", norm(a.position - b.position), 0, 1e-15,
           "the same motion, cut in two; rounding of 0.03 m");
    states("velocity off by [m/s]", norm(a.velocity - b.velocity), 0, 1e-14, "the same");
  }
}

TEST(Start, overlapping_balls_of_a_state_are_parted_for_the_event_engine_only) {
  const Folder folder;
  const std::string header =
      "kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,"
      "spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s\n";
  folder.write("final-1.csv",
               header + "1,0.005,0,0,0,1,0,0,0,0,7\n1,0.005,0.0098,0,0,0,0,0,0,0,0\n");
  const auto gap = [&](const std::string& engine_name) {
    const auto balls = start_of(
        read_sample(text(turning, {"diameter = \"10 mm\"\ncount = 2\n"},
                         "engine = \"" + engine_name + "\"\nreplicates = 1\nstart_from = \"" +
                             (folder.path() / "final-1.csv").string() + "\"\n")));
    EXPECT_EQ(balls[0].velocity, (Vec3{1, 0, 0}));
    EXPECT_EQ(balls[0].spin, (Vec3{0, 0, 7}));
    return norm(balls[1].position - balls[0].position) - 0.01;
  };
  EXPECT_NEAR(gap("soft"), -2e-4, 1e-15);
  EXPECT_GT(gap("event"), 0);
  EXPECT_LT(gap("event"), 0.01 * 0.005) << "moved by little";
}

TEST(Start, a_state_of_other_balls_or_of_too_few_replicates_is_refused) {
  const Folder folder;
  const std::string header =
      "kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,velocity_z_m_per_s,"
      "spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s\n";
  const std::string state = header + "1,0.005,0,0,0,1,0,0,0,0,7\n1,0.005,0.02,0,0,0,0,0,0,0,0\n";
  folder.write("final-1.csv", state);
  folder.write("final-2.csv", state);
  folder.write("broken/final-1.csv", header + "1,0.005,0,0,0,1,0,nan,0,0,7\n");
  folder.write("other/final-1.csv", "x,y\n1,2\n");
  folder.write("none/result.csv", "");
  const auto fault = [&](const std::string& balls, const std::string& run,
                         const std::string& from) {
    return cases::sample::one_fault(
        text(turning, {balls}, run + "start_from = \"" + (folder.path() / from).string() + "\"\n"));
  };
  const auto has = [](const std::string& found, const std::string& what) {
    return found.find(what) != std::string::npos ? std::string() : found;
  };
  const std::string two = "diameter = \"10 mm\"\ncount = 2\n", single = "replicates = 1\n";
  EXPECT_EQ(fault(two, "replicates = 2\n", ""), "");
  EXPECT_EQ(has(fault(two, "replicates = 3\n", ""), "has 2 states for 3 replicates"), "");
  EXPECT_EQ(has(fault(two, "replicates = 2\n", "final-1.csv"), "would be the same run"), "");
  EXPECT_EQ(has(fault("diameter = \"10 mm\"\ncount = 3\n", single, ""), "has 2 balls, the case 3"),
            "");
  EXPECT_EQ(has(fault("diameter = \"11 mm\"\ncount = 2\n", single, ""), "diameter of 10 mm"), "");
  EXPECT_EQ(has(fault(two, single, "broken"), "is not the row of a ball"), "");
  EXPECT_EQ(has(fault(two, single, "other"), "has no column kind"), "");
  EXPECT_EQ(has(fault(two, single, "none"), "has no final-1.csv"), "");
  EXPECT_EQ(has(fault(two, single, "missing"), "no file or folder"), "");
  EXPECT_EQ(has(fault(two, single + "start_speed = \"1 m/s\"\n", ""),
                "start_from, which gives the state"),
            "");
}

TEST(Start, the_content_of_the_state_is_part_of_the_identity_of_a_run) {
  const Folder folder;
  const auto fingerprint = [&](const std::string& x) {
    folder.write("final-1.csv",
                 "kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,"
                 "velocity_z_m_per_s,spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s\n1,0.005," +
                     x + ",0,0,1,0,0,0,0,7\n");
    const cases::Case c =
        read_sample(text(turning, {"diameter = \"10 mm\"\n"},
                         "replicates = 1\nstart_from = \"" + folder.path().string() + "\"\n"));
    EXPECT_NE(cases::write(c).find("start_from"), std::string::npos);
    return cases::input_files_fingerprint(c);
  };
  const std::string a = fingerprint("0"), b = fingerprint("0.001"), again = fingerprint("0");
  EXPECT_NE(a, b);
  EXPECT_EQ(a, again);
}

TEST(Start, lists_of_motion_need_as_many_positions) {
  const auto has = [](const std::string& balls, const std::string& what) {
    const std::string found = cases::sample::one_fault(text(turning, {balls}, ""));
    return found.find(what) != std::string::npos ? std::string() : found;
  };
  const std::string ball = one_ball, v = "velocities = [[\"1 m/s\", \"0 m/s\", \"0 m/s\"]";
  EXPECT_EQ(has("diameter = \"10 mm\"\ncount = 1\n" + v + "]\n", "needs `positions`"), "");
  EXPECT_EQ(has(ball + v + ", [\"1 m/s\", \"0 m/s\", \"0 m/s\"]]\n", "has 2 entries for 1"), "");
  EXPECT_EQ(has(ball + "spins = [[\"1 rad/s\", \"0 rad/s\"]]\n", "three components"), "");
  EXPECT_EQ(has(ball + "spins = [[\"1 m\", \"0 m\", \"0 m\"]]\n", "spins"), "");
}

}  // namespace
}  // namespace mahlwerk::campaign::start_test
