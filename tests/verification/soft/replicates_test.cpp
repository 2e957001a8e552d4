// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Replicates that step side by side (soft::advance_together). The reference is each of them alone.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>

#include "isas.hpp"
#include "mahlwerk/base/error.hpp"
#include "reproducible_runs.hpp"

namespace mahlwerk::tests::replicates_test {
namespace {

/// Replicates of a run, each with a recorder.
struct Replicates {
  std::vector<std::unique_ptr<scene::Engine>> engines;
  std::vector<Recorder> recorders;

  Replicates(const Make& make, std::size_t count) : recorders(count) {
    for (std::uint32_t k = 0; k < count; ++k) engines.push_back(make(k));
  }
  void advance_alone(double time) {
    for (std::size_t k = 0; k < engines.size(); ++k) engines[k]->advance(time, recorders[k]);
  }
  std::vector<std::exception_ptr> advance_together(double time) {
    std::vector<scene::Engine*> all;
    std::vector<scene::Observer*> observers;
    for (std::size_t k = 0; k < engines.size(); ++k) {
      all.push_back(engines[k].get());
      observers.push_back(&recorders[k]);
    }
    return soft::advance_together(all, time, observers);
  }
};

void expect_same(const Replicates& a, const Replicates& b) {
  for (std::size_t k = 0; k < a.engines.size(); ++k) {
    SCOPED_TRACE("replicate " + std::to_string(k));
    tests::expect_same(a.recorders[k], b.recorders[k]);
    tests::expect_same(*a.engines[k], *b.engines[k]);
    const auto forces = a.engines[k]->forces(), others = b.engines[k]->forces();
    for (std::size_t i = 0; i < forces.size(); ++i) EXPECT_EQ(forces[i], others[i]);
  }
}

TEST(Replicates, have_the_same_bits_together_and_alone) {
  for (const Isa isa : supported_isas()) {
    const ChosenIsa chosen(isa);
    for (const auto& [what, make] : runs())
      for (const std::size_t count : {2, 7}) {
        SCOPED_TRACE(what + ", " + std::string(name_of(isa)));
        Replicates alone(make, count), together(make, count);
        alone.advance_alone(0.05);
        for (const std::exception_ptr& failure : together.advance_together(0.05))
          EXPECT_EQ(failure, nullptr);
        EXPECT_GT(alone.recorders[1].all.size(), 5U);
        expect_same(alone, together);
      }
  }
}

TEST(Replicates, can_change_between_together_and_alone_at_any_time) {
  for (const auto& [what, make] : runs()) {
    SCOPED_TRACE(what);
    Replicates alone(make, 4), mixed(make, 4);
    alone.advance_alone(0.04);
    Random random(5, 0);
    std::vector<double> cuts{0.04};
    for (int i = 0; i < 100; ++i) cuts.push_back(random.uniform(0, 0.04));
    std::ranges::sort(cuts);
    for (const double cut : cuts)
      if (random.uniform(0, 1) < 0.6)
        mixed.advance_together(cut);
      else
        mixed.advance_alone(cut);
    expect_same(alone, mixed);
  }
}

/// The state of a replicate that stepped with others continues in an engine of its own.
TEST(Replicates, have_archives_that_go_on_alone_to_the_bit) {
  for (const auto& [what, make] : runs()) {
    SCOPED_TRACE(what);
    Replicates alone(make, 3), together(make, 3);
    alone.advance_alone(0.04);
    together.advance_together(0.0173);
    for (std::uint32_t k = 0; k < 3; ++k) {
      auto resumed = make(k);
      copy_state(*together.engines[k], *resumed);
      together.engines[k] = std::move(resumed);
    }
    together.advance_alone(0.04);
    expect_same(alone, together);
  }
}

/// A replicate whose ball is too fast for the step fails as it does alone; the others go on.
TEST(Replicates, fail_alone) {
  const scene::Chamber box = still_box(0.03, {0, 0, -gravity});
  const Make make = [&](std::uint32_t replicate) {
    std::vector<scene::Ball> balls = charge(5, replicate);
    if (replicate == 1) balls[2].velocity = {3000, 100, 50};
    return soft_engine(box, balls, of_law(contact::HertzMindlin{}), soft_pair(), 2e-6);
  };
  Replicates alone(make, 3), together(make, 3);
  const auto message = [](const std::exception_ptr& failure) -> std::string {
    try {
      if (failure) std::rethrow_exception(failure);
    } catch (const RunError& e) {
      return e.what();
    }
    return "";
  };
  std::vector<std::string> messages;
  for (std::size_t k = 0; k < 3; ++k) try {
      alone.engines[k]->advance(0.02, alone.recorders[k]);
      messages.emplace_back();
    } catch (...) {
      messages.push_back(message(std::current_exception()));
    }
  EXPECT_NE(messages[1], "");
  const auto failures = together.advance_together(0.02);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(message(failures[k]), messages[k]) << k;
  expect_same(alone, together);
}

TEST(Replicates, stop_early_and_go_on) {
  const Make make = runs()[1].second;
  Replicates alone(make, 3), together(make, 3);
  std::atomic<bool> stop = true;
  for (auto& engine : together.engines) engine->stop_on(&stop);
  together.advance_together(0.02);
  EXPECT_EQ(together.engines[0]->energy_balance().time, 0);
  stop = false;
  together.advance_together(0.02);
  alone.advance_alone(0.02);
  expect_same(alone, together);
}

/// Engines of many balls advance one after the other.
TEST(Replicates, of_many_balls_advance_too) {
  const Make make = [](std::uint32_t replicate) {
    soft::Settings rules{.model = of_law(contact::HertzMindlin{}), .time_step = 2e-6};
    rules.few_ball_limit = 4;
    const scene::Chamber box = still_box(0.03, {0, 0, -gravity});
    return soft::make_engine(box, charge(9, replicate), rules,
                             contact::PairTable(1, 6, soft_pair()), 0);
  };
  Replicates alone(make, 2), together(make, 2);
  alone.advance_alone(0.01);
  together.advance_together(0.01);
  expect_same(alone, together);
}

}  // namespace
}  // namespace mahlwerk::tests::replicates_test
