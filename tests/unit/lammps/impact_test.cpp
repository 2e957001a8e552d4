// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/impact.hpp"

#include "mahlwerk/lammps/contact_terms.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::lammps::impact_test {
namespace {

constexpr contact::ElasticConstants steel{200e9, 0.3};

struct Plain {  // a collision in steps, beside the curve of Impact
  double deepest = 0, lasts = 0;
  struct Instant {
    double time, overlap, rate;
  };
  std::vector<Instant> instants;
};

/// The law's own force, by small steps of the semi-implicit Euler method.
template <class L>
Plain plain_collision(const L& law, const contact::EffectivePair& t, double speed) {
  const auto k = law.coefficients(t, law.damping(t.pair.restitution));
  const double whole = law.shortest_time(t, speed), step = whole / 2e5;
  Plain made;
  double x = 0, v = speed;
  for (int i = 0; i < 2'000'000; ++i) {
    if (x > 0)
      v -= step * L::evaluate(k.data(), static_cast<double*>(nullptr), x, v).force / t.mass;
    x += step * v;
    if (x <= 0) break;
    made.deepest = std::max(made.deepest, x);
    made.lasts = (i + 1) * step;
    if (i % 20'000 == 500) made.instants.push_back({made.lasts, x, v});
  }
  return made;
}

template <class L>
void finds_the_speed_of(const L& law, double e, double speed) {
  const scene::Ball ball{0.005, 7800, {}, {}, {}};
  const contact::EffectivePair t = tests::touching(tests::pair_of(steel, steel, e), ball);
  const Plain plain = plain_collision(law, t, speed);
  const Impact impact(contact::AnyLaw{law}, t);
  const std::string what = fmt::format("{} e = {}, {} m/s: ", L::name, e, speed);
  // Steps of 1/200 000 of a collision, and the curve's of 1/3000: errors of their size.
  tests::states(what + "speed from the deepest overlap", impact.speed_of_largest(plain.deepest),
                speed, 1e-3 * speed, "lmp.8");
  tests::states(what + "duration", impact.duration(speed), plain.lasts, 2e-3 * plain.lasts,
                "lmp.9");
  double worst = 0, late = 0;
  for (const Plain::Instant& at : plain.instants) {
    if (at.time > 0.9 * plain.lasts) break;  // the force nearly vanishes there
    const Impact::Found found = impact.found(at.overlap, at.rate);
    worst = std::max(worst, std::abs(found.speed / speed - 1));
    late = std::max(late, std::abs(found.since - at.time) / plain.lasts);
  }
  tests::stays_below(what + "error of the speed from any instant", worst, 4e-3, "lmp.9");
  tests::stays_below(what + "error of the age from any instant", late, 2e-3, "lmp.9");
}

TEST(Impact, the_speed_at_first_touch_follows_from_any_instant_of_a_collision) {
  for (const double e : {0.2, 0.5, 0.9, 1.0})
    for (const double speed : {0.01, 1.0, 100.0}) {
      finds_the_speed_of(contact::HertzMindlin{}, e, speed);
      finds_the_speed_of(contact::LinearSpring{}, e, speed);
    }
}

TEST(Impact, the_speed_is_that_of_a_record_of_the_soft_engine) {
  for (const double e : {0.3, 0.8}) {
    const contact::Pair pair = tests::pair_of(steel, steel, e);
    const scene::Ball ball{0.005, 7800, {}, {0, 0, -1.5}, {}};
    const auto model = tests::of_law(contact::HertzMindlin{});
    const auto engine = tests::soft_engine(tests::still_box(0.1), {ball}, model, pair, 1e-7);
    tests::Recorder seen;
    engine->advance(0.04, seen);
    ASSERT_EQ(seen.all.size(), 1U);
    const Impact impact(*model.law, tests::touching(pair, ball));
    // The deepest of the steps is off by (step / duration)^2 of the overlap.
    tests::states(fmt::format("e = {}: record of a hit on the wall", e),
                  impact.speed_of_largest(engine->energy_balance().deepest_overlap * ball.radius),
                  seen.all.front().approach, 3e-3, "lmp.8");
  }
}

TEST(Impact, contacts_without_rebound_have_a_speed_too) {
  const scene::Ball ball{0.005, 7800, {}, {}, {}};
  const Impact impact(contact::HertzMindlin{},
                      tests::touching(tests::pair_of(steel, steel, 0), ball));
  for (const double overlap : {1e-12, 1e-6, 1e-3})
    for (const double rate : {-100.0, -1e-6, 0.0, 1e-6, 100.0}) {
      const Impact::Found found = impact.found(overlap, rate);
      EXPECT_TRUE(std::isfinite(found.speed) && found.speed > 0) << overlap << " " << rate;
      EXPECT_TRUE(found.since >= 0 && found.since <= found.lasts) << overlap << " " << rate;
    }
  EXPECT_EQ(impact.found(0, 1).speed, 0);
  EXPECT_EQ(impact.speed_of_largest(-1e-9), 0);
}

TEST(ContactTerms, lammps_is_given_the_restitution_that_makes_the_damping_right) {
  // Found by hand for the decks of shared/peers: 0.2066 gives 0.35, 0.36665 gives 0.5.
  const auto input = [](double e) {
    return tsuji_input(-std::sqrt(5.0) * contact::damping_ratio(e));
  };
  tests::states("input for e = 0.35", input(0.35), 0.2066, 1e-4, "found by hand");
  tests::states("input for e = 0.5", input(0.5), 0.36665, 1e-4, "found by hand");
  EXPECT_LT(input(0), input(0.1));
  EXPECT_NEAR(input(1), 1, 2e-3);
}

}  // namespace
}  // namespace mahlwerk::lammps::impact_test
