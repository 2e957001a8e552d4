// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Cases in LAMMPS beside the soft engine. Skipped where LAMMPS is not installed.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "lammps_cases.hpp"
#include "mahlwerk/campaign/run/lammps_runs.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/lammps/engine.hpp"
#include "mahlwerk/lammps/program.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "one_ball.hpp"
#include "program.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::lammps_translation {
namespace {

class Lammps : public ProgramTest {
 protected:
  void SetUp() override {
    const lammps::Installed lmp = lammps::installed(1);
    if (!lmp.faults.empty()) GTEST_SKIP() << lmp.faults.front().what;
    ProgramTest::SetUp();
  }
  void TearDown() override {
    if (!here_.empty()) ProgramTest::TearDown();
  }
};

cases::Case in_soft_engine(cases::Case mill_case) {
  mill_case.run.engine = cases::EngineName::soft;
  return mill_case;
}

/// The path of one ball, spinning, until after its second collision; later ones part by chaos.
void follows_the_soft_engine(const std::string& mill, const std::string& jar,
                             const std::vector<cases::Override>& set = {}) {
  cases::Case mill_case = lammps_case(mill, jar, 1, set);
  mill_case.run.start_speed = 1.5;
  mill_case.run.start_spin = 100;
  mill_case.run.time = 0.4;
  const auto theirs = campaign::engine(mill_case, 0),
             ours = campaign::engine(in_soft_engine(mill_case), 0);
  Recorder there, here;
  double apart = 0;
  for (double until = 0.001; until < 0.4 && here.all.size() < 2; until += 0.001) {
    theirs->advance(until, there);
    ours->advance(*theirs->balls_time(), here);
    apart =
        std::max(apart, norm(theirs->balls().front().position - ours->balls().front().position));
  }
  const scene::Ball a = theirs->balls().front(), b = ours->balls().front();
  const std::string what = fmt::format("{} in a {}: ", mill, jar);
  ASSERT_GE(std::min(here.all.size(), there.all.size()), 2U) << what;
  // Both take steps of about 1/50 of a collision, whose errors are 1 to 3 % of a rebound (dem.30):
  // at 2 m/s a millimetre after 50 ms.
  stays_below(what + "path apart [m]", apart, 1e-3, "the soft engine");
  stays_below(what + "velocity apart [m/s]", norm(a.velocity - b.velocity), 0.05,
              "the soft engine");
  stays_below(what + "spin apart [rad/s]", norm(a.spin - b.spin), 15, "the soft engine");
  for (std::size_t k = 0; k < 2; ++k) {
    const scene::Collision &c = there.all[k], &d = here.all[k];
    EXPECT_EQ(c.other, d.other) << what << "face of collision " << k;
    states(what + fmt::format("approach of collision {} [m/s]", k), c.approach, d.approach,
           0.03 * d.approach + 0.003, "the soft engine");
    states(what + fmt::format("place of collision {} [m]", k), norm(c.where - d.where), 0, 1e-3,
           "the soft engine");
  }
}

TEST_F(Lammps, a_ball_in_each_jar_on_each_mill_follows_the_soft_engine) {
  for (const char* mill : {"still", "vibration", "planetary", "tumbling", "circular"})
    for (const char* jar : {"cylinder", "capsule", "sphere", "box"})
      if (jar != std::string("capsule") || (mill[0] != 'p' && mill[0] != 't'))
        follows_the_soft_engine(mill, jar);
  follows_the_soft_engine("planetary", "cylinder", {{"mill.jar_axis", "horizontal"}});
  follows_the_soft_engine("vibration", "capsule", {{"mill.jar_axis", "horizontal"}});
  follows_the_soft_engine("vibration", "box", {{"contact.law", "linear-spring"}});
}

TEST_F(Lammps, two_balls_rebound_with_the_restitution_of_the_case) {
  for (const char* law : {"hertz-mindlin", "linear-spring"})
    for (const double e : {0.05, 0.35, 0.5, 0.9, 1.0}) {
      cases::Case mill_case = lammps_case(
          "still", "box", 2, {{"contact.law", law}, {"contact.restitution", fmt::format("{}", e)}});
      mill_case.gravity = 0;
      std::vector<scene::Ball> balls = cases::balls_by_set(mill_case.balls);
      balls[0].position = {-0.008, 0, 0};
      balls[1].position = {0.008, 0, 0};
      balls[0].velocity = {0.5, 0, 0};
      balls[1].velocity = {-0.5, 0, 0};
      const lammps::Launch launch;
      const auto engine = lammps::make_engine(mill_case, cases::chamber(mill_case), balls,
                                              *campaign::RunSetup(mill_case).steps, launch);
      Recorder seen;
      engine->advance(0.012, seen);
      const auto after = engine->balls();
      const std::string what = fmt::format("{}, e = {}: ", law, e);
      states(what + "rebound", after[1].velocity.x - after[0].velocity.x, e, 0.01, "dem.7, lmp.1");
      ASSERT_EQ(seen.all.size(), 1U) << what;
      states(what + "approach of the record", seen.all[0].approach, 1, 0.02, "lmp.10");
    }
}

/// Means over replicates of runs of 300 balls in a drum.
struct Means {
  observe::Estimate power, hits, kinetic, energy;
};
Means means_of(const cases::Case& mill_case, int ranks) {
  campaign::RunOptions options;
  options.lammps.ranks = ranks;
  const results::Outcome outcome = campaign::run(mill_case, options);
  std::vector<double> power, hits, kinetic, energy;
  for (const results::Replicate& r : outcome.replicates) {
    power.push_back((r.energy_balance.wall_work - r.at_settled.wall_work) / r.time());
    hits.push_back(static_cast<double>(r.tally.above.count) / r.time());
    energy.push_back(r.tally.above.energy_normal / r.time());
    double sum = 0;
    for (const results::Window& w : r.windows)
      sum += w.kinetic / static_cast<double>(r.windows.size());
    kinetic.push_back(sum);
  }
  return {observe::estimate(power), observe::estimate(hits), observe::estimate(kinetic),
          observe::estimate(energy)};
}

void agree(const std::string& what, const observe::Estimate& found,
           const observe::Estimate& expected, double known) {
  states(what, found.mean, expected.mean,
         std::hypot(found.ci95, expected.ci95) + known * expected.mean,
         "both 95 % intervals, and what lmp.10 leaves open");
}

TEST_F(Lammps, a_drum_draws_the_power_and_has_the_hits_of_the_soft_engine) {
  cases::Case mill_case = lammps_case("tumbling", "cylinder", 40,
                                      {{"run.replicates", "4"},
                                       {"run.settle", "0.5 s"},
                                       {"run.time", "1 s"},
                                       {"run.time_step", "10 us"}});
  const Means ours = means_of(in_soft_engine(mill_case), 1), theirs = means_of(mill_case, 1);
  agree("power [W]", theirs.power, ours.power, 0);
  agree("kinetic energy [J]", theirs.kinetic, ours.kinetic, 0);
  agree("hits above 0.1 m/s [1/s]", theirs.hits, ours.hits, 0.05);
  agree("their normal energy [W]", theirs.energy, ours.energy, 0.05);
}

/// [s] First touches of the contacts that have ended before a time [s].
std::vector<double> ended_before(double time, const Recorder& seen) {
  std::vector<double> begins;
  for (const scene::Collision& c : seen.all)
    if (c.time + c.duration < time) begins.push_back(c.time);
  std::ranges::sort(begins);
  return begins;
}

TEST_F(Lammps, a_run_that_was_stopped_goes_on_from_its_restart_file) {
  cases::Case mill_case = lammps_case("tumbling", "cylinder", 40);
  lammps::Launch launch{.folder = here_ / "run"};
  const auto count = [](const Recorder& seen) { return static_cast<double>(seen.all.size()); };
  Recorder whole, rest;
  {
    const auto engine = campaign::engine(mill_case, 0, 1, nullptr, {.folder = here_ / "whole"});
    engine->advance(0.2, whole);
  }
  {
    const auto engine = campaign::engine(mill_case, 0, 1, nullptr, launch);
    engine->advance(0.05, rest);
  }  // ends the process
  ASSERT_FALSE(std::filesystem::exists(launch.folder / "restart.end"));
  launch.resume = true;
  rest.all.clear();
  const auto engine = campaign::engine(mill_case, 0, 1, nullptr, launch);
  engine->advance(0.2, rest);
  std::ifstream restarted(launch.folder / "from.1.txt");
  std::int64_t step = 0;
  ASSERT_TRUE(restarted >> step);
  const double restart = static_cast<double>(step) * *mill_case.run.time_step;
  const std::vector<double> expected = ended_before(restart, whole);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(ended_before(restart, rest), expected);
  // Contacts that are open at the restart lose their beginning; after it, chaos parts the two.
  states("records of the resumed run", count(rest), count(whole), 0.1 * count(whole),
         "the run in one piece");
}

}  // namespace
}  // namespace mahlwerk::tests::lammps_translation
