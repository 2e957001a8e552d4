// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/setup/fill.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/setup/push_apart.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "statement.hpp"

namespace mahlwerk::cases::fill_test {
namespace {

constexpr double pi = std::numbers::pi;

BallSet set_of(std::int64_t count, double diameter) {
  return {count, diameter, 7850, ""};
}
/// As many balls as give the jar the solid volume fraction `filling`.
BallSet share(const geometry::AnyShape& shape, double filling, double diameter) {
  const double jar = geometry::volume(shape);
  return set_of(std::llround(filling * jar / (pi / 6 * std::pow(diameter, 3))), diameter);
}

/// The smallest gap between two balls over the sum of their radii.
double smallest_gap(const std::vector<scene::Ball>& balls) {
  double least = INFINITY;
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(
          least,
          norm(balls[i].position - balls[j].position) / (balls[i].radius + balls[j].radius) - 1);
  return least;
}
/// The smallest gap between ball and wall over the radius.
double smallest_wall_gap(const std::vector<scene::Ball>& balls, const geometry::AnyShape& shape) {
  double least = INFINITY;
  std::visit(
      [&](const auto& s) {
        for (const scene::Ball& b : balls)
          for (int face = 0; face < s.faces; ++face)
            if (s.can_touch(face, b.radius))
              least = std::min(least, s.gap(face, b.position).distance / b.radius - 1);
      },
      shape);
  return least;
}

void expect_filled(const geometry::AnyShape& shape, const std::vector<BallSet>& sets,
                   std::uint32_t stream = 0) {
  Random random(1, stream);
  const std::vector<scene::Ball> balls = fill(shape, sets, random);
  std::size_t at = 0;
  for (std::size_t kind = 0; kind < sets.size(); ++kind)
    for (std::int64_t n = 0; n < sets[kind].count; ++n, ++at) {
      ASSERT_LT(at, balls.size());
      EXPECT_EQ(balls[at].radius, 0.5 * sets[kind].diameter);
      EXPECT_EQ(balls[at].kind, static_cast<std::int32_t>(kind));
    }
  EXPECT_EQ(at, balls.size());
  EXPECT_GT(smallest_gap(balls), 1e-9);
  EXPECT_GT(smallest_wall_gap(balls, shape), 1e-9);
}

TEST(Fill, few_balls_in_narrow_jars) {
  const geometry::Capsule tube{10e-3, 40e-3};
  for (std::uint32_t stream = 0; stream < 20; ++stream)
    for (const std::int64_t count : {1, 2, 3, 6})
      expect_filled(tube, {set_of(count, 8e-3)}, stream);
  const geometry::Sphere hollow{20e-3};  // full with three of 9.28 mm or two of 10 mm
  for (std::uint32_t stream = 0; stream < 20; ++stream) {
    expect_filled(hollow, {set_of(3, 9.2e-3)}, stream);
    expect_filled(hollow, {set_of(2, 9.95e-3)}, stream);
    expect_filled(hollow, {set_of(1, 19.9999e-3)}, stream);
  }
}

TEST(Fill, equal_balls_up_to_near_random_close_packing) {
  const geometry::Cylinder jar{1, 1};  // twenty balls across: the wall costs about 3 %
  for (const double filling : {0.1, 0.3, 0.45, 0.55, 0.58})
    expect_filled(jar, {share(jar, filling, 0.05)});
}

TEST(Fill, every_kind_of_jar_half_full) {
  for (const geometry::AnyShape& shape : std::initializer_list<geometry::AnyShape>{
           geometry::Sphere{1}, geometry::Capsule{0.5, 1}, geometry::Cylinder{1, 0.3},
           geometry::RoundedCylinder{1, 1, 0.02}, geometry::RoundedCylinder{1, 1, 0.3}})
    expect_filled(shape, {share(shape, 0.5, 0.06)});
}

TEST(Fill, sizes_in_the_ratio_of_five_whatever_their_order) {
  const geometry::Cylinder jar{0.6, 0.6};
  expect_filled(jar, {share(jar, 0.3, 0.1), share(jar, 0.3, 0.02)});
  expect_filled(jar, {share(jar, 0.2, 0.02), share(jar, 0.1, 0.05), share(jar, 0.3, 0.1)});
}

/// A set of `count` balls in twelve sizes from half to twice `diameter`.
BallSet spread(std::int64_t count, double diameter) {
  BallSet set = set_of(count, diameter);
  const Distribution d{
      .law = Distribution::Law::lognormal, .diameter = diameter, .spread = 1.26, .classes = 12};
  const std::vector<SizeShare> shares = size_shares(d);
  const std::vector<std::int64_t> counts = apportion(count, shares);
  for (std::size_t i = 0; i < shares.size(); ++i)
    set.classes.push_back({shares[i].diameter, counts[i]});
  set.diameter = mean_volume_diameter(set.classes);
  return set;
}

TEST(Fill, a_set_of_many_sizes_half_full) {
  const geometry::Cylinder jar{0.2, 0.2};
  const BallSet set = spread(2400, 0.0126);
  const double filling = 2400 * pi / 6 * std::pow(set.diameter, 3) / jar.volume();
  EXPECT_GT(filling, 0.5);
  Random random(1, 0);
  const std::vector<scene::Ball> balls = fill(jar, {set, share(jar, 0.02, 0.02)}, random);
  EXPECT_GT(smallest_gap(balls), 1e-9);
  EXPECT_GT(smallest_wall_gap(balls, jar), 1e-9);
}

TEST(Fill, five_large_balls_among_many_fifteen_times_smaller) {
  const geometry::Cylinder jar{0.06, 0.06};
  for (const std::int64_t grains : {4000, 12000})  // 4000 are placed one by one, 12000 pushed apart
    expect_filled(jar, {set_of(5, 0.015), set_of(grains, grains == 4000 ? 0.001 : 0.0022)});
}

TEST(Fill, many_balls_are_where_they_were_the_last_time) {
  const geometry::Cylinder jar{1, 1};
  const std::vector<BallSet> sets{share(jar, 0.45, 0.035)};
  ASSERT_GT(sets[0].count, 10000);
  const auto places = [&] {
    Random random(1, 0);
    std::vector<Vec3> at;
    for (const scene::Ball& b : fill(jar, sets, random)) at.push_back(b.position);
    return at;
  };
  EXPECT_EQ(places(), places());
}

TEST(Fill, many_balls_that_never_fit_are_refused_soon) {
  const geometry::Cylinder jar{1, 1};
  Random random(1, 0);
  try {
    fill(jar, {share(jar, 0.7, 0.045)}, random);
    FAIL();
  } catch (const InputError& error) {
    const std::string& what = error.faults().at(0).what;
    const double reached = std::stod(what.substr(what.find("random: ") + 8)) / 100;
    EXPECT_GT(reached, 0.5) << what;
    EXPECT_LT(reached, 0.64) << what;
  }
}

TEST(Fill, depends_on_seed_and_stream_alone) {
  const geometry::Cylinder jar{1, 1};
  const std::vector<BallSet> sets{share(jar, 0.5, 0.1)};
  const auto places = [&](std::uint64_t seed, std::uint32_t stream) {
    Random random(seed, stream);
    std::vector<Vec3> at;
    for (const scene::Ball& b : fill(jar, sets, random)) at.push_back(b.position);
    return at;
  };
  EXPECT_EQ(places(1, 2), places(1, 2));
  EXPECT_NE(places(1, 2), places(1, 3));
  EXPECT_NE(places(1, 2), places(2, 2));
}

TEST(Fill, what_does_not_fit_is_a_fault_that_says_what_would) {
  const geometry::Cylinder jar{0.042, 0.0325};
  for (const double filling : {0.62, 0.72}) {
    Random random(1, 0);
    try {
      fill(jar, {share(jar, filling, 0.01)}, random);
      FAIL() << "filled to " << filling;
    } catch (const InputError& error) {
      const Fault& fault = error.faults().at(0);
      EXPECT_EQ(fault.code, "too-many-balls");
      EXPECT_FALSE(fault.remedy.empty());
      const auto at = fault.what.find("random: ");
      ASSERT_NE(at, std::string::npos) << fault.what;
      const double reached = std::stod(fault.what.substr(at + 8)) / 100;
      EXPECT_GT(reached, 0.45) << fault.what;  // a wide jar would take 0.64
      EXPECT_LT(reached, filling) << fault.what;
    }
  }
}

TEST(PushApart, in_a_room_without_walls_images_count) {
  const double radius = 0.05, filling = 0.6;
  const Domain domain{{0.5, 0.5, 0.5}, {1, 1, 1}};
  const auto count = static_cast<std::size_t>(filling / (4.0 / 3 * pi * std::pow(radius, 3)));
  Random random(5, 0);
  std::vector<PlacedBall> balls(count);
  for (PlacedBall& b : balls)
    b = {{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)}, radius};
  EXPECT_TRUE(push_apart(balls, geometry::Sphere{100}, domain, 1e-3, 100'000'000).free);
  double least = INFINITY;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          for (int z = -1; z <= 1; ++z)
            least = std::min(least, norm(balls[i].position - balls[j].position +
                                         Vec3{double(x), double(y), double(z)}));
  EXPECT_GT(least, 2 * radius);
}

TEST(Grid, finds_every_neighbour_once_and_none_is_missed) {
  const Domain open{{1, 0.5, 0.1}, {INFINITY, INFINITY, INFINITY}};
  const Domain mixed{{1, 0.5, 0.1}, {2, INFINITY, 0.2}};
  const Domain round{{1, 1, 1}, {2, 2, 2}};
  for (const Domain& domain : {open, mixed, round})
    for (const double reach : {0.05, 0.3, 0.9}) {
      Random random(7, 0);
      Grid grid(domain, reach, 300);
      std::vector<Vec3> at;
      for (int i = 0; i < 300; ++i) {
        at.push_back({random.uniform(-1, 1) * domain.half.x, random.uniform(-1, 1) * domain.half.y,
                      random.uniform(-1, 1) * domain.half.z});
        grid.add(i, at.back());
      }
      for (const Vec3& p : at) {
        std::multiset<int> found, near;
        grid.for_each_near(p, [&](int j) {
          if (norm(domain.minimum_image(p, at[static_cast<std::size_t>(j)])) < reach)
            found.insert(j);
          return true;
        });
        for (int j = 0; j < 300; ++j)
          if (norm(domain.minimum_image(p, at[static_cast<std::size_t>(j)])) < reach)
            near.insert(j);
        EXPECT_EQ(found, near);
      }
    }
}

}  // namespace
}  // namespace mahlwerk::cases::fill_test
