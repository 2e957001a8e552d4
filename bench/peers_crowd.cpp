// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Many balls beside LAMMPS: drums of 10 000 and 100 000 spheres, and five balls among 20 000 grains
// in a planetary mill. Both go on from one state in motion, in turns, on one core and on two.
#include <fmt/format.h>
#include <fmt/os.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "child.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/soft/engine.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 3;
constexpr double pi = std::numbers::pi;

struct Nobody final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

struct CrowdCase {
  std::string what;
  scene::Chamber mill;
  std::vector<scene::Ball> balls;  // before the warming up
  double youngs_modulus, step, warm_up;
  int steps;                            // measured
  std::string jar, processors, search;  // for LAMMPS
  double skin;                          // for LAMMPS, about its best
};

/// Balls on a lattice of `pitch`, where `keep` says so, in the order of `height`, the lowest
/// `count`.
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

CrowdCase drum(int count, double diameter, double length, double speed, double step, double warm_up,
               int steps) {
  constexpr double radius = 0.1;
  const scene::Chamber mill{geometry::Cylinder{2 * radius, length},
                            kinematics::Tumbling{speed},
                            scene::mounted_along({1, 0, 0}),
                            {0, 0, -9.81}};
  const double room = radius - diameter / 2 - 1e-6, along = length / 2 - diameter / 2 - 1e-6;
  const double lean = 46 * pi / 180;  // about where the bed of such a drum lies
  CrowdCase c{fmt::format("drum, {} balls", count),
              mill,
              {},
              1e8,
              step,
              warm_up,
              steps,
              "",
              "",
              "bin",
              0.2 * diameter};
  Random random(1, 0);
  for (const Vec3& x : lattice(
           1.004 * diameter, static_cast<int>(2 * radius / diameter) + 2, count,
           [&](const Vec3& p) { return std::hypot(p.y, p.z) < room && std::abs(p.x) < along; },
           [&](const Vec3& p) { return p.z * std::cos(lean) - p.y * std::sin(lean); })) {
    const Vec3 spin{speed, 0, 0};
    c.balls.push_back({diameter / 2, 2500, x,
                       cross(spin, x) + random.uniform(0, 0.05) * random.direction(), spin, 0});
  }
  c.jar = fmt::format(
      "variable turned equal {}*step\nregion jar cylinder x 0 0 {} {} {} side in rotate v_turned 0 "
      "0 "
      "0 1 0 0\n",
      speed * step, radius, -length / 2, length / 2);
  c.processors = "* 1 1";
  return c;
}

CrowdCase powder() {
  constexpr double orbit = 0.07, speed = 400.0 / 60 * 2 * pi, radius = 0.021, height = 0.03248;
  constexpr double ball = 0.0075, grain = 0.0005, step = 1e-6;
  const scene::Chamber mill{geometry::Cylinder{2 * radius, height},
                            kinematics::Planetary{orbit, speed, -2},
                            {},
                            {0, 0, -9.81}};
  CrowdCase c{"planetary mill, 5 balls of 15 mm and 20 000 grains of 1 mm",
              mill,
              {},
              1e9,
              step,
              0.02,
              1000,
              "",
              "1 1 *",
              "multi",
              4e-4};
  const Vec3 spin{0, 0, -speed};
  const auto add = [&](const Vec3& x, double r, double density, int kind) {
    c.balls.push_back({r, density, x, cross(spin, x), {}, kind});
  };
  const double low = 0.0085 - height / 2, high = 0.0242 - height / 2;
  for (const double a : {0.0, 120.0, 240.0})
    add({0.009 * std::cos(a * pi / 180), 0.009 * std::sin(a * pi / 180), low}, ball, 7700, 0);
  add({0.0085, 0, high}, ball, 7700, 0);
  add({-0.0085, 0, high}, ball, 7700, 0);
  const std::vector<scene::Ball> balls = c.balls;
  const auto keep = [&](const Vec3& p) {
    if (std::hypot(p.x, p.y) > radius - grain - 1e-6 || std::abs(p.z) > height / 2 - grain - 1e-6)
      return false;
    return std::ranges::all_of(
        balls, [&](const scene::Ball& b) { return norm(p - b.position) > ball + grain + 1e-6; });
  };
  for (const Vec3& x : lattice(2.008 * grain, 25, 20000, keep, [&](const Vec3& p) {
         return -std::hypot(p.x + orbit, p.y);  // outwards first
       }))
    add(x, grain, 4930, 1);
  c.jar = fmt::format(
      "variable dx equal {0}*cos({1}*step)-{0}\nvariable dy equal {0}*sin({1}*step)\nvariable "
      "turned "
      "equal -{1}*step\nregion jar cylinder z {0} 0 {2} {3} {4} side in move v_dx v_dy NULL rotate "
      "v_turned {0} 0 0 0 0 1\n",
      orbit, speed * step, radius, -height / 2, height / 2);
  return c;
}

std::unique_ptr<scene::Engine> engine(const CrowdCase& c, const std::vector<scene::Ball>& balls,
                                      int threads, double start) {
  const contact::Elastic e{c.youngs_modulus, 0.3};
  const contact::Pair pair{.modulus = contact::effective_modulus(e, e),
                           .shear_modulus = contact::effective_shear_modulus(e, e),
                           .restitution = 0.5,
                           .friction = 0.5,
                           .rolling_friction = 0.05};
  soft::Rules rules;
  rules.time_step = c.step;
  rules.threads = threads;
  rules.most_overlap = 0.1;  // states in motion hold hard hits
  return soft::engine(c.mill, balls, rules, {2, geometry::Cylinder::faces, pair}, start);
}

/// Writes a state for LAMMPS, in the laboratory frame as it is after whole turns of the mill.
void write_state(const std::filesystem::path& folder, const CrowdCase& c,
                 const std::vector<scene::Ball>& balls) {
  const auto ride = std::visit([](const auto& m) { return m.ride(0); }, c.mill.motion);
  fmt::ostream out = fmt::output_file((folder / "state.data").string());
  int types = 1;
  for (const scene::Ball& b : balls) types = std::max(types, b.kind + 1);
  out.print("state\n\n{} atoms\n{} atom types\n\n", balls.size(), types);
  for (const char* axis : {"x", "y", "z"}) out.print("-0.2 0.2 {0}lo {0}hi\n", axis);
  out.print("\nAtoms\n\n");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    const Vec3 x = b.position + ride.centre;
    out.print("{} {} {:.12g} {:.12g} {:.15g} {:.15g} {:.15g}\n", i + 1, b.kind + 1, 2 * b.radius,
              b.density, x.x, x.y, x.z);
  }
  out.print("\nVelocities\n\n");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const scene::Ball& b = balls[i];
    const Vec3 v = b.velocity + ride.velocity;
    out.print("{} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", i + 1, v.x, v.y, v.z,
              b.spin.x, b.spin.y, b.spin.z);
  }
}

struct Told {
  double speed = 0, kinetic = 0;  // particle-steps/s, J
  std::string fault;
};

Told by_lammps(const CrowdCase& c, const std::vector<scene::Ball>& balls, int cores) {
  const TemporaryFolder folder;
  write_state(folder.path(), c, balls);
  {
    fmt::ostream out = fmt::output_file((folder.path() / "case.in").string());
    out.print(
        "variable processors string \"{}\"\nvariable step_time equal {}\nvariable skin equal {}\n",
        c.processors, c.step, c.skin);
    out.print("variable search string {}\nvariable youngs_modulus equal {}\n", c.search,
              c.youngs_modulus);
    out.print("variable rolling_stiffness equal {}\n",
              c.search == "multi" ? 1e4 : 0.0005 * c.youngs_modulus);
    fmt::output_file((folder.path() / "jar.in").string()).print("{}", c.jar);
  }
  std::vector<std::string> words;
  if (cores > 1) words = {"mpirun", "--oversubscribe", "-np", fmt::format("{}", cores)};
  for (const std::string& w :
       {std::string("lmp"), std::string("-in"),
        fmt::format("{}/bench/peers/crowd.lmp", MAHLWERK_HOME), std::string("-log"),
        std::string("log.txt"), std::string("-screen"), std::string("none"), std::string("-var"),
        std::string("steps"), fmt::format("{}", c.steps)})
    words.push_back(w);
  const Child child{
      words,
      folder.path(),
      {"OMP_NUM_THREADS=1", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"},
      600};
  Told told;
  told.fault = run_child(child, [](std::string_view) {});
  std::ifstream log(folder.path() / "log.txt");
  double seconds = NAN, kinetic = 0, spinning = 0;
  long step = 0;
  for (std::string line; std::getline(log, line);) {
    if (line.find("ERROR") != line.npos) told.fault = line;
    double a = 0, b = 0;
    if (std::sscanf(line.c_str(), "%ld %lf %lf", &step, &a, &b) == 3 && step == c.steps)
      kinetic = a, spinning = b;
    std::sscanf(line.c_str(), "Loop time of %lf", &seconds);
  }
  if (told.fault.empty() && !std::isfinite(seconds)) told.fault = "did not come to its end";
  told.speed = static_cast<double>(balls.size()) * c.steps / seconds;
  told.kinetic = kinetic + spinning;
  return told;
}

Told by_us(const CrowdCase& c, const std::vector<scene::Ball>& balls, int cores) {
  using Clock = std::chrono::steady_clock;
  const auto run = engine(c, balls, cores, 0);
  Nobody nobody;
  const Clock::time_point began = Clock::now();
  run->advance(c.steps * c.step, nobody);
  const double taken = std::chrono::duration<double>(Clock::now() - began).count();
  return {static_cast<double>(balls.size()) * c.steps / taken, run->account().kinetic, ""};
}

/// After `time`, as LAMMPS has it at its time 0: the mill stands as it did at the start.
std::vector<scene::Ball> warmed_up(const CrowdCase& c) {
  // The last instant at which the mill is where it began is the end.
  const auto run = engine(c, c.balls, 2, -c.warm_up);
  Nobody nobody;
  run->advance(c.warm_up, nobody);
  return run->balls();
}

void add(std::vector<Row>& rows, const CrowdCase& c) {
  fmt::print(stderr, "crowd: {}, warming up\n", c.what);
  const std::vector<scene::Ball> balls = warmed_up(c);
  const bool lammps = !find_program("lmp").empty(), two = lammps && !find_program("mpirun").empty();
  for (const int cores : {1, 2}) {
    std::vector<double> ours, theirs;
    Told us, them;
    for (int turn = 0; turn < turns; ++turn) {
      fmt::print(stderr, "crowd: {}, {} core(s), turn {} of {}\n", c.what, cores, turn + 1, turns);
      ours.push_back((us = by_us(c, balls, cores)).speed);
      if (!(cores == 1 ? lammps : two)) continue;
      them = by_lammps(c, balls, cores);
      if (them.fault.empty())
        theirs.push_back(them.speed);
      else
        fmt::print(stderr, "crowd: LAMMPS {}\n", them.fault);
    }
    const std::string unit = cores == 1 ? "" : "_two_cores";
    const auto row = [&](const std::string& code, std::vector<double> all) {
      const auto [least, most] = std::ranges::minmax(all);
      rows.push_back(
          {"crowd", c.what, code, "particle_steps_per_second" + unit, median(all), least, most});
    };
    row("mahlwerk", ours);
    if (theirs.empty()) continue;
    row("LAMMPS", theirs);
    rows.push_back({"crowd", c.what, "mahlwerk", "times_as_fast_as_LAMMPS" + unit,
                    median(ours) / median(theirs)});
    if (cores > 1) continue;
    rows.push_back({"crowd", c.what, "mahlwerk", "kinetic_energy_J", us.kinetic});
    rows.push_back({"crowd", c.what, "LAMMPS", "kinetic_energy_J", them.kinetic});
  }
}

}  // namespace

std::vector<Row> crowd() {
  std::vector<Row> rows;
  add(rows, drum(10000, 0.005, 0.0992, 6.02, 1e-5, 0.1, 2000));
  add(rows, powder());
  add(rows, drum(100000, 0.0025, 0.124, 5.98, 5e-6, 0.06, 200));
  return rows;
}

}  // namespace mahlwerk::bench
