// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/stress_stream.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "statement.hpp"

namespace mahlwerk::observe::stress_stream_test {
namespace {

scene::Collision hit(double speed) {
  scene::Collision c;
  c.other = -1;
  c.mass = 2;
  c.approach = speed;
  c.slip = 2 * speed;
  c.lost_normal = 0.25 * speed * speed;
  return c;
}

TEST(StressStream, keeps_the_energy_that_it_is_told_to) {
  const std::vector<scene::Collision> one{hit(3)};
  const StatisticsByPair pairs;
  using Energy = StressStream::Energy;
  for (const auto& [energy, expected] : std::vector<std::pair<Energy, double>>{
           {Energy::normal, 9}, {Energy::contact_point, 45}, {Energy::lost, 2.25}}) {
    StressStream stream;
    stream.collisions(one, pairs, energy);
    ASSERT_EQ(stream.hits().size(), 1);
    EXPECT_EQ(stream.hits()[0].energy, expected);
    EXPECT_EQ(stream.hits()[0].pair, pairs.pair_of(one[0]));
  }
}

TEST(StressStream, keeps_every_fourth_of_a_stream_four_times_as_long_as_it_holds) {
  StressStream stream;
  const StatisticsByPair pairs;
  std::vector<scene::Collision> some;
  constexpr std::int64_t all = 3 * static_cast<std::int64_t>(StressStream::most);
  for (std::int64_t i = 0; i < all; ++i) {
    scene::Collision c = hit(1);
    c.approach = 0;
    c.lost_normal = static_cast<double>(i);
    some.push_back(c);
    if (some.size() < 1000) continue;
    stream.collisions(some, pairs, StressStream::Energy::lost);
    some.clear();
  }
  stream.collisions(some, pairs, StressStream::Energy::lost);
  EXPECT_EQ(stream.stride(), 4);
  EXPECT_EQ(std::ssize(stream.hits()), all / 4);
  for (std::size_t i = 0; i < stream.hits().size(); ++i)
    ASSERT_EQ(stream.hits()[i].energy, static_cast<float>(4 * i));  // in order, none left out
}

TEST(StressStream, goes_on_from_its_saved_state) {
  StressStream whole, first, second;
  const StatisticsByPair pairs;
  std::vector<scene::Collision> some;
  for (int i = 0; i < 1000; ++i) some.push_back(hit(0.01 * i));
  for (int round = 0; round < 2; ++round)
    whole.collisions(some, pairs, StressStream::Energy::normal);
  first.collisions(some, pairs, StressStream::Energy::normal);
  Archive out;
  first.serialize(out);
  Archive in(out.bytes());
  second.serialize(in);
  second.collisions(some, pairs, StressStream::Energy::normal);
  Archive one, other;
  whole.serialize(one);
  second.serialize(other);
  EXPECT_EQ(one.bytes(), other.bytes());
}

}  // namespace
}  // namespace mahlwerk::observe::stress_stream_test
