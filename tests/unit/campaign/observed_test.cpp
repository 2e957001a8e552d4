// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Observation does not change the motion, and accounts for all energy.
#include "unit/campaign/observed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "one_ball.hpp"
#include "statement.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::campaign::observed_test {
namespace {

using tests::Recorder;
using tests::states;

/// Forwards records to another recorder, which outlives this object.
struct Passed final : scene::Observer {
  explicit Passed(Recorder& other) : to(&other) {}
  void collisions(std::span<const scene::Collision> finished) override { to->collisions(finished); }
  Recorder* to;
};

TEST(Ledger, spectrum_lasting_and_open_contacts_are_all_that_is_dissipated) {
  for (const auto& [name, what] : kinds()) {
    ReplicateRun replica(what, 0);
    const results::Replicate r = to_the_end(replica).result();
    ASSERT_TRUE(r.complete) << name;
    const scene::EnergyBalance &a = r.at_settled, &b = r.energy_balance;
    const double spectrum = r.tally.total_spectra().energy_lost.sum(), lost = b.lost() - a.lost();
    const double lasting = b.lost_lasting - a.lost_lasting, open = b.lost_open - a.lost_open;
    EXPECT_GT(r.tally.all.count, 20) << name;
    if (what.run.engine == cases::EngineName::soft) {
      states(name + ": lost in open contacts when counting begins", a.lost_open / lost, 0, 1e-12,
             "their records start anew");
      EXPECT_NE(b.lost_open, 0) << name << ": contacts go on at the end";
    }
    if (what.balls.front().count == 1) {
      EXPECT_GT(lasting, 1e-3 * lost) << name << ": it rolls";
    }
    states(name + ": all that is known over dissipation", (spectrum + lasting + open) / lost, 1,
           1e-9, "the ledger: each loss is in one place");
  }
}

/// The engine of a replicate, restored from the last `size` bytes of its saved state.
std::unique_ptr<scene::Engine> restored(const cases::Case& mill_case, const std::string& state,
                                        std::size_t size) {
  auto made = engine(mill_case, 0);
  Archive in(state.substr(state.size() - size));
  made->serialize(in);
  in.finish();
  return made;
}

bool same(const std::vector<scene::Ball>& a, const std::vector<scene::Ball>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.position == other.position && one.velocity == other.velocity &&
           one.spin == other.spin;
  });
}

double later(const cases::Case& mill_case) {
  return 1.5 * (*mill_case.run.settle + mill_case.run.time);
}

TEST(Observed, a_run_that_is_looked_at_ends_where_the_bare_engine_does_to_the_bit) {
  for (const auto& [name, what] : kinds()) {
    Recorder silent, kept;
    Archive bare, seen;
    const auto alone = engine(what, 0);
    alone->advance(*what.run.settle, silent);
    silent.all.clear();
    alone->begin_counting();
    alone->advance(*what.run.settle + what.run.time, silent);
    alone->serialize(bare);
    ReplicateRun replica(what, 0, std::make_unique<Passed>(kept));
    to_the_end(replica).serialize(seen);
    const auto looked_at = restored(what, seen.bytes(), bare.bytes().size());
    EXPECT_TRUE(same(looked_at->balls(), alone->balls())) << name;
    alone->advance(later(what), silent);
    looked_at->advance(later(what), kept);
    EXPECT_TRUE(same(looked_at->balls(), alone->balls())) << name << ", later";
    ASSERT_EQ(kept.all.size(), silent.all.size()) << name;
    for (std::size_t i = 0; i < kept.all.size(); ++i) {
      ASSERT_EQ(kept.all[i].time, silent.all[i].time) << name << " " << i;
      ASSERT_EQ(kept.all[i].where, silent.all[i].where) << name << " " << i;
      ASSERT_EQ(kept.all[i].lost(), silent.all[i].lost()) << name << " " << i;
    }
  }
}

using ObservedFrames = results::ScratchTest;

TEST_F(ObservedFrames, frames_change_no_bit_of_a_run) {
  for (auto [name, what] : kinds()) {
    Archive plain, filmed;
    ReplicateRun without(what, 0);
    to_the_end(without);
    what.observe.frames = 0.0037;
    ReplicateRun with(what, 0, nullptr,
                      std::make_unique<results::FrameFiles>(scratch() / name, what));
    to_the_end(with);
    const results::Replicate one = without.result(), other = with.result();
    EXPECT_EQ(one.tally.all.count, other.tally.all.count) << name;
    EXPECT_EQ(one.tally.all.lost, other.tally.all.lost) << name;
    EXPECT_EQ(one.energy_balance.kinetic, other.energy_balance.kinetic) << name;
    EXPECT_EQ(one.charge.wall_slip, other.charge.wall_slip) << name;
    EXPECT_EQ(one.replay.positions(), other.replay.positions()) << name;
  }
  EXPECT_GT(std::distance(std::filesystem::directory_iterator(scratch()), {}), 3);
}

TEST(ObservedReplays, of_all_replicates_are_kept_on_request_and_change_no_bit) {
  for (auto [name, what] : kinds()) {
    what.run.replicates = 3;
    RunOptions options;
    const results::Outcome usual = run(what, options);
    options.replays_of_all = true;
    const results::Outcome all = run(what, options);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(usual.replicates[i].replay.empty(), i > 0) << name;
      EXPECT_FALSE(all.replicates[i].replay.empty()) << name;
      EXPECT_EQ(usual.replicates[i].energy_balance.kinetic,
                all.replicates[i].energy_balance.kinetic)
          << name;
      EXPECT_EQ(usual.replicates[i].tally.all.lost, all.replicates[i].tally.all.lost) << name;
      EXPECT_EQ(usual.replicates[i].charge.wall_slip, all.replicates[i].charge.wall_slip) << name;
    }
    EXPECT_EQ(usual.replicates[0].replay.positions(), all.replicates[0].replay.positions()) << name;
  }
}

/// Every number of a summary as bits, so that NaN equals NaN.
std::vector<std::uint64_t> bits(const results::Outcome& outcome) {
  std::vector<std::uint64_t> found;
  for (const results::Quantity& q : results::summarise(outcome).quantities)
    for (const double v : {q.value, q.ci95, q.ci95_time})
      found.push_back(std::bit_cast<std::uint64_t>(v));
  return found;
}

TEST(Replicates, are_merged_to_the_same_bits_by_any_number_of_threads) {
  for (auto [name, what] : kinds()) {
    what.run.replicates = name == "soft, crowd of 40" ? 2 : 5;
    RunOptions options;
    options.threads = 1;
    const results::Outcome alone = run(what, options);
    const std::string spectrum = results::csv(results::spectrum(alone));
    EXPECT_GT(spectrum.size(), 1000U) << name;
    for (const int threads : {2, 3, 5}) {
      options.threads = threads;
      const results::Outcome shared = run(what, options);
      EXPECT_EQ(bits(shared), bits(alone)) << name << ", " << threads << " threads";
      EXPECT_EQ(results::csv(results::spectrum(shared)), spectrum) << name;
    }
    what.seed = 2;
    EXPECT_NE(bits(run(what, options)), bits(alone)) << name << ": another seed";
  }
}

/// As after an interruption: states of replicates are saved at different times.
TEST(Replicates, together_have_the_same_bits_from_different_times) {
  for (const auto& [name, what] : kinds()) {
    std::vector<std::unique_ptr<ReplicateRun>> alone, together;
    for (int k = 0; k < 3; ++k) {
      alone.push_back(std::make_unique<ReplicateRun>(what, k));
      together.push_back(std::make_unique<ReplicateRun>(what, k));
      to_the_end(*alone.back());
      for (int slices = 0; slices < 7 * k; ++slices) together.back()->run_slice();
    }
    for (;;) {
      std::vector<ReplicateRun*> left;
      for (const auto& run : together)
        if (!run->done()) left.push_back(run.get());
      if (left.empty()) break;
      ReplicateRun::run_slice_together(left);
    }
    const auto outcome_of = [&mill_case = what](const std::unique_ptr<ReplicateRun>& run) {
      results::Outcome outcome{.mill_case = mill_case, .replicates = {run->result()}};
      outcome.engine = mill_case.run.engine;
      return outcome;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const results::Outcome found = outcome_of(together[k]), expected = outcome_of(alone[k]);
      EXPECT_GT(expected.replicates[0].energy_balance.collisions, 20) << name;
      EXPECT_EQ(bits(found), bits(expected)) << name << ", replicate " << k;
    }
  }
}

}  // namespace
}  // namespace mahlwerk::campaign::observed_test
