// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <utility>

#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::checkpoint_test {
namespace {

namespace fs = std::filesystem;
using cases::sample::Folder;
using cases::sample::read_sample;
using cases::sample::vial;

constexpr double always = -1;  // [s] interval between states; negative: a state is always due

TEST(Checkpoint, one_that_cannot_be_written_is_told_once_until_it_can_be_again) {
  const Folder folder;
  const fs::path file = folder.path() / "states";
  fs::create_directories(file / "in the way");
  ReplicateRun replica(read_sample(vial), 0);
  int told = 0;
  Checkpoint states(file, "a run", 1, always, [&](const Fault& why) {
    ++told;
    EXPECT_EQ(why.code, "bad-checkpoint");
    EXPECT_EQ(why.where, file.generic_string());
  });
  for (int i = 0; i < 3; ++i) states.save(0, replica), states.flush();
  EXPECT_EQ(told, 1);
  EXPECT_TRUE(states.write_error());
  EXPECT_FALSE(fs::exists(file.string() + ".part")) << "nothing half written stays";
  fs::remove_all(file);
  states.save(0, replica), states.flush();
  EXPECT_FALSE(states.write_error());
  EXPECT_TRUE(fs::is_regular_file(file));
}

TEST(Checkpoint, what_a_killed_process_left_half_written_is_removed) {
  const Folder folder;
  const fs::path part = folder.path() / "states.part";
  std::ofstream(part) << "half";
  const Checkpoint states(folder.path() / "states", "a run", 1, always);
  EXPECT_FALSE(fs::exists(part));
}

TEST(Checkpoint, one_that_nobody_asked_for_is_written_after_its_time_only) {
  const Folder folder;
  ReplicateRun replica(read_sample(vial), 0);
  for (const auto& [after, there] : {std::pair(1e6, false), std::pair(0.0, true)}) {
    Checkpoint states(folder.path() / "states", "a run", 1, always, {},
                      Checkpoint::Unasked{.after = after});
    states.save(0, replica), states.flush(), states.write_if_due();
    EXPECT_EQ(fs::exists(states.file()), there) << after << " s";
    EXPECT_EQ(states.written(), there) << after << " s";
  }
  Checkpoint resumed(folder.path() / "states", "a run", 1, always, {},
                     Checkpoint::Unasked{.after = 1e6});
  resumed.load();
  EXPECT_TRUE(resumed.has_state(0));
}

TEST(Checkpoint, states_beyond_the_memory_for_unasked_ones_are_not_kept) {
  const Folder folder;
  ReplicateRun replica(read_sample(vial), 0);
  Archive archive;
  replica.serialize(archive);
  const std::size_t one = archive.bytes().size();
  for (const auto& [most, kept] : {std::pair(2 * one, true), std::pair(2 * one - 1, false)}) {
    Checkpoint states(folder.path() / "states", "a run", 2, always, {},
                      Checkpoint::Unasked{.after = 0, .most = most});
    for (const std::size_t job : {0U, 1U, 1U}) states.save(job, replica);  // one of them twice
    EXPECT_EQ(states.has_state(0), kept) << most << " bytes";
    EXPECT_EQ(states.has_state(1), kept) << most << " bytes";
  }
}

}  // namespace
}  // namespace mahlwerk::campaign::checkpoint_test
