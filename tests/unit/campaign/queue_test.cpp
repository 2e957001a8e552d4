// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::queue_test {
namespace {

using cases::sample::Folder;
using cases::sample::read_sample;
using cases::sample::vial;
using cases::sample::with;

TEST(Queue, a_point_fails_once_and_when_none_of_its_replicates_is_at_work) {
  struct Watch : scene::Observer {
    explicit Watch(std::atomic<int>& count) : alive(count) { ++alive; }
    ~Watch() override { --alive; }
    void collisions(std::span<const scene::Collision>) override {}
    std::atomic<int>& alive;
  };
  std::atomic<int> alive = 0, failed = 0, done = 0, at_work = -1;
  RunQueue queue;
  queue.size = 1;
  queue.open = [](std::size_t) {  // far longer than a test: only the failure ends the run
    return read_sample(with(vial, "time", "time = \"1 Ms\"\nreplicates = 6"));
  };
  queue.done = [&](std::size_t, results::Outcome&&) { ++done; };
  queue.failed = [&](std::size_t, const std::exception&) {
    ++failed;
    at_work = alive.load();
  };
  RunOptions options;
  options.threads = 4;
  options.records = [&](std::size_t, int replicate) {
    if (replicate == 3) {  // fails while the first three are at work
      while (alive < 3) std::this_thread::yield();
      throw std::runtime_error("this replicate cannot begin");
    }
    return std::make_unique<Watch>(alive);
  };
  run_queue(queue, options);
  EXPECT_EQ(failed, 1);
  EXPECT_EQ(done, 0);
  EXPECT_EQ(at_work, 0);
}

TEST(Queue, what_cannot_be_opened_ends_all_threads_where_nobody_takes_failures) {
  RunQueue queue;
  queue.size = 40;
  queue.open = [](std::size_t i) {
    if (i == 7) throw InputError(Fault{"case", "this one is wrong", "", ""});
    return read_sample(with(vial, "time", "time = \"0.1 s\""));
  };
  queue.done = [](std::size_t, results::Outcome&&) {};
  RunOptions options;
  options.threads = 4;
  EXPECT_THROW(run_queue(queue, options), InputError);
}

TEST(Queue, trouble_with_files_is_no_failure_of_a_point) {
  int failed = 0;
  RunQueue queue;
  queue.size = 3;
  queue.done = [](std::size_t, results::Outcome&&) {};
  queue.failed = [&](std::size_t, const std::exception&) { ++failed; };
  RunOptions options;
  options.threads = 2;
  queue.open = [](std::size_t) -> cases::Case {
    throw InputError(Fault{"out", "the disk is full", "make room", "cannot-write"});
  };
  EXPECT_THROW(run_queue(queue, options), InputError);
  queue.open = [](std::size_t) -> cases::Case {
    throw std::filesystem::filesystem_error("no folder", std::make_error_code(std::errc::io_error));
  };
  EXPECT_THROW(run_queue(queue, options), std::filesystem::filesystem_error);
  EXPECT_EQ(failed, 0);
}

TEST(Queue, replicates_that_ended_before_a_state_was_due_are_there_after_a_stop) {
  const Folder folder;
  const cases::Case mill_case =
      read_sample(with(vial, "time", "time = \"2000 s\"\nreplicates = 3"));
  std::atomic<bool> stop = false;
  results::Outcome whole, again;
  const auto run = [&](Checkpoint& states, bool no_further, results::Outcome& outcome) {
    RunQueue queue;
    queue.size = 1;
    queue.open = [&](std::size_t) {
      stop = no_further;  // nothing more is computed
      return mill_case;
    };
    queue.done = [&](std::size_t, results::Outcome&& ended) { outcome = std::move(ended); };
    queue.checkpoint_slot = [&](std::size_t) {
      return CheckpointSlot{.checkpoint = &states, .on_end = CheckpointSlot::OnEnd::write_when_due};
    };
    RunOptions options;
    options.threads = 1;
    options.stop = &stop;
    run_queue(queue, options);
  };
  constexpr double never = 1e9;  // [s]
  Checkpoint first(folder.path() / "states", "a run", 3, never);
  run(first, false, whole);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "states")) << "nothing was due";
  first.flush();
  Checkpoint second(folder.path() / "states", "a run", 3, never);
  second.load();
  run(second, true, again);
  ASSERT_EQ(again.replicates.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(again.replicates[i].energy_balance.collisions,
              whole.replicates[i].energy_balance.collisions);
    EXPECT_GT(again.replicates[i].energy_balance.collisions, 0);
  }
}

}  // namespace
}  // namespace mahlwerk::campaign::queue_test
