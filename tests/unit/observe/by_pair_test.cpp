// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/by_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/observe/tally.hpp"
#include "statement.hpp"

namespace mahlwerk::observe {
namespace {

using tests::states;

/// Ball 0 and 1 of kind 0, 2 of kind 1, 3 and 4 of kind 2.
const BallKinds kinds({0, 0, 1, 2, 2}, 3);

std::vector<scene::Collision> some(std::uint64_t seed, int count) {
  Random random(seed, 0);
  std::vector<scene::Collision> list;
  for (int i = 0; i < count; ++i) {
    scene::Collision c;
    c.ball = static_cast<std::int32_t>(random.uniform(0, 4.999));
    c.other = static_cast<std::int32_t>(random.uniform(-2.999, 4.999));
    c.mass = random.uniform(0.001, 0.002);
    c.approach = random.uniform(0, 1);
    c.slip = random.uniform(0, 1);
    c.lost_normal = random.uniform(0, 1e-3);
    c.lost_tangential = random.uniform(0, 1e-3);
    list.push_back(c);
  }
  return list;
}

TEST(ByPair, every_two_kinds_and_every_kind_with_the_jar_have_one_tally) {
  const ByPair by_pair(kinds);
  EXPECT_EQ(by_pair.pairs(), 9);
  std::set<std::pair<int, int>> seen;
  for (int i = 0; i < by_pair.pairs(); ++i) {
    const auto [one, other] = by_pair.kinds_of(i);
    EXPECT_TRUE(other == ByPair::jar || other >= one);
    seen.insert({one, other});
  }
  EXPECT_EQ(seen.size(), 9U);
}

TEST(ByPair, a_collision_counts_for_its_own_pair_whoever_is_named_first) {
  ByPair by_pair(kinds);
  scene::Collision c;
  const auto counted = [&](std::int32_t ball, std::int32_t other, int one, int with) {
    c.ball = ball;
    c.other = other;
    by_pair.add(c, true, 0);
    for (int i = 0; i < by_pair.pairs(); ++i)
      if (by_pair.kinds_of(i).one == one && by_pair.kinds_of(i).other == with)
        return by_pair[i].all.count;
    return std::int64_t{-1};
  };
  EXPECT_EQ(counted(0, 1, 0, 0), 1);
  EXPECT_EQ(counted(1, 4, 0, 2), 1);
  EXPECT_EQ(counted(4, 1, 0, 2), 2);
  EXPECT_EQ(counted(2, 3, 1, 2), 1);
  EXPECT_EQ(counted(3, -1, 2, ByPair::jar), 1);
  EXPECT_EQ(counted(4, -3, 2, ByPair::jar), 2);
}

TEST(ByPair, pairs_sum_to_the_whole) {
  Tally tally(0.3, kinds);
  tally.collisions(some(1, 20000));
  PairSums all, above;
  std::int64_t in_bins = 0;
  for (int i = 0; i < tally.by_pair.pairs(); ++i) {
    all.add(tally.by_pair[i].all);
    above.add(tally.by_pair[i].above);
    in_bins += tally.by_pair[i].energy_normal.total();
  }
  EXPECT_EQ(all.count, tally.all.count);
  EXPECT_EQ(above.count, tally.above.count);
  EXPECT_EQ(in_bins, tally.all.count);
  const std::string why =
      "the same numbers in another order: 2e4 roundings of 1e-16, mostly cancelling";
  states("normal energy, share", all.energy_normal / tally.all.energy_normal, 1, 1e-12, why);
  states("above threshold", above.energy_normal / tally.above.energy_normal, 1, 1e-12, why);
  states("contact point", all.energy_contact_point / tally.all.energy_contact_point, 1, 1e-12, why);
  states("lost", (all.lost_normal + all.lost_tangential) / tally.all.lost, 1, 1e-12, why);
}

TEST(ByPair, merging_is_counting_together) {
  Tally a(0.3, kinds), b(0.3, kinds), whole(0.3, kinds);
  a.collisions(some(1, 500));
  b.collisions(some(2, 500));
  whole.collisions(some(1, 500));
  whole.collisions(some(2, 500));
  a.by_pair.merge(b.by_pair);
  for (int i = 0; i < whole.by_pair.pairs(); ++i) {
    EXPECT_EQ(a.by_pair[i].all.count, whole.by_pair[i].all.count);
    EXPECT_EQ(a.by_pair[i].above.count, whole.by_pair[i].above.count);
    for (int bin = 0; bin < LogHistogram::bins; ++bin)
      EXPECT_EQ(a.by_pair[i].energy_normal.count(bin), whole.by_pair[i].energy_normal.count(bin));
    EXPECT_NEAR(a.by_pair[i].all.lost_normal, whole.by_pair[i].all.lost_normal, 1e-12);
  }
}

TEST(ByPair, a_state_written_and_read_goes_on_to_the_bit) {
  Tally first(0.3, kinds), second(0.3, kinds);
  first.collisions(some(1, 300));
  Archive out;
  first.carry(out);
  Archive in(out.bytes());
  second.carry(in);
  in.finish();
  first.collisions(some(2, 300));
  second.collisions(some(2, 300));
  for (int i = 0; i < first.by_pair.pairs(); ++i) {
    EXPECT_EQ(first.by_pair[i].all.count, second.by_pair[i].all.count);
    EXPECT_EQ(first.by_pair[i].all.energy_normal, second.by_pair[i].all.energy_normal);
    EXPECT_EQ(first.by_pair[i].above.lost_tangential, second.by_pair[i].above.lost_tangential);
  }
}

TEST(ByPair, without_kinds_nothing_is_kept) {
  Tally tally(0.3);
  tally.collisions(some(1, 10));
  EXPECT_EQ(tally.by_pair.pairs(), 0);
}

}  // namespace
}  // namespace mahlwerk::observe
