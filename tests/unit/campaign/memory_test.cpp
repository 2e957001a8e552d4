// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/memory.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"
#include "statement.hpp"

namespace mahlwerk::campaign::memory_test {
namespace {

cases::Case drum(std::int64_t balls, std::int64_t replicates) {
  cases::Case c;
  c.mill.motion = kinematics::Tumbling{};
  c.jar.shape = geometry::Cylinder{0.2, 0.2};
  c.balls = {{balls, 2e-3, 7850, ""}};
  c.contact.lasting = cases::SustainedContactModel::tc;
  c.run.time = 1e-4;
  c.run.replicates = replicates;
  return c;
}

/// A temporary root folder for system files (proc, sys), removed by the destructor.
class System {
 public:
  System() {
    std::string name = (std::filesystem::temp_directory_path() / "mahlwerk-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) root = name;
  }
  ~System() {
    std::error_code ignored;
    std::filesystem::remove_all(root, ignored);
  }
  System(const System&) = delete;
  System& operator=(const System&) = delete;
  void file(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories((root / path).parent_path());
    std::ofstream(root / path) << text;
  }
  std::filesystem::path root;
};

TEST(Memory, is_what_the_machine_has_or_the_control_group_leaves) {
  const System system;
  EXPECT_EQ(memory_available(system.root), std::nullopt);
  system.file("proc/meminfo", "MemTotal: 900 kB\nMemFree: 1 kB\nMemAvailable:  500 kB\n");
  EXPECT_EQ(memory_available(system.root), 500 * 1024);
  system.file("sys/fs/cgroup/memory.max", "max\n");
  system.file("sys/fs/cgroup/memory.current", "100\n");
  EXPECT_EQ(memory_available(system.root), 500 * 1024);
  system.file("sys/fs/cgroup/memory.max", "1000\n");
  EXPECT_EQ(memory_available(system.root), 900);
  system.file("sys/fs/cgroup/memory/memory.limit_in_bytes", "300\n");
  system.file("sys/fs/cgroup/memory/memory.usage_in_bytes", "400\n");
  EXPECT_EQ(memory_available(system.root), 0);
}

TEST(Memory, grows_with_the_balls_and_with_the_replicates_at_once) {
  const double few = memory_needed(drum(1000, 1)), many = memory_needed(drum(100000, 1));
  EXPECT_GT(many, 50e6);
  EXPECT_LT(few, 10e6);
  EXPECT_TRUE(memory_faults({drum(100000, 2)}, 2, 2.01 * many).empty());
  EXPECT_FALSE(memory_faults({drum(100000, 2)}, 2, 1.99 * many).empty());
  EXPECT_TRUE(memory_faults({drum(100000, 2)}, 1, 1.01 * many).empty());
  EXPECT_TRUE(memory_faults({drum(100000, 2)}, 2, std::nullopt).empty());
}

TEST(Memory, that_does_not_suffice_is_told_with_its_remedy) {
  const double each = memory_needed(drum(100000, 3));
  const Fault threads = memory_faults({drum(100000, 3)}, 3, 2.5 * each).at(0);
  EXPECT_EQ(threads.code, "not-enough-memory");
  EXPECT_NE(threads.what.find("1e+05 balls in 3 replicates at once need about"), std::string::npos)
      << threads.what;
  EXPECT_NE(threads.remedy.find("--threads 2"), std::string::npos) << threads.remedy;
  const Fault size = memory_faults({drum(100000, 1)}, 3, 0.5 * each).at(0);
  EXPECT_NE(size.remedy.find("fewer or larger balls: one replicate of about 4.9e+04 balls fits"),
            std::string::npos)
      << size.remedy;
}

TEST(Memory, of_ended_replicates_grows_with_their_number_and_is_refused_before_they_run) {
  const double each = memory_kept(drum(5, 1));
  EXPECT_GT(each, 1e5);
  EXPECT_LT(each, 1e6);
  const double some = memory_of_run({drum(5, 2000)}, 2), more = memory_of_run({drum(5, 3000)}, 2);
  EXPECT_NEAR(more - some, 1000 * each, 1);
  EXPECT_TRUE(memory_faults({drum(5, 10000)}, 2, 10100 * each).empty());
  const Fault fault = memory_faults({drum(5, 10000)}, 2, 9000 * each).at(0);
  EXPECT_EQ(fault.code, "not-enough-memory");
  EXPECT_NE(fault.remedy.find("fewer run.replicates"), std::string::npos) << fault.remedy;
}

/// A result keeps less than is stated, also where every cell of its maps is counted into.
TEST(Memory, stated_for_an_ended_replicate_holds_its_statistics) {
  const cases::Case full = drum(5, 1);
  results::Replicate ended = results::empty_replicate(full);
  for (int cell = 0; cell < observe::WallGrid::cells; ++cell)
    ended.tally.wall_map.at(cell).count = 1;
  Archive archive;
  ended.charge.serialize(archive);
  ended.tally.serialize(archive);
  EXPECT_GT(archive.bytes().size(), observe::WallGrid::cells * sizeof(observe::WallSums));
  EXPECT_LT(static_cast<double>(archive.bytes().size()), memory_kept(full));
}

/// Bytes of a replicate: of its state, which has no zeros of maps and spectra, and of its numbers.
double bytes_of(results::Replicate& r) {
  Archive archive;
  r.charge.serialize(archive);
  r.tally.serialize(archive);
  std::size_t bytes =
      sizeof r + archive.bytes().size() + r.windows.size() * sizeof(results::Window);
  if (r.read_before)
    bytes += r.read_before->values.size() * sizeof(double) +
             r.read_before->bed.size() * sizeof(results::BedPoint);
  return static_cast<double>(bytes);
}

TEST(Memory, stated_for_a_replicate_that_is_summed_up_holds_what_it_keeps_and_is_less) {
  const cases::Case full = drum(5, 100);
  results::Replicate ended = results::empty_replicate(full);
  for (int cell = 0; cell < observe::WallGrid::cells; ++cell)
    ended.tally.wall_map.at(cell).count = 1;
  for (int pair = 0; pair < ended.tally.by_pair.pairs(); ++pair)
    for (int bin = 0; bin < observe::LogHistogram::bins; ++bin)
      ended.tally.by_pair.at(pair).spectra.energy_normal.add(observe::LogHistogram::lower(bin));
  ended.charge = observe::Charge(cases::chamber(full), 0.2);
  scene::Ball ball;
  ball.radius = 1e-3;
  ended.charge.sample(0, {ball}, 1);
  ended.windows.resize(200);
  ended.energy_balance.time = 1;
  results::Outcome outcome{.mill_case = full, .replicates = {100, ended}};
  const double whole = bytes_of(outcome.replicates[50]);
  results::SummingUp sums(outcome);
  for (std::size_t k = 0; k < 100; ++k) sums.ended(k);
  const double kept = bytes_of(outcome.replicates[50]), stated = memory_kept(full, true);
  tests::stays_below("bytes of a replicate", kept, stated, "what is summed up is let go");
  EXPECT_GT(whole, stated) << "the same before it is summed up";
  EXPECT_LT(stated, 0.2 * memory_kept(full));
  EXPECT_EQ(memory_kept(drum(5, 32), true), memory_kept(drum(5, 32))) << "too few to sum up";
}

TEST(Memory, is_looked_at_before_a_run_starts) {
  RunOptions options;
  options.threads = 1;
  options.memory = 1e6;
  EXPECT_THROW(run(drum(50, 1), options), InputError);
  options.memory = 1e9;
  EXPECT_EQ(run(drum(50, 1), options).replicates.size(), 1U);
}

}  // namespace
}  // namespace mahlwerk::campaign::memory_test
