// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/observe/collision_statistics.hpp"
#include "mahlwerk/observe/pair_statistics.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::by_pair_test {
namespace {

using tests::states;

/// Ball 0 and 1 of kind 0, 2 of kind 1, 3 and 4 of kind 2.
const BallKinds kinds({0, 0, 1, 2, 2}, 3, 2);

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

TEST(StatisticsByPair, every_two_kinds_and_every_kind_with_each_face_have_one_tally) {
  const StatisticsByPair by_pair(kinds);
  EXPECT_EQ(by_pair.pairs(), 12);
  std::set<std::pair<int, int>> seen;
  for (int i = 0; i < by_pair.pairs(); ++i) {
    const auto [one, other] = by_pair.kinds_of(i);
    EXPECT_TRUE(other < 0 || other >= one);
    seen.insert({one, other});
  }
  EXPECT_EQ(seen.size(), 12U);
}

TEST(StatisticsByPair, a_collision_belongs_to_its_own_pair_whoever_is_named_first) {
  const StatisticsByPair by_pair(kinds);
  const auto pair = [&](std::int32_t ball, std::int32_t other) {
    scene::Collision c;
    c.ball = ball;
    c.other = other;
    const auto found = by_pair.kinds_of(by_pair.pair_of(c));
    return std::pair(found.one, found.other);
  };
  EXPECT_EQ(pair(0, 1), std::pair(0, 0));
  EXPECT_EQ(pair(1, 4), std::pair(0, 2));
  EXPECT_EQ(pair(4, 1), std::pair(0, 2));
  EXPECT_EQ(pair(2, 3), std::pair(1, 2));
  EXPECT_EQ(pair(3, -1), std::pair(2, -1));
  EXPECT_EQ(pair(4, -2), std::pair(2, -2));
  EXPECT_EQ(pair(4, -7), std::pair(2, -2)) << "faces beyond those told apart count as the last";
}

TEST(StatisticsByPair, pairs_sum_to_the_whole) {
  CollisionStatistics tally(0.3, kinds);
  tally.collisions(some(1, 20000));
  PairSums all, above;
  std::int64_t in_bins = 0;
  for (int i = 0; i < tally.by_pair.pairs(); ++i) {
    all.add(tally.by_pair[i].all());
    above.add(tally.by_pair[i].above);
    in_bins += tally.by_pair[i].spectra.energy_normal.total();
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

TEST(StatisticsByPair, merging_gives_the_bits_of_counting_together) {
  CollisionStatistics a(0.3, kinds), b(0.3, kinds), whole(0.3, kinds);
  const auto first = some(1, 500), second = some(2, 500);
  a.collisions(second);
  b.collisions(first);
  whole.collisions(first);
  whole.collisions(second);
  a.merge(b);
  EXPECT_EQ(a.all.count, whole.all.count);
  for (int i = 0; i < whole.by_pair.pairs(); ++i) {
    const Spectra &merged = a.by_pair[i].spectra, &counted = whole.by_pair[i].spectra;
    EXPECT_EQ(a.by_pair[i].above.count, whole.by_pair[i].above.count);
    for (const auto part : {&Spectra::energy_normal, &Spectra::energy_contact_point,
                            &Spectra::lost_normal, &Spectra::lost_tangential, &Spectra::approach})
      for (int bin = 0; bin < LogHistogram::bins; ++bin) {
        EXPECT_EQ((merged.*part).count(bin), (counted.*part).count(bin));
        EXPECT_EQ((merged.*part).sum(bin), (counted.*part).sum(bin));
      }
    EXPECT_EQ(merged.angle_all, counted.angle_all);
  }
}

/// The result depends neither on how a stream is split over tallies nor on the order of merging.
TEST(StatisticsByPair,
     streams_split_and_merged_in_any_order_have_the_same_counts_and_sums_to_the_bit) {
  const auto stream = some(3, 5000);
  CollisionStatistics whole(0.3, kinds);
  whole.collisions(stream);
  const Spectra counted = whole.total_spectra();
  for (const std::size_t parts : {2U, 3U, 7U})
    for (const std::size_t first : {0U, 1U}) {
      std::vector<CollisionStatistics> tallies(parts, CollisionStatistics(0.3, kinds));
      for (std::size_t i = 0; i < stream.size(); ++i)
        tallies[i * i % parts].collisions(std::span(&stream[i], 1));
      CollisionStatistics merged = tallies[first];
      for (std::size_t i = 1; i < parts; ++i) merged.merge(tallies[(first + parts - i) % parts]);
      const Spectra found = merged.total_spectra();
      EXPECT_EQ(merged.all.count, whole.all.count);
      EXPECT_EQ(merged.above.between_balls, whole.above.between_balls);
      for (const auto part : {&Spectra::energy_normal, &Spectra::energy_contact_point,
                              &Spectra::energy_centre, &Spectra::energy_lost, &Spectra::lost_normal,
                              &Spectra::lost_tangential, &Spectra::approach}) {
        EXPECT_EQ((found.*part).sum(), (counted.*part).sum());
        EXPECT_GT((found.*part).sum(), 0);
        for (int bin = 0; bin < LogHistogram::bins; ++bin) {
          ASSERT_EQ((found.*part).count(bin), (counted.*part).count(bin));
          ASSERT_EQ((found.*part).sum(bin), (counted.*part).sum(bin));
        }
      }
      for (int n = 0; n < JointHistogram::bins; ++n)
        for (int t = 0; t < JointHistogram::bins; ++t)
          ASSERT_EQ(found.normal_tangential.count(n, t), counted.normal_tangential.count(n, t));
    }
}

/// Hits on the wall of a cylinder and between balls, with factors to wear and flash temperatures.
CollisionStatistics with_factors() {
  CollisionStatistics tally(0.3, kinds, {.radius = 0.02, .bottom = -0.02, .top = 0.02});
  PairFactors factors;
  factors.load_distance_per_loss = 3;
  factors.flash_per_loss.assign(LogHistogram::bins, 1e4);
  factors.hertz_time.assign(LogHistogram::bins, 1e-5);
  for (int i = 0; i < tally.by_pair.pairs(); ++i) tally.by_pair.set_factors(i, factors);
  return tally;
}

std::vector<scene::Collision> on_walls(std::uint64_t seed, int count) {
  Random random(seed, 1);
  std::vector<scene::Collision> list = some(seed, count);
  for (scene::Collision& c : list) {
    c.where = 0.02 * random.direction();
    c.normal = random.direction();
    c.glide = random.uniform(0, 1);
    c.duration = random.uniform(0, 1e-4);
  }
  return list;
}

/// Checks that all sums are the same but for their order.
void expect_same(const CollisionStatistics& found, const CollisionStatistics& wanted) {
  const auto near = [](double a, double b) { EXPECT_NEAR(a, b, 1e-12 * std::abs(b)); };
  for (const auto which : {&CollisionStatistics::all, &CollisionStatistics::above}) {
    const CollisionSums &a = found.*which, &b = wanted.*which;
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.between_balls, b.between_balls);
    for (const auto sum : {&CollisionSums::energy_normal, &CollisionSums::energy_contact_point,
                           &CollisionSums::energy_centre, &CollisionSums::lost,
                           &CollisionSums::approach, &CollisionSums::slip, &CollisionSums::angle})
      near(a.*sum, b.*sum);
  }
  for (int i = 0; i < wanted.by_pair.pairs(); ++i) {
    const PairStatistics &a = found.by_pair[i], &b = wanted.by_pair[i];
    EXPECT_EQ(a.above.count, b.above.count);
    for (const auto sum : {&PairSums::energy_normal, &PairSums::energy_contact_point,
                           &PairSums::lost_normal, &PairSums::lost_tangential})
      near(a.above.*sum, b.above.*sum);
    for (const auto sum :
         {&PairStatistics::load_distance, &PairStatistics::erosion, &PairStatistics::flash}) {
      near(a.*sum, b.*sum);
      EXPECT_GT(b.*sum, 0);
    }
    for (const auto part :
         {&Spectra::energy_normal, &Spectra::energy_contact_point, &Spectra::energy_centre,
          &Spectra::energy_lost, &Spectra::lost_normal, &Spectra::lost_tangential,
          &Spectra::approach, &Spectra::duration, &Spectra::flash})
      for (int bin = 0; bin < LogHistogram::bins; ++bin)
        ASSERT_EQ((a.spectra.*part).count(bin), (b.spectra.*part).count(bin));
    EXPECT_EQ(a.spectra.angle_all, b.spectra.angle_all);
    EXPECT_EQ(a.spectra.angle_above, b.spectra.angle_above);
    for (int n = 0; n < JointHistogram::bins; ++n)
      for (int t = 0; t < JointHistogram::bins; ++t)
        ASSERT_EQ(a.spectra.normal_tangential.count(n, t), b.spectra.normal_tangential.count(n, t));
  }
  for (int cell = 0; cell < WallGrid::cells; ++cell) {
    const WallSums &a = found.wall_map[cell], &b = wanted.wall_map[cell];
    ASSERT_EQ(a.count, b.count);
    for (const auto sum :
         {&WallSums::energy_normal, &WallSums::lost, &WallSums::load_distance, &WallSums::erosion})
      near(a.*sum, b.*sum);
  }
}

TEST(StatisticsByPair, a_stream_split_and_merged_has_all_sums_of_the_whole) {
  CollisionStatistics whole = with_factors(), one = with_factors(), other = with_factors();
  const auto first = on_walls(5, 3000), second = on_walls(6, 2000);
  whole.collisions(first);
  whole.collisions(second);
  one.collisions(first);
  other.collisions(second);
  one.merge(other);
  expect_same(one, whole);
}

TEST(StatisticsByPair, a_saved_state_has_all_sums) {
  CollisionStatistics whole = with_factors(), again = with_factors();
  whole.collisions(on_walls(7, 3000));
  Archive out;
  whole.serialize(out);
  Archive in(out.bytes());
  again.serialize(in);
  in.finish();
  expect_same(again, whole);
}

TEST(StatisticsByPair, a_state_written_and_read_goes_on_to_the_bit) {
  CollisionStatistics first(0.3, kinds), second(0.3, kinds);
  first.collisions(some(1, 300));
  Archive out;
  first.serialize(out);
  Archive in(out.bytes());
  second.serialize(in);
  in.finish();
  first.collisions(some(2, 300));
  second.collisions(some(2, 300));
  for (int i = 0; i < first.by_pair.pairs(); ++i) {
    EXPECT_EQ(first.by_pair[i].all().count, second.by_pair[i].all().count);
    EXPECT_EQ(first.by_pair[i].all().energy_normal, second.by_pair[i].all().energy_normal);
    EXPECT_EQ(first.by_pair[i].above.lost_tangential, second.by_pair[i].above.lost_tangential);
  }
}

TEST(StatisticsByPair, without_kinds_all_balls_are_alike) {
  CollisionStatistics tally(0.3);
  tally.collisions(some(1, 10));
  EXPECT_EQ(tally.by_pair.pairs(), 2);
  EXPECT_EQ(tally.by_pair[0].all().count + tally.by_pair[1].all().count, 10);
}

}  // namespace
}  // namespace mahlwerk::observe::by_pair_test
