// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The same material by three ways: grains that break while they move, the sample of grains, and
// the population balance (docs/theory/bed-breakage.md).
#include <gtest/gtest.h>

#include <numeric>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "statement.hpp"
#include "verification/soft/breaking.hpp"

namespace mahlwerk::tests::bed_breakage_three_ways_test {
namespace {

using namespace breaking;

constexpr double step = 2e-7;

/// Shares finer than about a tenth of the grains after one impact on a wall of their material:
/// found, and by t10 at the energy of the impact.
std::pair<double, double> finer_than_a_tenth(const powder::Tavares& model, double energy,
                                             bool coarse) {
  const int side = coarse ? 40 : 20;
  powder::BedBreakage rule = bed(model, powder::T10Fragments{});
  rule.coarse = coarse;
  rule.feed = {.law = powder::Feed::Law::equal, .size = 2 * radius};
  rule.finest = 20e-6;
  rule.smallest_fragment = radius;
  const double speed = std::sqrt(4 * energy);  // half of 1/2 v^2 (bed.2)
  std::vector<scene::Ball> grains = falling(side, speed);
  if (!coarse) grains = with_spare(grains, rule, 4000);
  const auto run = engine(box_for(side), grains, rule, step, 0.05);
  SizeObserver seen;
  run->advance(1e-3 / speed + 5e-5, seen);
  const powder::SizeGrid grid = rule.grid();
  const int first = grid.class_of(0.2 * radius);
  const double share = std::accumulate(seen.gained.begin() + first, seen.gained.end(), 0.0) /
                       (sphere(radius).mass() * side * side);
  return {share,
          powder::T10Fragments{}.breakage_function(grid.lower(first - 1) / (2 * radius), 2 * radius,
                                                   model.t10(2 * radius, energy))};
}

TEST(BedBreakage, fineness_follows_the_energy_of_the_whole_impact) {
  const powder::Tavares model = {20, 1e-3, 1, 0.2, 4, 5, 0.6, 0.1};
  for (const double over : {2.0, 6.0}) {
    const double energy = over * model.median(2 * radius);
    const auto [stay, p] = finer_than_a_tenth(model, energy, true);
    states("share finer than a tenth, spheres that stand for many", stay, p,
           4 * std::sqrt(p * (1 - p)) / 40, "(brk.7), four standard deviations of 1600 grains");
    states("share finer than a tenth, single particles",
           finer_than_a_tenth(model, energy, false).first, p, 0.05 * p,
           "(brk.7), 1.5 % of the energy, and fragments that break again");
  }
}

/// Coarse grains that cross a box and hit its walls at one speed, against the population balance
/// and the sample of grains with one hit on each particle and crossing.
TEST(BedBreakage, grains_in_motion_sample_and_balance_agree) {
  constexpr int side = 40, hits = 8;
  constexpr double speed = 8, energy = 0.25 * speed * speed;
  powder::BedBreakage rule =
      bed(powder::VogelPeukert{4, 1e-3}, powder::AustinFragments{0.4, 0.8, 3});
  rule.coarse = true;
  rule.feed = {.law = powder::Feed::Law::equal, .size = 1e-3};
  rule.finest = 20e-6;
  const auto run = engine(box_for(side), falling(side, speed), rule, step, 1);
  SizeObserver seen;
  run->advance((hits - 0.5) * 0.198 / speed, seen);
  const powder::SizeGrid grid = rule.grid();
  std::vector<double> in_bed = grid.shares(rule.feed);
  const double mass = sphere(radius).mass() * side * side;
  for (std::size_t k = 0; k < seen.gained.size(); ++k) in_bed[k] += seen.gained[k] / mass;
  // One hit a second on each particle.
  powder::Process process;
  process.capture = powder::FixedMass{sphere(0.5e-3).mass()};
  process.breakage = rule.breakage, process.fragments = rule.fragments;
  process.density = density, process.mass = process.grain(1e-3).mass();
  const double captured = std::get<powder::FixedMass>(*process.capture).mass;
  const powder::StressSpectrum spectrum{{powder::Nip{}}, {{0, energy * captured, 1}}};
  const auto balance = powder::grind_by_balance(process, spectrum, grid, rule.feed, hits);
  powder::Stream stream;
  stream.hits.assign(1, {static_cast<float>(energy * captured), 0});
  stream.span = 1;
  const auto sample =
      powder::grind_sample(process, spectrum.nips, stream, grid, rule.feed, hits, 20000, 5);
  for (const double passing : {0.3e-3, 0.5e-3, 0.8e-3}) {
    const double p = powder::undersize(grid, balance.shares.back(), passing);
    const double error = 4 * std::sqrt(p * (1 - p)) / side;
    states("share finer, grains in motion and balance", powder::undersize(grid, in_bed, passing), p,
           error + 0.02,
           "four standard deviations of 1600 grains, and hits in turn, not by chance");
    states("share finer, sample and balance",
           powder::undersize(grid, sample.shares.back(), passing), p, 0.02,
           "four standard deviations of 20000 grains, classes");
  }
}

/// Columns of `layers` grains between the floor and a ball that falls on each, like a bed between
/// two plates: spheres that stand for many particles.
struct Columns {
  static constexpr int side = 30;
  static constexpr double ball_density = 2000 * density;
  int layers = 1;
  double faster = 1;  ///< [1] than balls that give 1 to 25 J/kg
  powder::BedBreakage rule = [] {
    powder::BedBreakage made =
        bed(powder::Tavares{20, 1e-3, 1, 0.5, 4, 5, 0.6, 0.1}, powder::T10Fragments{});
    made.kind = 1;
    made.coarse = true;
    made.feed = {.law = powder::Feed::Law::equal, .size = 2 * radius};
    made.finest = 20e-6;
    made.per_octave = 12, made.seed = 2;
    return made;
  }();

  double speed(std::size_t column) const {  ///< [m/s] of the ball of a column
    const double place = static_cast<double>(column) / (side * side);
    return faster * (0.045 + 0.18 * place) * std::sqrt(0.5 * (layers + 1));
  }
  /// [J/kg] That each grain receives: n grains take n/(n + 1) of the ball's energy (bed.2).
  double energy(std::size_t column) const {
    return 0.5 * ball_density / density * speed(column) * speed(column) / (layers + 1);
  }
  /// The balls, and the grains under them, if any.
  std::vector<scene::Ball> bodies(bool grains) const {
    std::vector<scene::Ball> balls = falling(side, 0);
    const std::size_t columns = balls.size();
    for (std::size_t k = 0; k < columns; ++k) {
      const double height = grains ? 2 * layers * radius : 0;
      balls[k].density = ball_density;
      balls[k].position.z = -0.1 + height + 1.001 * radius;
      balls[k].velocity.z = -speed(k);
    }
    for (std::size_t k = 0; grains && k < columns; ++k)
      for (int n = 0; n < layers; ++n) {
        Vec3 place = balls[k].position;
        place.z = -0.1 + (2 * n + 1) * radius;
        balls.push_back(sphere(radius, place, {}, {}, 1));
      }
    return grains && !rule.coarse ? with_spare(balls, rule, 8000) : balls;
  }
  SizeObserver run(bool grains) const {
    soft::Settings settings{of_law(contact::HertzMindlin{}), step, true};
    settings.few_ball_limit = 0;
    if (grains) settings.breakage = powder::grain_breakage(rule);
    const contact::Pair pair = pair_of(material, material, 0.3);
    const auto made = soft::make_engine(box_for(side), bodies(grains), settings,
                                        contact::PairTable(grains ? 2 : 1, 6, pair), 0);
    SizeObserver seen;
    made->advance(7e-3, seen);
    return seen;
  }
};

/// The balance and the sample take the hits of the balls on the floor without grains between them;
/// of the energy in n + 1 contacts of n grains, the grains take n (bed.2).
TEST(BedBreakage, beds_between_plates_agree_by_three_ways) {
  for (const int layers : {1, 3}) {
    const Columns columns{.layers = layers};
    const powder::SizeGrid grid = columns.rule.grid();
    const double mass = sphere(radius).mass();
    const int grains = Columns::side * Columns::side * layers;
    const SizeObserver seen = columns.run(true);
    std::vector<double> in_bed = grid.shares(columns.rule.feed);
    for (std::size_t k = 0; k < seen.gained.size(); ++k)
      in_bed[k] += seen.gained[k] / (mass * grains);

    powder::Process process;
    process.capture = powder::FixedMass{layers * mass};
    process.energy_share = layers / (layers + 1.0);
    process.breakage = columns.rule.breakage, process.fragments = columns.rule.fragments;
    process.density = density, process.mass = mass * grains;
    powder::Stream stream;
    stream.span = 1;
    powder::StressSpectrum spectrum;
    spectrum.nips.emplace_back();
    for (const scene::Collision& hit : columns.run(false).hits) {
      stream.hits.push_back({static_cast<float>(hit.energy_normal()), 0});
      spectrum.stresses.push_back({0, hit.energy_normal(), 1});
    }
    EXPECT_EQ(stream.hits.size(), static_cast<std::size_t>(Columns::side * Columns::side));
    const auto balance = powder::grind_by_balance(process, spectrum, grid, columns.rule.feed, 1);
    const auto sample =
        powder::grind_sample(process, spectrum.nips, stream, grid, columns.rule.feed, 1, 20000, 5);
    for (const double passing : {0.3e-3, 1e-3, 1.8e-3}) {
      const double p = powder::undersize(grid, balance.shares.back(), passing);
      states("share finer, bed and balance", powder::undersize(grid, in_bed, passing), p,
             4 * std::sqrt(p * (1 - p) / grains) + 0.01,
             "four standard deviations; each grain once, not by chance; 1.5 % of the energy");
      states("share finer, sample and balance",
             powder::undersize(grid, sample.shares.back(), passing), p,
             4 * std::sqrt(p * (1 - p) / 20000) + 0.003,
             "four standard deviations of 20000 grains, classes");
    }
  }
}

/// Single particles: where a grain breaks, its fragments yield, and the other grains of its column
/// bear less than they would without breakage. At most all break that are weak enough for their
/// share of the energy, at least the weakest of each column.
TEST(BedBreakage, a_grain_that_breaks_relieves_the_others_of_its_column) {
  for (const int layers : {1, 3}) {
    Columns columns{.layers = layers, .faster = 1.5};
    columns.rule.coarse = false;
    columns.rule.smallest_fragment = radius;
    columns.rule.per_octave = 3;
    const double grains = Columns::side * Columns::side * layers;
    const double found = static_cast<double>(columns.run(true).broken_of(0)) / grains;
    const auto model = std::get<powder::Tavares>(*columns.rule.breakage);
    double all = 0, weakest = 0;
    for (std::size_t k = 0; k < Columns::side * Columns::side; ++k) {
      const double p = model.breakage_probability(2 * radius, columns.energy(k));
      all += p * layers / grains;
      weakest += (1 - math::pow(1 - p, layers)) / grains;
    }
    std::printf("    %d layers: share broken %.3f, all %.3f, weakest %.3f\n", layers, found, all,
                weakest);
    const double error = 4 * std::sqrt(all * (1 - all) / grains) + 0.01;
    stays_below("share broken less all weak ones", found - all, error, "four standard deviations");
    stays_below("the weakest less the share broken", weakest - found, error,
                "four standard deviations");
    if (layers > 1) stays_below("share broken over all weak ones", found / all, 0.8, "relief");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::bed_breakage_three_ways_test
