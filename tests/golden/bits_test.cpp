// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bits that are the same with every compiler, on every processor and in every version. A change of
// them changes results, if only by rounding, and belongs in the changelog.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "isas.hpp"
#include "mahlwerk/base/fingerprint.hpp"
#include "mahlwerk/event/engine.hpp"
#include "verification/soft/crowd.hpp"

namespace mahlwerk::tests::bits_test {
namespace {

std::uint64_t fingerprint_of(const scene::Engine& engine, const Recorder& records) {
  std::string bytes;
  const auto add = [&](const auto& a) {
    bytes.append(reinterpret_cast<const char*>(&a), sizeof a);
  };
  for (const scene::Ball& b : engine.balls()) add(b.position), add(b.velocity), add(b.spin);
  for (const scene::Collision& c : records.all)
    add(c.time), add(c.where), add(c.normal), add(c.impulse), add(c.lost_tangential);
  return fingerprint(bytes);
}

TEST(FewBodySolver, has_the_bits_it_has_always_had) {
  for (const Isa isa : supported_isas()) {
    const ChosenIsa chosen(isa);
    World five = worlds().front();
    five.balls = lattice_of(5, 0.0055, {0.0025});
    const auto run = crowd(five, 1, 32);
    Recorder records;
    run->advance(0.1, records);
    EXPECT_GT(records.all.size(), 10U);
    EXPECT_EQ(fingerprint_of(*run, records), 604344816688753548U) << name_of(isa);
  }
}

TEST(ManyBodySolver, has_the_bits_it_has_always_had) {
  for (const Isa isa : supported_isas()) {
    const ChosenIsa chosen(isa);
    const scene::Chamber box = still_box(0.05, {0, 0, -gravity});
    const World w{"box", box, lattice_of(2000, 0.0035, {0.0015, 0.001}),
                  of_law(contact::HertzMindlin{}, contact::Rolling::cdt), 2e-6};
    const auto run = crowd(w);
    Recorder records;
    run->advance(0.01, records);
    EXPECT_GT(records.all.size(), 1000U);
    EXPECT_EQ(fingerprint_of(*run, {}), 11103886788486877061U) << name_of(isa);
  }
}

TEST(OneBall, has_the_bits_it_has_always_had) {
  const auto run = event::one_ball(mill_a(), ball_a({0.001, 0, 0.005}), rules_a());
  Recorder records;
  run->advance(20, records);
  EXPECT_GT(records.all.size(), 1000U);
  EXPECT_EQ(fingerprint_of(*run, records), 10684944280546784630U);
}

/// Balls of two sizes in a shaken capsule, with sustained contacts by the TC rule.
TEST(ManyBalls, has_the_bits_it_has_always_had) {
  for (const Isa isa : supported_isas()) {
    const ChosenIsa chosen(isa);
    const World w = worlds().front();
    event::Rules rules;
    rules.bounce = {0.7, 0, 0.3};
    rules.sustained_mode = event::SustainedContactMode::tc;
    const auto run = event::many_balls(w.mill, lattice_of(60, 0.0055, {0.0025, 0.0015}), rules,
                                       {1, geometry::faces(*w.mill.shape), rules.bounce});
    Recorder records;
    run->advance(0.2, records);
    EXPECT_GT(records.all.size(), 1000U);
    EXPECT_EQ(fingerprint_of(*run, records), 11914946242975034680U) << name_of(isa);
  }
}

}  // namespace
}  // namespace mahlwerk::tests::bits_test
