// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/hits.hpp"

#include <random>

#include "lammps_cases.hpp"
#include "mahlwerk/cases/build.hpp"
#include "statement.hpp"

namespace mahlwerk::lammps::hits_test {
namespace {

constexpr double dt = 1e-6;

struct Box {
  cases::Case mill_case = tests::lammps_case("still", "box");
  std::vector<scene::Ball> balls = cases::balls_by_set(mill_case.balls);
  Hits hits{mill_case, cases::chamber(mill_case), balls, dt};
};

TEST(Hits, a_contact_with_the_jar_is_a_record_when_it_ends) {
  Box box;
  scene::Ball ball = box.balls[0];
  const double wall = 0.03;  // half the side of the box
  std::vector<scene::Collision> found;
  ball.position = {wall - ball.radius + 1e-9, 0, 0};
  ball.velocity = {2, 0.5, 0};
  box.hits.at_jar(0, ball, 1000, found);
  EXPECT_TRUE(found.empty());
  box.hits.at_jar(0, ball, 1002, found);  // still the same
  ball.position.x = wall - ball.radius - 1e-9;
  ball.velocity.x = -1.6;
  box.hits.at_jar(0, ball, 1030, found);
  ASSERT_EQ(found.size(), 1U);
  const scene::Collision& c = found.front();
  tests::states("approach", c.approach, 2, 1e-3, "lmp.9");
  tests::states("glide", c.glide, 0.5, 1e-12, "speed along the wall");
  tests::states("duration", c.duration, 30 * dt, 1e-3 * 30 * dt + 1e-6,
                "steps between, and the age at the first look");
  tests::states("normal", c.normal.x, 1, 1e-12, "towards the wall");
  EXPECT_EQ(c.ball, 0);
  EXPECT_LT(c.other, 0);
  box.hits.at_jar(0, ball, 1032, found);
  EXPECT_EQ(found.size(), 1U);
}

TEST(Hits, two_balls_have_the_speed_that_a_look_shows) {
  Box box;
  std::vector<scene::Ball> now = box.balls;
  const double reach = now[0].radius + now[1].radius;
  now[0].velocity = {1, 0, 0.3};
  now[1].velocity = {-1, 0, 0};
  now[1].position = now[0].position + Vec3{reach - 2e-6, 0, 0};  // one step of 2 m/s
  EXPECT_EQ(box.hits.look(now, 101), 2);
  const auto strongest = [&](double overlap) {
    return Hits::BallContact{.one = 1,
                             .other = 0,
                             .began = 100,
                             .ended = 140,
                             .distance = reach - overlap,
                             .middle = {}};
  };
  const scene::Collision c = box.hits.between_balls(strongest(1e-4));  // pressed by others later
  tests::states("approach", c.approach, 2, 4e-3, "lmp.10");
  tests::states("sliding of the centres", c.glide, 0.3, 1e-12, "lmp.10");
  // The next contact was not seen: it gets the speeds of the one that was, as it is alike.
  const scene::Collision alike = box.hits.between_balls(strongest(1.01e-4));
  tests::states("approach of one like it", alike.approach, c.approach * std::pow(1.01, 1.25), 1e-3,
                "lmp.10");
}

TEST(Hits, a_slow_slip_is_not_taken_for_one_that_friction_has_braked) {
  // The surfaces have stuck together by the tangential spring, which transmits less than mu = 5.
  Box box;
  for (scene::Ball& b : box.balls) b.velocity = {};
  cases::Case rough = box.mill_case;
  rough.contact.rule.friction = 5;
  Hits hits(rough, cases::chamber(rough), box.balls, dt);
  scene::Ball ball = box.balls[0];
  std::vector<scene::Collision> found;
  for (const double slip : {0.1, 1.0, 3.0}) {
    ball.position = {0.03 - ball.radius + 2e-6, 0, 0};
    ball.velocity = {1, slip, 0};
    hits.at_jar(0, ball, 1000, found);
    ball.position.x -= 4e-6;
    hits.at_jar(0, ball, 1040, found);
    // Soon after first touch the spring has hardly changed the slip.
    tests::states("slip", found.back().slip, slip, 0.02 * slip, "lmp.11");
  }
}

TEST(SeenContacts, many_unseen_contacts_get_the_distribution_of_the_seen_ones) {
  SeenContacts seen;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> strength(0.1, 1), share(0.2, 1);
  double mean = 0, given = 0;
  constexpr int many = 20'000;
  for (int i = 0; i < many; ++i) {
    const double s = strength(random), u = share(random) * s;
    if (i % 20 == 0) seen.add({0, 0}, s, true, {u, 2 * u, u});
    mean += u / many;
  }
  for (int i = 0; i < many; ++i) given += seen.like({0, 0}, strength(random), true).approach / many;
  // Of 1000 seen ones: standard error 0.25 / sqrt(1000), three of them.
  tests::states("mean speed of unseen contacts", given, mean, 0.024, "lmp.10");
  EXPECT_EQ(seen.like({0, 1}, 0.7, false).approach, 0.7);  // of types that nobody has seen
}

}  // namespace
}  // namespace mahlwerk::lammps::hits_test
