// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>

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

}  // namespace
}  // namespace mahlwerk::campaign::checkpoint_test
