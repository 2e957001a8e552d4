// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a wall of triangles costs: the same cylinder, balls and motion in the soft engine, once with
// the wall as a formula and once as meshes of about 1000, 12 000 and 120 000 triangles.
#include <fmt/format.h>

#include <numbers>

#include "charges.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::bench {
namespace {

using geometry::Corners;

/// A cylinder of nearly square cells of two triangles: `around` of them along the circumference.
geometry::Mesh cylinder_of_triangles(const geometry::Cylinder& c, int around) {
  const double r = 0.5 * c.diameter, cell = std::numbers::pi * c.diameter / around;
  const auto count = [&](double length) { return std::max(1, static_cast<int>(length / cell)); };
  const int rows = count(c.height), rings = count(r);
  const auto at = [&](double radius, int i, double z) {
    const double angle = 2 * std::numbers::pi * (i % around) / around;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), z};
  };
  std::vector<Corners> t;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < rows; ++k) {
      const double low = c.height * (1.0 * k / rows - 0.5);
      const double high = c.height * ((k + 1.0) / rows - 0.5);
      t.push_back({at(r, i, low), at(r, i + 1, low), at(r, i + 1, high)});
      t.push_back({at(r, i, low), at(r, i + 1, high), at(r, i, high)});
    }
    for (int k = 0; k < rings; ++k)
      for (const double z : {-0.5 * c.height, 0.5 * c.height}) {
        const Vec3 a = at(r * k / rings, i, z), b = at(r * (k + 1) / rings, i, z);
        const Vec3 d = at(r * (k + 1) / rings, i + 1, z), e = at(r * k / rings, i + 1, z);
        t.push_back(z > 0 ? Corners{a, b, d} : Corners{a, d, b});
        if (k > 0) t.push_back(z > 0 ? Corners{a, d, e} : Corners{a, e, d});
      }
  }
  return {geometry::weld(t), std::numbers::pi / 6};
}

struct MeshCase {
  std::string_view what;
  geometry::Cylinder jar;
  kinematics::AnyMotion motion;
  bool lying;  ///< the axis of the jar
  int balls;
  double radius, time;  ///< [m], [s] that a turn simulates
};

std::vector<MeshCase> mesh_cases() {
  const geometry::Cylinder vial{0.04, 0.04};
  const kinematics::Planetary mill{0.07, 41.9, -2};
  return {{"planetary mill, 5 balls of 10 mm", vial, mill, false, 5, 0.005, 0.1},
          {"planetary mill, 30 balls of 7 mm", vial, mill, false, 30, 0.0035, 0.03},
          {"drum, 300 balls of 10 mm", geometry::Cylinder{0.15, 0.1}, kinematics::Tumbling{7.9},
           true, 300, 0.005, 0.03}};
}

std::vector<scene::Ball> scattered(const MeshCase& c) {
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  // The facets of the coarsest mesh lie up to 0.6 % of the radius inside the cylinder.
  const double r = 0.497 * c.jar.diameter - 1.05 * c.radius;
  const double h = 0.5 * c.jar.height - 1.05 * c.radius;
  while (std::ssize(balls) < c.balls) {
    const double x = random.uniform(-r, r), y = random.uniform(-r, r), z = random.uniform(-h, h);
    const Vec3 p{x, y, z};
    const auto meets = [&](const scene::Ball& b) { return norm(b.position - p) < 2.01 * c.radius; };
    if (x * x + y * y > r * r || std::ranges::any_of(balls, meets)) continue;
    balls.push_back({c.radius, 7850, p, 0.1 * random.direction(), {}});
  }
  return balls;
}

/// The engine after the balls have fallen.
std::unique_ptr<scene::Engine> settled(const MeshCase& c, const geometry::AnyShape& shape) {
  const Rotation mount = c.lying ? scene::mounted_along({1, 0, 0}) : Rotation{};
  std::vector<scene::Ball> balls = scattered(c);
  for (scene::Ball& b : balls) b.position = mount * b.position;
  contact::Pair pair{.restitution = 0.6, .friction = 0.3, .rolling_friction = 0.02};
  const contact::ElasticConstants softened{1e9, 0.3};
  pair.modulus = contact::effective_modulus(softened, softened);
  pair.shear_modulus = contact::effective_shear_modulus(softened, softened);
  soft::Settings rules{.model = {.law = contact::HertzMindlin{}, .rolling = contact::Rolling::cdt},
                       .time_step = 2e-6};
  const contact::PairTable pairs(1, geometry::faces(shape), pair);
  auto engine = soft::make_engine({shape, c.motion, mount, {0, 0, -9.81}}, balls, rules, pairs);
  Counter counter;
  engine->advance(0.1, counter);
  return engine;
}

/// Times the walls in turns: CPU s for the time of the case.
void time_case(const MeshCase& c,
               const std::vector<std::pair<std::string, geometry::AnyShape>>& walls,
               std::vector<Row>& rows) {
  constexpr int turns = 5;
  std::vector<std::unique_ptr<scene::Engine>> engines;
  for (const auto& [name, shape] : walls) engines.push_back(settled(c, shape));
  std::vector<std::vector<double>> seconds(walls.size()), ratios(walls.size());
  Counter counter;
  for (int turn = 1; turn <= turns; ++turn)
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const double began = cpu_seconds();
      engines[k]->advance(0.1 + turn * c.time, counter);
      seconds[k].push_back(cpu_seconds() - began);
      ratios[k].push_back(seconds[k].back() / seconds[0].back());
    }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Spread ratio = spread(ratios[k]);
    const std::string what(c.what);
    rows.push_back({"mesh", what, walls[k].first, "cpu_s_per_second", median(seconds[k]) / c.time});
    if (k > 0)
      rows.push_back({"mesh", what, walls[k].first, "times_the_cylinder", ratio.middle, ratio.least,
                      ratio.most});
  }
}

}  // namespace

std::vector<Row> mesh() {
  std::vector<Row> rows;
  for (const MeshCase& c : mesh_cases()) {
    std::vector<std::pair<std::string, geometry::AnyShape>> walls{{"cylinder", c.jar}};
    for (const int around : {30, 100, 310}) {
      const geometry::Mesh wall = cylinder_of_triangles(c.jar, around);
      walls.emplace_back(fmt::format("{} triangles", wall.surface().triangles.size()), wall);
    }
    time_case(c, walls, rows);
  }
  return rows;
}

}  // namespace mahlwerk::bench
