// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Predicted collisions: the fast form, several pairs at a time, against a plain form in long
// double.
#include "mahlwerk/event/collision_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "isas.hpp"
#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::collision_prediction_test {
namespace {

using event::CollisionQuery;
using event::never;
using event::PredictedCollision;
using event::Trajectory;

using Wide = long double;
constexpr Wide half_digit = 0x1p-53L;

struct Wide3 {
  Wide x, y, z;
};
Wide product(const Wide3& a, const Wide3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// One pair in long double, and the error of the result that rounding in double may cause.
struct Truth {
  enum Kind { meets, misses, too_close_to_tell } kind = misses;
  Wide since_now = 0, tolerance = 0;  // [s]
};

Truth truth(const CollisionQuery& me, const Trajectory& other, Wide reach, const Vec3& periods) {
  const Wide passed = Wide{me.time} - other.since;
  Wide from_places = 0;  // [m] rounding error of the positions
  const auto apart = [&](double mine, double start, double speed, double period) {
    const Wide there = start + passed * speed;
    from_places += 4 * half_digit *
                   (std::abs(Wide{mine}) + std::abs(Wide{start}) + 2 * std::abs(passed * speed));
    const Wide x = mine - there;
    return period < never ? x - period * std::rint(x / period) : x;
  };
  const Wide3 r{apart(me.position.x, other.position.x, other.velocity.x, periods.x),
                apart(me.position.y, other.position.y, other.velocity.y, periods.y),
                apart(me.position.z, other.position.z, other.velocity.z, periods.z)};
  const Wide3 u{Wide{me.velocity.x} - other.velocity.x, Wide{me.velocity.y} - other.velocity.y,
                Wide{me.velocity.z} - other.velocity.z};
  const Wide b = product(r, u), u2 = product(u, u), r2 = product(r, r), gap = r2 - reach * reach;
  const Wide d = b * b - u2 * gap, size = std::sqrt(r2), speed = std::sqrt(u2);
  // The errors of b, gap and d come from their own operations and from the positions.
  const Wide of_b = 6 * half_digit * size * speed + speed * from_places;
  const Wide of_gap = 8 * half_digit * (r2 + reach * reach) + 2 * size * from_places;
  const Wide of_d =
      2 * std::abs(b) * of_b + u2 * of_gap + 8 * half_digit * (b * b + u2 * std::abs(gap));
  if (std::abs(b) <= of_b || std::abs(d) <= 100 * of_d) return {Truth::too_close_to_tell};
  if (b > 0 || d < 0) return {};
  const Wide below = std::sqrt(d) - b, time = std::max(gap, Wide{0}) / below;
  const Wide relative = (of_d / std::sqrt(d) + of_b) / below + 8 * half_digit;
  return {Truth::meets, time, 2 * (time * relative + of_gap / below)};
}

struct Scene {
  CollisionQuery me{};
  std::vector<Trajectory> trajectories;
  std::vector<std::int32_t> others;
  std::vector<double> radii;
  Vec3 periods{never, never, never};
};

double decades(Random& random, double least, double most) {
  return std::pow(10, random.uniform(std::log10(least), std::log10(most)));
}

/// A ball and several others: distant, touching, overlapping, approaching, receding, side by side.
Scene scene(Random& random, int count, bool periodic, int species) {
  Scene s;
  for (int i = 0; i < species; ++i) s.radii.push_back(decades(random, 0.01, 1));
  const auto kind = [&] { return static_cast<std::uint32_t>(random.uniform() * species); };
  const double time = random.uniform(0, 1), box = random.uniform(8, 20);
  if (periodic) s.periods = {box, box * 1.1, box * 1.3};
  const std::uint32_t mine = kind();
  s.me = {random.uniform(0, 3) * random.direction(),
          decades(random, 1e-6, 1e6) * random.direction(), time, s.radii[mine], 0};
  s.trajectories.push_back({.position = s.me.position,
                            .since = time,
                            .velocity = s.me.velocity,
                            .revision = 0,
                            .species = mine});
  for (int i = 1; i <= count; ++i) {
    const std::uint32_t species_i = kind();
    const double reach = s.me.radius + s.radii[species_i], how = random.uniform();
    double far = how < 0.2   ? reach * (1 + decades(random, 1e-16, 1e-3))
                 : how < 0.3 ? reach * (1 - decades(random, 1e-16, 1e-10))
                             : reach + random.uniform(0, 3);
    const Vec3 way = random.direction();
    Vec3 velocity = decades(random, 1e-6, 1e6) * random.direction();
    const double aim = random.uniform();
    if (aim < 0.5) velocity = s.me.velocity - decades(random, 1e-6, 1e6) * way;     // head on
    if (aim < 0.25) velocity += 0.5 * norm(velocity) * random.direction();          // nearly so
    if (aim > 0.95) velocity = s.me.velocity;                                       // same velocity
    if (aim > 0.90 && aim < 0.95) velocity = s.me.velocity + cross(way, velocity);  // past it
    const double since = random.uniform() < 0.5 ? time : time - decades(random, 1e-9, 1e-6);
    Vec3 place = s.me.position + far * way - (time - since) * velocity;
    if (periodic && random.uniform() < 0.3)
      place += Vec3{place.x > 0 ? -s.periods.x : s.periods.x, 0, 0};
    s.trajectories.push_back({.position = place,
                              .since = since,
                              .velocity = velocity,
                              .revision = 0,
                              .species = species_i});
    s.others.push_back(i);
  }
  return s;
}

PredictedCollision among(const Scene& s, std::span<const std::int32_t> others) {
  return event::collision_search()(s.me, s.trajectories, others, s.radii, s.periods, {});
}

bool same_bits(const PredictedCollision& a, const PredictedCollision& b) {
  return a.time == b.time && a.partner == b.partner;
}

TEST(CollisionPredictions, of_a_pair_are_those_of_the_plain_formula_with_more_digits) {
  Random random(1, 1);
  constexpr int pairs = 1'000'000;
  int met = 0, unclear = 0, wrong = 0;
  Wide worst = 0;
  for (int i = 0; i < pairs; ++i) {
    const Scene s = scene(random, 1, i % 2 == 0, 1 + i % 3);
    const Truth expected = truth(s.me, s.trajectories[1],
                                 Wide{s.me.radius} + s.radii[s.trajectories[1].species], s.periods);
    const PredictedCollision found = among(s, s.others);
    if (expected.kind == Truth::too_close_to_tell) {
      ++unclear;
      continue;
    }
    met += expected.kind == Truth::meets;
    wrong += (found.partner == 1) != (expected.kind == Truth::meets);
    if (expected.kind != Truth::meets || found.partner != 1) continue;
    const Wide clock = half_digit * (s.me.time + expected.since_now);
    const Wide off = std::abs(found.time - (s.me.time + expected.since_now));
    worst = max_or_nan(worst, off / (expected.tolerance + clock));
  }
  std::printf("    %d of %d pairs meet, %d are undecided in double precision\n", met, pairs,
              unclear);
  EXPECT_GT(met, pairs / 3);
  EXPECT_LT(unclear, pairs / 10);
  EXPECT_EQ(wrong, 0) << "meeting or not";
  stays_below("error of the time over its bound", static_cast<double>(worst), 1,
              "rounding of each operation, added up");
}

TEST(CollisionPredictions, of_many_are_the_earliest_of_all_pairs_to_the_bit) {
  Random random(2, 1);
  for (int i = 0; i < 100'000; ++i) {
    const int count = i % 37;
    const Scene s = scene(random, count, i % 2 == 0, 1 + i % 3);
    PredictedCollision earliest;
    for (const std::int32_t other : s.others) {
      const PredictedCollision one = among(s, std::span(&other, 1));
      if (one.time < earliest.time) earliest = one;
    }
    const PredictedCollision found = among(s, s.others);
    ASSERT_EQ(found.time, earliest.time) << i;
    if (found.partner < 0) continue;
    // If times tie, as for all balls that overlap this one now, any partner is correct.
    ASSERT_EQ(among(s, std::span(&found.partner, 1)).time, earliest.time) << i;
  }
}

TEST(CollisionPredictions, do_not_depend_on_who_else_is_asked_or_how_sizes_are_listed) {
  Random random(3, 1);
  for (int i = 0; i < 20'000; ++i) {
    Scene s = scene(random, 1 + i % 21, i % 2 == 0, 1);
    const PredictedCollision one_size = among(s, s.others);
    const double radius = s.radii[0];
    s.radii = {radius, radius, radius};
    for (Trajectory& l : s.trajectories)
      l.species = static_cast<std::uint32_t>(random.uniform() * 3);
    ASSERT_TRUE(same_bits(among(s, s.others), one_size)) << "three species of one radius";
    // Adds the ball itself and repeated others to the list, more and more of them.
    std::vector<std::int32_t> more = s.others;
    for (int k = 0; k < 9; ++k) {
      more.push_back(k % 3 == 0 ? s.me.self
                                : s.others[static_cast<std::size_t>(k) % s.others.size()]);
      const PredictedCollision found = among(s, more);
      ASSERT_EQ(found.time, one_size.time);
    }
  }
}

TEST(CollisionPredictions, of_balls_in_any_vector_width_have_the_same_bits) {
  Random random(5, 1);
  std::vector<event::CollisionSearch*> searches;
  for (const Isa isa : supported_isas()) {
    const ChosenIsa chosen(isa);
    searches.push_back(event::collision_search());
  }
  for (int i = 0; i < 20'000; ++i) {
    const Scene s = scene(random, i % 150, i % 2 == 0, 1 + i % 3);
    const PredictedCollision plain =
        searches.front()(s.me, s.trajectories, s.others, s.radii, s.periods, {});
    for (const auto search : searches)
      ASSERT_TRUE(same_bits(search(s.me, s.trajectories, s.others, s.radii, s.periods, {}), plain))
          << i;
  }
}

TEST(CollisionPredictions, none_is_found_that_is_not_before_the_best_known) {
  Random random(4, 1);
  for (int i = 0; i < 20'000; ++i) {
    const Scene s = scene(random, 8, false, 2);
    const PredictedCollision found = among(s, s.others);
    if (found.partner < 0 || found.time < s.me.time + 1e-9) continue;
    const PredictedCollision best{s.me.time + 0.5 * (found.time - s.me.time), 77};
    EXPECT_TRUE(same_bits(
        event::collision_search()(s.me, s.trajectories, s.others, s.radii, s.periods, best), best));
  }
}

}  // namespace
}  // namespace mahlwerk::tests::collision_prediction_test
