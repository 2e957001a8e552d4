// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine in jars of triangles: results agree with those in an analytic shape, a contact at
// a protruding edge counts once, and nothing leaves a closed surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mesh_jars.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::mesh_test {
namespace {

using geometry::Mesh;

double apart(const scene::Engine& a, const scene::Engine& b) {
  const auto one = a.balls(), other = b.balls();
  double most = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    most = max_or_nan(most, norm(one[i].position - other[i].position));
  return most;
}

TEST(MeshJar, a_box_of_triangles_moves_balls_as_a_box_does) {
  const geometry::Box exact{0.03, 0.042, 0.0325};
  const Mesh mesh = mesh_of(box(exact.width, exact.depth, exact.height));
  struct Mill {
    std::string name;
    kinematics::AnyMotion motion;
    Rotation mount;
    int balls;
  };
  for (const Mill& mill : {Mill{"shaken", shaken(20, 0.01), {}, 1},
                           Mill{"tumbling", kinematics::Tumbling{20}, lying, 5},
                           Mill{"planetary", kinematics::Planetary{0.07, 40, -2}, {}, 60}}) {
    Random random(3, 1);
    auto balls = random_balls_in(mesh, mill.balls, 0.0025, random, 1);
    auto nudged = balls;
    for (scene::Ball& b : nudged) b.position.x += 1e-13;
    const auto a = run_in(exact, mill.motion, mill.mount, balls, 2e-6);
    const auto b = run_in(mesh, mill.motion, mill.mount, balls, 2e-6);
    const auto c = run_in(exact, mill.motion, mill.mount, nudged, 2e-6);
    Recorder by_box, by_mesh, by_nudged;
    const double time = mill.balls == 1 ? 0.3 : 0.05;
    a->advance(time, by_box);
    b->advance(time, by_mesh);
    c->advance(time, by_nudged);
    EXPECT_GT(by_box.all.size(), 5U);
    EXPECT_EQ(by_box.all.size(), by_mesh.all.size());
    stays_below(mill.name + ": positions off [m]", apart(*a, *b),
                std::max(1e-12, 10 * apart(*a, *c)), "the same in a box; grown from 1e-13 m");
    if (mill.balls == 1) {
      stays_below("one ball off after its bounces [m]", apart(*a, *b), 1e-9, "the same in a box");
    }
  }
}

struct Figures {
  std::vector<double> power, rate;  // [W], [1/s] above 0.1 m/s, of each replicate
};

Figures shaken_lying(const geometry::AnyShape& shape, const Mesh& places) {
  Figures found;
  for (std::uint32_t replicate = 0; replicate < 6; ++replicate) {
    Random random(5, replicate);
    const auto engine =
        run_in(shape, shaken(25, 0.01), lying, random_balls_in(places, 8, 0.004, random), 5e-6);
    Recorder warm_up, counted;
    engine->advance(0.1, warm_up);
    const double before = engine->energy_balance().wall_work;
    engine->advance(3.1, counted);
    found.power.push_back((engine->energy_balance().wall_work - before) / 3);
    const auto hits = std::ranges::count_if(
        counted.all, [](const scene::Collision& c) { return c.approach > 0.1; });
    found.rate.push_back(static_cast<double>(hits) / 3);
  }
  return found;
}

void agree(const std::string& what, const std::vector<double>& a, const std::vector<double>& b) {
  const auto mean = [](const std::vector<double>& x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  };
  const auto error2 = [&](const std::vector<double>& x) {
    double sum = 0;
    for (const double v : x) sum += (v - mean(x)) * (v - mean(x));
    return sum / static_cast<double>(x.size() * (x.size() - 1));
  };
  states(what, mean(a), mean(b), 4 * std::sqrt(error2(a) + error2(b)),
         "the analytic cylinder; 4 standard errors of six replicates each");
}

TEST(MeshJar, a_fine_cylinder_of_triangles_takes_the_power_and_the_hits_of_a_cylinder) {
  const Mesh mesh = mesh_of(cylinder(256, 0.06, 0.03));
  const Figures found = shaken_lying(mesh, mesh),
                exact = shaken_lying(geometry::Cylinder{0.06, 0.03}, mesh);
  agree("power [W]", found.power, exact.power);
  agree("hits above 0.1 m/s [1/s]", found.rate, exact.rate);
}

/// Without friction and dissipation, a ball that slides over an edge keeps its energy, although the
/// contact passes from one face to the other.
TEST(MeshJar, a_ball_that_goes_over_an_edge_keeps_its_energy) {
  // A step in the floor of a box: upper floor at z = 0 for x < 0, lower at z = -0.02.
  const Triangles step = [] {
    Triangles t = prism({{0.05, 0.04, 0},
                         {-0.05, 0.04, 0},
                         {-0.05, 0, 0},
                         {0, 0, 0},
                         {0, -0.02, 0},
                         {0.05, -0.02, 0}},
                        0.04);
    for (Corners& c : t)  // y upwards becomes z
      for (Vec3& p : c) p = {p.x, -p.z, p.y};
    return t;
  }();
  const Mesh mesh = mesh_of(step);
  ASSERT_EQ(mesh.faces, 8);
  for (const std::size_t few : {32U, 0U}) {
    const scene::Ball ball{0.005, 7850, {-0.01, 0, 0.00499999}, {0.1, 0, 0}, {}};
    auto frictionless = soft_pair(1, 0);
    frictionless.rolling_friction = 0;
    const auto engine = run_in(mesh, kinematics::Still{}, {}, {ball}, 1e-6, few, frictionless);
    Recorder recorder;
    double speed = 0, most = 0;
    int steps_over = 0;
    for (int i = 1; i < 3000; ++i) {
      engine->advance(1e-4 * i, recorder);
      const scene::EnergyBalance a = engine->energy_balance();
      const scene::Ball b = engine->balls()[0];
      if (b.position.x < -0.002 || b.position.z < -0.012) continue;
      ++steps_over;
      most = max_or_nan(most, std::abs(a.kinetic + a.potential + a.elastic - a.initial_energy));
      speed = max_or_nan(speed, norm(b.velocity));
    }
    EXPECT_GT(steps_over, 100);
    EXPECT_GT(speed, 0.2) << "it has fallen off";
    // The overlap with the floor at rest stores m g d/2.5. A jump of the force would leave more.
    stays_below("energy gone on the way over the edge, over m g R",
                most / (ball.mass() * gravity * 0.005), 1e-4,
                "a smooth hand-over; 200 times less than one contact counted twice");
    double off = 0;
    for (const scene::Collision& c : recorder.all)
      off = max_or_nan(off, distance_to(step, c.where));
    EXPECT_GT(recorder.all.size(), 2U);
    stays_below("records off the wall [m]", off, 1e-6,
                "one step at 0.8 m/s, faster than 20 mm of fall; the overlap at rest is 1e-7");
  }
}

TEST(MeshJar, nothing_leaves_a_closed_surface) {
  struct Trial {
    std::string name;
    Mesh mesh;
    int balls;
    double radius;
    std::int64_t steps;
  };
  for (const Trial& trial :
       {Trial{"lumps", mesh_of(lumpy(0.015)), 4, 0.0004, 1'000'000},
        Trial{"bars", mesh_of(drum_with_lifters(0.06, 0.02, 5, 0.008, 0.003)), 8, 0.0015, 300'000},
        Trial{"crowd among bars", mesh_of(drum_with_lifters(0.06, 0.02, 5, 0.008, 0.003)), 80,
              0.0015, 60'000}}) {
    Random random(7, 1);
    const double step = 1e-6;
    const auto engine =
        run_in(trial.mesh, kinematics::Tumbling{15}, lying,
               random_balls_in(trial.mesh, trial.balls, trial.radius, random), step);
    Recorder recorder;
    ASSERT_NO_THROW(engine->advance(static_cast<double>(trial.steps) * step, recorder))
        << trial.name;
    const Rotation q = kinematics::Tumbling{15}.rotation(engine->energy_balance().time) * lying;
    double deepest = 0;
    for (const scene::Ball& b : engine->balls())
      trial.mesh.near(q.apply_inverse(b.position), b.radius, [&](int, const geometry::Gap& gap) {
        deepest = max_or_nan(deepest, 1 - gap.distance / b.radius);
      });
    stays_below(trial.name + ": overlap with the wall at the end, of a radius", deepest, 0.05,
                "contacts hold");
    EXPECT_GT(recorder.all.size(), 100U) << trial.name;
    const scene::EnergyBalance a = engine->energy_balance();
    stays_below(trial.name + ": energy from nowhere, of what was lost",
                std::abs(a.residual()) / a.lost(), 1e-3, "dem.32; what runs may have");
  }
}

TEST(MeshJar, a_ball_at_rest_in_a_corner_is_held_by_three_faces) {
  const Mesh mesh = mesh_of(box(0.04, 0.04, 0.04));
  const double r = 0.005;
  const Rotation q = rotation_about({1, 0, 0}, 0.6) * rotation_about({0, 1, 0}, 0.6);
  auto slippery = soft_pair(0.6, 0);
  slippery.rolling_friction = 0;
  const scene::Ball ball{r, 7850, {}, {}, {}};
  const auto engine = run_in(mesh, kinematics::Still{}, q, {ball}, 2e-6, 32, slippery);
  Recorder recorder;
  engine->advance(2, recorder);
  const Vec3 p = componentwise_abs(q.apply_inverse(engine->balls()[0].position));
  const Vec3 weight = ball.mass() * gravity * componentwise_abs(q.apply_inverse({0, 0, 1}));
  const auto place = [&](double load) {
    return 0.02 - r + std::pow(0.75 * load / (slippery.modulus * std::sqrt(r)), 2.0 / 3);
  };
  states("place along x [m]", p.x, place(weight.x), 1e-10,
         "Hertz under the weight across the wall");
  states("place along y [m]", p.y, place(weight.y), 1e-10,
         "Hertz under the weight across the wall");
  states("place along z [m]", p.z, place(weight.z), 1e-10,
         "Hertz under the weight across the wall");
}

/// The same bits in a mesh jar, however the run is cut.
TEST(MeshJar, cuts_change_no_bit) {
  const Mesh mesh = mesh_of(drum_with_lifters(0.06, 0.02, 5, 0.008, 0.003));
  for (const int count : {30, 50}) {
    Random random(9, 1);
    const auto balls = random_balls_in(mesh, count, 0.0015, random);
    const auto whole = run_in(mesh, kinematics::Tumbling{15}, lying, balls, 2e-6);
    const auto cut = run_in(mesh, kinematics::Tumbling{15}, lying, balls, 2e-6);
    Recorder a, b;
    whole->advance(0.05, a);
    for (const double t : {0.001, 0.0173, 0.03, 0.05}) cut->advance(t, b);
    EXPECT_EQ(apart(*whole, *cut), 0);
    EXPECT_EQ(a.all.size(), b.all.size());
  }
}

/// Engines keep the facets near each ball. One that is made anew from its state has none, and
/// searches the whole mesh.
TEST(MeshJar, kept_facets_change_no_bit_of_a_run) {
  // Facets an eighth of a ball wide: lists of them must be renewed.
  const Mesh mesh = mesh_of(ball_of_triangles(100, 0.012));
  for (const int count : {30, 50}) {
    Random random(10, 1);
    const auto balls = random_balls_in(mesh, count, 0.0015, random);
    const auto make = [&] { return run_in(mesh, kinematics::Tumbling{15}, lying, balls, 2e-6); };
    const auto whole = make();
    auto anew = make();
    Recorder a, b;
    for (int block = 1; block <= 20; ++block) {
      const double until = 0.002 * block;
      whole->advance(until, a);
      for (int k = 9; k >= 0; --k) {
        anew->advance(until - 2e-6 * k, b);
        Archive out;
        anew->serialize(out);
        Archive in(out.bytes());
        anew = make();
        anew->serialize(in);
      }
      ASSERT_EQ(apart(*whole, *anew), 0) << count << " balls at " << until << " s";
    }
    EXPECT_GT(a.all.size(), 20U) << count << " balls";
    EXPECT_EQ(a.all.size(), b.all.size());
  }
}

}  // namespace
}  // namespace mahlwerk::tests::mesh_test
