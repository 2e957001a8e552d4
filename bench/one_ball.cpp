// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// One ball in the vial of Chen et al. 2016: capsule of 12 mm, 10 Hz, 25 mm, e_n = e_t = 0.9.
// Conservative advancement with the whole engine and statistics, compared with textbook scanning,
// which only finds touches.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "benchmarks.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"

namespace mahlwerk::bench {
namespace {

constexpr double pi = std::numbers::pi, radius = 0.004, frequency = 10, amplitude = 0.025,
                 diameter = 0.012;
constexpr int runs = 7;

geometry::Capsule vial() {
  return {diameter,
          (5e-6 - pi * diameter * diameter * diameter / 6) / (pi * diameter * diameter / 4)};
}

struct Speed {
  double collisions, simulated, share;  // per CPU second, per CPU second, of time in contact
};

Speed engine(event::SustainedContactMode lasting, std::uint32_t stream) {
  kinematics::Vibration motion;
  motion.frequency = frequency;
  motion.amplitude = amplitude;
  const scene::Chamber mill{vial(), motion, {}, {0, 0, -9.81}};
  Random random(1, stream);
  const scene::Ball ball{radius,
                         7850,
                         {0, 0, random.uniform(-0.01, 0.01)},
                         random.uniform(0, 0.1) * random.direction(),
                         random.uniform(0, 0.1) * random.direction()};
  event::Rules rules;
  rules.bounce = {0.9, 0.9, INFINITY};
  rules.rolling_friction = 0.01;
  rules.sustained_mode = lasting;
  observe::CollisionStatistics tally(0.1);
  const auto running = event::one_ball(mill, ball, rules);
  constexpr double time = 3000;
  const double start = cpu_seconds();
  running->advance(time, tally);
  const double spent = cpu_seconds() - start;
  return {static_cast<double>(tally.all.count) / spent, time / spent,
          running->energy_balance().contact_time / time};
}

/// Textbook scanning: tests the gap every 0.1 ms and bisects the interval in which it closes. TC
/// rule, no statistics.
Speed scanning(std::uint32_t stream) {
  const double w = 2 * pi * frequency, h = 0.5 * vial().height, room = 0.5 * diameter - radius;
  Random random(1, stream);
  Vec3 r{0, 0, random.uniform(-0.01, 0.01)}, spin{};
  Vec3 v = random.uniform(0, 0.1) * random.direction() + Vec3{0, 0, amplitude * w};
  double t0 = 0, last = -1;
  long count = 0;
  constexpr double time = 300, step = 1e-4, g = 9.81;
  const auto from_core = [&](double t) {
    const double s = t - t0, z = r.z + s * v.z - 0.5 * g * s * s - amplitude * std::sin(w * t);
    return Vec3{r.x + s * v.x, r.y + s * v.y, z - std::clamp(z, -h, h)};
  };
  const auto inside = [&](double t) { return squared(from_core(t)) < room * room; };
  const double start = cpu_seconds();
  for (double t = 0; t < time;) {
    if (inside(t + step)) {
      t += step;
      continue;
    }
    double out = t, in = t + step;
    for (int i = 0; i < 45; ++i) (inside(0.5 * (out + in)) ? out : in) = 0.5 * (out + in);
    const double s = out - t0;
    const Vec3 e = from_core(out), n = e / norm(e), v1 = v - Vec3{0, 0, g * s};
    const Vec3 u = v1 - Vec3{0, 0, amplitude * w * std::cos(w * out)} + radius * cross(spin, n);
    const double un = dot(u, n);
    if (un <= 0) {
      t += step;
      continue;
    }
    const Vec3 ut = u - un * n;
    r = r + s * v - Vec3{0, 0, 0.5 * g * s * s};
    v = v1 - (1 + (out - last < 1e-4 ? 1.0 : 0.9)) * un * n - 2.0 / 70 * ut;
    spin -= 5.0 / 70 / radius * cross(n, ut);
    last = t0 = t = out;
    ++count;
  }
  const double spent = cpu_seconds() - start;
  return {static_cast<double>(count) / spent, time / spent, 0};
}

void add(std::vector<Row>& rows, const std::string& what, const std::string& code,
         const std::vector<Speed>& all, bool share) {
  const auto middle = [&](double Speed::*of) {
    std::vector<double> values;
    for (const Speed& s : all) values.push_back(s.*of);
    return median(values);
  };
  rows.push_back({"one-ball", what, code, "collisions_per_cpu_second", middle(&Speed::collisions)});
  rows.push_back(
      {"one-ball", what, code, "simulated_seconds_per_cpu_second", middle(&Speed::simulated)});
  if (share) rows.push_back({"one-ball", what, code, "contact_time_share", middle(&Speed::share)});
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

}  // namespace

std::vector<Row> one_ball() {
  std::vector<Speed> tc, roll, scan;
  engine(event::SustainedContactMode::tc, 99);  // warm-up
  const double memory = peak_memory_mb();
  for (std::uint32_t i = 0; i < runs; ++i) {  // in turn: drifts of the machine affect all alike
    tc.push_back(engine(event::SustainedContactMode::tc, i));
    roll.push_back(engine(event::SustainedContactMode::roll, i));
    scan.push_back(scanning(i));
  }
  std::vector<Row> rows;
  add(rows, "10 Hz 25 mm, TC 1e-4 s", "mahlwerk", tc, false);
  add(rows, "10 Hz 25 mm, TC 1e-4 s", "scan 0.1 ms", scan, false);
  add(rows, "10 Hz 25 mm, lasting contacts roll", "mahlwerk", roll, true);
  rows.push_back({"one-ball", "14 more runs of 3000 s", "mahlwerk", "peak_memory_growth_mb",
                  peak_memory_mb() - memory});
  return rows;
}

}  // namespace mahlwerk::bench
