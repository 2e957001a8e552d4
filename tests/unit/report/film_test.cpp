// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// film.json of balls at known positions.
#include "mahlwerk/report/film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::report::film_test {
namespace {

using results::Json;

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
    film.add(t, t, balls);
  }
  o.replicates[0].replay = film;
  return o;
}

double number(const Json& json) {
  if (const auto* whole = std::get_if<std::int64_t>(&json.value()))
    return static_cast<double>(*whole);
  if (const auto* count = std::get_if<std::uint64_t>(&json.value()))
    return static_cast<double>(*count);
  return std::get<double>(json.value());
}
const Json::Array& list(const Json* json) {
  return std::get<Json::Array>(json->value());
}
/// x, y or the height of a ball over time.
std::vector<double> path(const Json& ball, const char* view, std::size_t axis) {
  std::vector<double> numbers;
  for (const Json& one : list(&list(ball.find(view))[axis])) numbers.push_back(number(one));
  return numbers;
}
double spread(const std::vector<double>& values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

TEST(Film, a_ball_at_rest_on_the_disc_is_a_point_there_and_a_circle_seen_from_the_jar) {
  const Json film = Json::parse(film_json(outcome()));
  const Json& ball = list(list(film.find("replicates"))[0].find("balls"))[0];
  // Positions are stored to a 32 767th of the jar's reach, 71 mm here.
  EXPECT_NEAR(path(ball, "carrier", 0).front(), 0.025, 3e-6);
  EXPECT_NEAR(path(ball, "carrier", 1).front(), 0, 3e-6);
  EXPECT_LE(spread(path(ball, "carrier", 0)), 6e-6);
  EXPECT_NEAR(spread(path(ball, "jar", 0)), 2 * 0.025, 3e-4);
  EXPECT_NEAR(spread(path(ball, "jar", 1)), 2 * 0.025, 3e-4);
}

TEST(Film, has_every_frame_of_a_ball_and_the_last_one_of_a_grain_with_their_sizes) {
  const results::Outcome o = outcome();
  const Json film = Json::parse(film_json(o));
  const Json& shown = list(film.find("replicates"))[0];
  const Json::Array& balls = list(shown.find("balls"));
  EXPECT_EQ(number(*shown.find("replicate")), 1);
  EXPECT_EQ(list(shown.find("times_s")).size(), o.replicates[0].replay.times().size());
  EXPECT_EQ(path(balls[0], "carrier", 2).size(), o.replicates[0].replay.times().size());
  EXPECT_EQ(path(balls[1], "carrier", 2).size(), 1U);
  EXPECT_EQ(number(*balls[0].find("radius_m")), 0.005);
  EXPECT_FALSE(std::get<bool>(balls[0].find("grain")->value()));
  EXPECT_TRUE(std::get<bool>(balls[1].find("grain")->value()));
  EXPECT_TRUE(std::get<bool>(film.find("round")->value()));
  EXPECT_NEAR(number(*film.find("half_m")), radius, 1e-6);
}

TEST(Film, has_null_while_a_ball_is_outside_the_jar) {
  results::Outcome o = outcome();
  std::vector<scene::Ball> balls = cases::starting_balls(o.mill_case, 0);
  observe::Replay film(cases::chamber(o.mill_case), 2, 0, 1);
  for (double t = film.next_frame_time(); std::isfinite(t); t = film.next_frame_time()) {
    balls[0].outside = t == 0;
    film.add(t, t, balls);
  }
  o.replicates[0].replay = film;
  const Json json = Json::parse(film_json(o));
  const Json& ball = list(list(json.find("replicates"))[0].find("balls"))[0];
  for (const char* view : {"carrier", "jar"})
    for (const Json& axis : list(ball.find(view))) {
      EXPECT_TRUE(std::holds_alternative<std::nullptr_t>(list(&axis)[0].value()));
      EXPECT_TRUE(std::isfinite(number(list(&axis)[1])));
    }
}

TEST(Film, without_frames_has_no_balls) {
  results::Outcome o = outcome();
  o.replicates[0].replay = {};
  const Json film = Json::parse(film_json(o));
  EXPECT_TRUE(list(list(film.find("replicates"))[0].find("balls")).empty());
}

}  // namespace
}  // namespace mahlwerk::report::film_test
