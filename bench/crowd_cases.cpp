// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "crowd_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// The lowest `count` points, in the order of `height`, of those points of a lattice of `pitch`
/// that `keep` accepts.
template <class Keep, class Height>
std::vector<Vec3> lattice(double pitch, int half, int count, const Keep& keep,
                          const Height& height) {
  std::vector<Vec3> places;
  for (int x = -half; x <= half; ++x)
    for (int y = -half; y <= half; ++y)
      for (int z = -half; z <= half; ++z) {
        const Vec3 place = pitch * Vec3{x + 0.3, y + 0.1, z + 0.2};
        if (keep(place)) places.push_back(place);
      }
  std::ranges::stable_sort(places, {}, height);
  places.resize(std::min(places.size(), static_cast<std::size_t>(count)));
  return places;
}

constexpr double drum_radius = 0.1;  // [m]

std::vector<scene::Ball> bed(int count, double diameter, double length, double speed) {
  const double room = drum_radius - diameter / 2 - 1e-6, along = length / 2 - diameter / 2 - 1e-6;
  const double lean = 46 * pi / 180;  // approximate slope of the bed in such a drum
  const Vec3 spin{speed, 0, 0};
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  for (const Vec3& x : lattice(
           1.004 * diameter, static_cast<int>(2 * drum_radius / diameter) + 2, count,
           [&](const Vec3& p) { return std::hypot(p.y, p.z) < room && std::abs(p.x) < along; },
           [&](const Vec3& p) { return p.z * std::cos(lean) - p.y * std::sin(lean); }))
    balls.push_back({diameter / 2, 2500, x,
                     cross(spin, x) + random.uniform(0, 0.05) * random.direction(), spin, 0});
  return balls;
}

constexpr double orbit = 0.07, disc_speed = 400.0 / 60 * 2 * pi;  // [m], [rad/s]
constexpr double vial_radius = 0.021, vial_height = 0.03248;      // [m]
constexpr double ball = 0.0075, grain = 0.0005;                   // [m] radii

std::vector<scene::Ball> balls_and_grains() {
  std::vector<scene::Ball> all;
  const Vec3 spin{0, 0, -disc_speed};
  const auto add = [&](const Vec3& x, double r, double density, int kind) {
    all.push_back({r, density, x, cross(spin, x), {}, kind});
  };
  const double low = 0.0085 - vial_height / 2, high = 0.0242 - vial_height / 2;
  for (const double a : {0.0, 120.0, 240.0})
    add({0.009 * std::cos(a * pi / 180), 0.009 * std::sin(a * pi / 180), low}, ball, 7700, 0);
  add({0.0085, 0, high}, ball, 7700, 0);
  add({-0.0085, 0, high}, ball, 7700, 0);
  const std::vector<scene::Ball> balls = all;
  const auto keep = [&](const Vec3& p) {
    if (std::hypot(p.x, p.y) > vial_radius - grain - 1e-6 ||
        std::abs(p.z) > vial_height / 2 - grain - 1e-6)
      return false;
    return std::ranges::all_of(
        balls, [&](const scene::Ball& b) { return norm(p - b.position) > ball + grain + 1e-6; });
  };
  for (const Vec3& x : lattice(2.008 * grain, 25, 20000, keep, [&](const Vec3& p) {
         return -std::hypot(p.x + orbit, p.y);  // outermost first
       }))
    add(x, grain, 4930, 1);
  return all;
}

/// Parameters that differ between the drums. All drums turn at 60 % of their critical speed.
struct Drum {
  int count;
  double diameter, length, speed;  // [m], [m], [rad/s]
  double step;                     // [s]
  int warm_up, steps;
  std::array<int, peers> peer_steps;
  double bending_stiffness;
};

constexpr std::array drums{
    Drum{10000, 0.005, 0.0992, 6.02, 1e-5, 10000, 2000, {2000, 1000, 300}, 2e-3},
    Drum{100000, 0.0025, 0.124, 5.98, 5e-6, 12000, 500, {500, 200, 30}, 2.5e-4},
    // The largest drum has only a short warm-up: it is for the cost curve.
    Drum{1000000, 0.00125, 0.155, 5.96, 2.5e-6, 1000, 100, {}, 0},
};

}  // namespace

CrowdCase drum(int count) {
  const Drum& d = *std::ranges::find(drums, count, &Drum::count);
  return {.name = fmt::format("drum-{}", count),
          .what = fmt::format("drum, {} balls", count),
          .mill = {geometry::Cylinder{2 * drum_radius, d.length},
                   kinematics::Tumbling{d.speed},
                   scene::mounted_along({1, 0, 0}),
                   {0, 0, -9.81}},
          .radius = drum_radius,
          .height = d.length,
          .fill = [&d] { return bed(d.count, d.diameter, d.length, d.speed); },
          .youngs_modulus = 1e8,
          .step = d.step,
          .warm_up = d.warm_up,
          .steps = d.steps,
          .peer_steps = d.peer_steps,
          .processors = "* 1 1",
          .search = "bin",
          .skin = 0.2 * d.diameter,
          .margin = 0.2,
          .rolling_stiffness = 0.0005 * 1e8,
          .bending_stiffness = d.bending_stiffness};
}

CrowdCase powder() {
  return {.name = "powder",
          .what = "planetary mill, 5 balls of 15 mm and 20 000 grains of 1 mm",
          .mill = {geometry::Cylinder{2 * vial_radius, vial_height},
                   kinematics::Planetary{orbit, disc_speed, -2},
                   {},
                   {0, 0, -9.81}},
          .radius = vial_radius,
          .height = vial_height,
          .fill = balls_and_grains,
          .youngs_modulus = 1e9,
          .step = 1e-6,
          .warm_up = 20000,
          .steps = 1000,
          .peer_steps = {1000, 200, 150},
          .processors = "1 1 *",
          .search = "multi",
          .skin = 4e-4,
          .margin = 0.1,
          .rolling_stiffness = 1e4,
          .bending_stiffness = 1.3e-4};
}

CrowdCase crowd_case(std::string_view name) {
  for (const Drum& d : drums)
    if (name == fmt::format("drum-{}", d.count)) return drum(d.count);
  return powder();
}

std::unique_ptr<scene::Engine> engine(const CrowdCase& c, const std::vector<scene::Ball>& balls,
                                      int threads, double start) {
  const contact::ElasticConstants e{c.youngs_modulus, 0.3};
  const contact::Pair pair{.modulus = contact::effective_modulus(e, e),
                           .shear_modulus = contact::effective_shear_modulus(e, e),
                           .restitution = 0.5,
                           .friction = 0.5,
                           .rolling_friction = 0.05};
  soft::Settings rules;
  rules.time_step = c.step;
  rules.threads = threads;
  rules.max_initial_overlap = 0.1;  // states in motion contain hard hits
  return soft::make_engine(c.mill, balls, rules, {2, geometry::Cylinder::faces, pair}, start);
}

}  // namespace mahlwerk::bench
