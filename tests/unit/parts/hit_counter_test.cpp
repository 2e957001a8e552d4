// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/microphone/hit_counter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::parts::microphone::hit_counter_test {
namespace {

using tests::states;

/// A hit on the jar with this normal energy [J], of a body of 2 kg.
scene::Collision hit(double time, double energy, int other = -1) {
  scene::Collision c;
  c.time = time;
  c.other = other;
  c.mass = 2;
  c.approach = std::sqrt(energy);
  return c;
}

TEST(HitCounter, joins_hits_within_the_definition_time_and_keeps_the_largest) {
  HitCounter counter(1, 0.01, false);
  // Two bursts: 4 and 16 J, then 2 J alone; below the threshold and between balls: not heard.
  const std::array hits{hit(0, 4),      hit(0.009, 16),  hit(0.018, 4),
                        hit(0.02, 0.5), hit(0.1, 64, 3), hit(0.2, 2.25)};
  counter.collisions(hits);
  const observe::LogHistogram heard = counter.heard();
  EXPECT_EQ(heard.total(), 2);
  EXPECT_EQ(heard.count(observe::LogHistogram::bin_of(16)), 1);
  EXPECT_EQ(heard.count(observe::LogHistogram::bin_of(2.25)), 1);
  states("sum of heard energies [J]", heard.sum(), 18.25, 1e-12, "16 J and 2.25 J");
}

TEST(HitCounter, hears_hits_between_balls_if_asked) {
  HitCounter counter(0, 0, true);
  const std::array hits{hit(0, 4), hit(0, 4, 3), hit(0, 0, 3)};
  counter.collisions(hits);
  EXPECT_EQ(counter.heard().total(), 3);
}

TEST(HitCounter, goes_on_from_its_saved_state) {
  HitCounter whole(1, 0.01, false), first(1, 0.01, false), second(1, 0.01, false);
  const std::array hits{hit(0, 4), hit(0.009, 16), hit(0.018, 4), hit(0.3, 9)};
  whole.collisions(hits);
  first.collisions(std::span(hits).first(2));
  Archive out;
  first.serialize(out);
  Archive in(out.bytes());
  second.serialize(in);
  in.finish();
  second.collisions(std::span(hits).subspan(2));
  for (int bin = 0; bin < observe::LogHistogram::bins; ++bin)
    EXPECT_EQ(second.heard().count(bin), whole.heard().count(bin)) << bin;
}

TEST(HitCounter, of_random_hits_hears_the_share_without_a_hit_shortly_before) {
  constexpr double rate = 100;
  constexpr int count = 200'000;
  for (const double definition : {0.0, 0.002, 0.01, 0.03}) {
    Random random(7, 1);
    HitCounter counter(0, definition, false);
    double time = 0;
    for (int i = 0; i < count; ++i) {
      time -= math::log(random.uniform()) / rate;
      const scene::Collision one = hit(time, 1);
      counter.collisions({&one, 1});
    }
    const double share = math::exp(-rate * definition);  // of independent hits
    const double deviation = std::sqrt(share * (1 - share) / count);
    states(fmt::format("share of hits heard, n tau = {}", rate * definition),
           static_cast<double>(counter.heard().total()) / count, share, 4 * deviation + 1.0 / count,
           "exp(-n tau) (sns.3), four standard deviations");
  }
}

}  // namespace
}  // namespace mahlwerk::parts::microphone::hit_counter_test
