// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Trajectories and snapshots of balls at known positions.
#include "mahlwerk/report/paper/trajectories.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

namespace mahlwerk::report::trajectories_test {
namespace {

constexpr double speed = 40, radius = 0.05;

/// A ball that rests 25 mm outwards on the disc of a planetary mill, and a grain at the middle.
results::Outcome outcome() {
  results::Outcome o;
  kinematics::Planetary mill;
  mill.orbit_radius = 0.3, mill.speed = speed, mill.ratio = -2;
  o.mill_case.mill.motion = mill;
  o.mill_case.jar.shape = geometry::Cylinder{2 * radius, 0.1};
  o.mill_case.balls = {{1, 0.01, 7850, ""}, {1, 0.002, 2000, ""}};
  o.mill_case.balls[1].grains = true;
  o.replicates.emplace_back(0.1, observe::BallKinds{},
                            observe::WallGrid{.radius = radius, .bottom = -0.05, .top = 0.05});
  std::vector<scene::Ball> balls = cases::starting_balls(o.mill_case, 0);
  observe::Replay film(cases::chamber(o.mill_case), 2, 0, 1);
  for (double t = film.next_frame_time(); std::isfinite(t); t = film.next_frame_time()) {
    balls[0].position = {0.025 * std::cos(speed * t), 0.025 * std::sin(speed * t), 0};
    balls[0].velocity = {};
    balls[1].position = balls[1].velocity = {};
    film.add(t, balls);
  }
  o.replicates[0].replay = film;
  return o;
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// Largest distance [px] between any point of the first path and its beginning.
double spread(const std::string& svg) {
  const std::size_t at = svg.find("d=\"M");
  const std::string path = svg.substr(at + 3, svg.find('"', at + 3) - at - 3);
  double x0 = NAN, y0 = NAN, most = 0;
  for (std::size_t i = 0; i < path.size(); i = path.find_first_of("ML", i + 1)) {
    double x = 0, y = 0;
    if (std::sscanf(path.c_str() + i + 1, "%lf %lf", &x, &y) != 2) break;
    if (std::isnan(x0)) x0 = x, y0 = y;
    most = tests::max_or_nan(most, std::hypot(x - x0, y - y0));
    if (path.find_first_of("ML", i + 1) == std::string::npos) break;
  }
  return most;
}

TEST(Trajectories, a_ball_at_rest_on_the_disc_is_a_point_there_and_a_circle_seen_from_the_jar) {
  const results::Outcome o = outcome();
  const std::string disc = trajectories_picture(o, 0, View::carrier, 340);
  EXPECT_EQ(count(disc, "stroke-opacity=\"0.8\""), 1);  // of the ball; the grain has none
  EXPECT_EQ(count(disc, "r=\"16.8\" fill=\"#0072B2\" fill-opacity"), 1) << "the ball, 5 of 50 mm";
  EXPECT_LE(spread(disc), 0.2);  // coordinates are rounded to 0.1 px
  // A panel of 340 px less its rim shows a jar 100 mm wide: the circle's diameter is half of that.
  const std::string jar = trajectories_picture(o, 0, View::jar, 340);
  EXPECT_NEAR(spread(jar), 0.5 * 336, 1);
}

TEST(Trajectories, a_snapshot_has_balls_red_and_grains_green_at_their_sizes) {
  const results::Outcome o = outcome();
  const std::string svg = snapshot_picture(o, 0, View::carrier, 340);
  EXPECT_EQ(count(svg, "#C8102E"), 1);
  EXPECT_EQ(count(svg, "#2E8B57"), 1);
  EXPECT_NE(svg.find("r=\"16.8\" fill=\"#C8102E\""), std::string::npos) << svg;  // 5 of 50 mm
  EXPECT_EQ(count(svg, "<circle"), 3);                                           // and the wall
  EXPECT_EQ(count(svg, "var("), 0);
}

TEST(Trajectories, have_a_scale_bar_of_a_round_length) {
  // 340 px less the rim are 100 mm: 20 mm are 67.2 px, and 50 mm would be more than a third.
  const std::string svg = snapshot_picture(outcome(), 0, View::carrier, 340);
  EXPECT_NE(svg.find("h67.2m"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">20 mm<"), std::string::npos) << svg;
}

/// Cells of the second line of CSV.
std::vector<std::string> first_row(const std::string& csv) {
  std::string line = csv.substr(csv.find('\n') + 1);
  line.resize(line.find('\n'));
  std::vector<std::string> cells{""};
  for (const char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

TEST(Trajectories, their_csv_has_the_positions_in_the_frame_of_the_picture) {
  const results::Outcome o = outcome();
  const std::string csv = trajectories_csv(o, 0, View::carrier);
  EXPECT_TRUE(csv.starts_with("replicate,ball,time_s,x_m,y_m\n"));
  EXPECT_EQ(static_cast<std::size_t>(count(csv, "\n")), o.replicates[0].replay.times().size() + 1);
  const std::vector<std::string> row = first_row(csv);
  // Positions are stored to a 32 767th of the jar's reach, 71 mm here.
  EXPECT_NEAR(std::stod(row[3]), 0.025, 3e-6);
  EXPECT_NEAR(std::stod(row[4]), 0, 3e-6);
  const std::string snapshot = snapshot_csv(o, 0, View::carrier);
  EXPECT_EQ(count(snapshot, "\n"), 3);
  EXPECT_EQ(first_row(snapshot)[2], "ball");
  EXPECT_EQ(first_row(snapshot)[4], "0.005");
  EXPECT_NE(snapshot.find(",grain,"), std::string::npos);
}

TEST(Trajectories, without_a_film_there_is_no_picture) {
  results::Outcome o = outcome();
  o.replicates[0].replay = {};
  EXPECT_EQ(trajectories_picture(o, 0, View::jar, 340), "");
  EXPECT_EQ(snapshot_picture(o, 1, View::jar, 340), "");
  EXPECT_EQ(count(trajectories_csv(o, 0, View::jar), "\n"), 1);
}

}  // namespace
}  // namespace mahlwerk::report::trajectories_test
