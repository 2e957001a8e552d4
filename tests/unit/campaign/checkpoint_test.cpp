// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "mahlwerk/campaign/run/state_file.hpp"
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

TEST(Checkpoint, states_are_in_memory_until_the_file_has_them_and_are_read_back_from_it) {
  const Folder folder;
  StateFile first(folder.path() / "states", "a run", 3);
  const std::string large(3U << 20U, 'x');  // more than is read at a time
  first.set(0, large);
  first.set(2, "two");
  EXPECT_EQ(first.in_memory(), large.size() + 3);
  first.write();
  EXPECT_EQ(first.in_memory(), 0U);
  EXPECT_EQ(first.in_file(), large.size() + 3);
  first.set(2, "newer");
  EXPECT_EQ(first.in_memory(), 5U);
  first.write();  // copies the first state from the old file
  StateFile again(folder.path() / "states", "a run", 3);
  again.load();
  for (StateFile* states : {&first, &again}) {
    EXPECT_EQ(states->bytes(), large.size() + 5);
    EXPECT_EQ(states->in_memory(), 0U);
    EXPECT_TRUE(states->state(0) == large);
    EXPECT_FALSE(states->has(1));
    EXPECT_EQ(states->state(2), "newer");
  }
  StateFile other(folder.path() / "states", "another run", 3);
  EXPECT_THROW(other.load(), InputError);
}

TEST(Checkpoint, states_in_a_file_that_was_removed_are_gone_and_others_are_written_all_the_same) {
  const Folder folder;
  StateFile states(folder.path() / "states", "a run", 2);
  states.set(0, "old");
  states.write();
  fs::remove(states.file());
  EXPECT_THROW((void)states.state(0), InputError);
  states.set(1, "new");
  states.write();
  EXPECT_FALSE(states.has(0));
  EXPECT_EQ(states.state(1), "new");
}

TEST(Checkpoint, one_with_a_changed_or_missing_byte_is_refused) {
  const Folder folder;
  StateFile states(folder.path() / "states", "a run", 2);
  states.set(0, "zero");
  states.write();
  std::ifstream in(states.file(), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  const auto refused = [&](const std::string& bytes) {
    std::ofstream(states.file(), std::ios::binary) << bytes;
    StateFile read(states.file(), "a run", 2);
    EXPECT_THROW(read.load(), InputError) << bytes.size() << " bytes";
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    refused(changed);
    refused(whole.substr(0, i));
  }
}

TEST(Checkpoint, states_that_nobody_asked_for_are_written_once_they_fill_the_memory) {
  const Folder folder;
  ReplicateRun replica(read_sample(vial), 0);
  Archive archive;
  replica.serialize(archive);
  const std::size_t jobs = Checkpoint::most_in_memory / archive.bytes().size() + 1;
  Checkpoint states(folder.path() / "states", "a run", jobs, 1e9, {},
                    Checkpoint::Unasked{.after = 1e6});
  for (std::size_t job = 0; job < jobs; ++job) {
    EXPECT_FALSE(fs::exists(states.file())) << job << " of " << jobs;
    states.save(job, replica), states.write_if_due();
  }
  EXPECT_TRUE(fs::exists(states.file()));
}

}  // namespace
}  // namespace mahlwerk::campaign::checkpoint_test
