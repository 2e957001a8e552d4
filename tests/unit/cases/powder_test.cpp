// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::powder_test {
namespace {

using namespace sample;
using tests::states;

std::string with_grains(const std::string& lines) {
  return with(planetary, "size", "size = \"40 um\"\n" + lines);
}
const std::string grains = with_grains("as = \"grains\"\ngrain_size = \"1 mm\"");

double number(const Case& c, const std::string& name) {
  for (const DerivedQuantity& one : derived_quantities(c))
    if (one.name == name) return one.value;
  return NAN;
}

TEST(PowderAsGrains, keeps_the_powders_mass) {
  const Case c = read_sample(grains);
  ASSERT_EQ(c.balls.size(), 2U);
  const BallSet& set = c.balls.back();
  EXPECT_TRUE(set.grains);
  EXPECT_EQ(set.diameter, 1e-3);
  EXPECT_EQ(set.density, 4930);
  states("mass of the grains, g", 1e3 * static_cast<double>(set.count) * set.mass(),
         1e3 * c.powder->mass, 0.5e3 * set.mass(), "that of the powder, to half a grain");
  states("balls to powder", balls_mass(c.balls) / c.powder->mass, 70, 1e-12, "the case");
}

TEST(PowderAsGrains, is_reported_with_what_each_grain_stands_for) {
  const Case c = read_sample(grains);
  states("coarse-graining ratio", number(c, "coarse_graining_ratio"), 25, 1e-13, "1 mm over 40 um");
  states("particles per grain", number(c, "particles_per_grain"), 15625, 1e-9, "its cube (chg.10)");
  EXPECT_EQ(number(c, "ball_count"), 5);
  EXPECT_EQ(number(c, "grain_count"), static_cast<double>(c.balls.back().count));
  EXPECT_NE(grains_note(c).find("Each grain represents 1.562e+04 particles of 40 um"),
            std::string::npos)
      << grains_note(c);
  EXPECT_EQ(grains_note(read_sample(planetary)), "");
}

TEST(PowderAsGrains, made_by_a_program_is_checked_too) {
  const auto told = [](auto change) {
    Case c = read_sample(grains);
    change(c);
    std::string codes;
    for (const Fault& f : faults(c)) codes += f.code + " ";
    return codes;
  };
  EXPECT_EQ(told([](Case&) {}), "");
  EXPECT_EQ(told([](Case& c) { c.balls.back().density = 0; }), "out-of-range ");
  EXPECT_EQ(told([](Case& c) { c.balls.back().count = 0; }), "out-of-range ");
  EXPECT_EQ(told([](Case& c) { c.balls.back().diameter = NAN; }), "out-of-range ");
  EXPECT_NE(told([](Case& c) { c.balls.clear(); }).find("out-of-range"), std::string::npos);
}

TEST(PowderAsGrains, is_not_the_default) {
  EXPECT_EQ(read_sample(planetary).balls.size(), 1U);
  EXPECT_TRUE(read_sample(with_grains("as = \"mass\"")) == read_sample(planetary));
}

TEST(PowderAsGrains, of_its_own_size_unless_said_otherwise) {
  const Case c = read_sample(with(with_grains("as = \"grains\""), "size", "size = \"0.8 mm\""));
  EXPECT_EQ(c.balls.back().diameter, 0.8e-3);
  EXPECT_EQ(source_of(c, "powder.grain_size"), "default: the powder's own size");
  EXPECT_NE(grains_note(c).find("the powder's own size"), std::string::npos);
}

// (obs.14, obs.15) A bed has 40 % voids.
TEST(Fillings, j_and_u_of_a_drum_give_the_balls_and_the_powder) {
  const std::string drum =
      with(with(with(planetary, "ball_to", "void_filling = \"100 %\"\ndensity = \"2700 kg/m3\""),
                "count", "bulk_filling = \"30 %\""),
           "material = \"tic\"", "");
  const Case c = read_sample(drum);
  const double jar = jar_volume(c.jar), one = ball_volume(c.balls[0]);
  EXPECT_EQ(c.balls[0].count, std::llround(0.6 * 0.3 * jar / one));
  const double j = static_cast<double>(c.balls[0].count) * one / 0.6 / jar;
  EXPECT_NEAR(bulk_filling(c.balls, c.jar), j, 1e-15);
  EXPECT_NEAR(c.powder->mass, 2700 * 0.6 * 0.4 * j * jar, 1e-12);
  EXPECT_NEAR(*void_filling(c), 1, 1e-12);
}

TEST(PowderAsGrains, filling_is_solid_volume_over_the_jars) {
  const Case c = read_sample(with(grains, "ball_to", "filling = \"15 %\""));
  const double jar = std::numbers::pi / 4 * 0.042 * 0.042 * 0.0325;
  states("powder, g", 1e3 * c.powder->mass, 1e3 * 0.15 * jar * 4930, 1e-12, "0.15 V density");
  const BallSet& set = c.balls.back();
  states("solid share", static_cast<double>(set.count) * ball_volume(set) / jar, 0.15,
         0.5 * ball_volume(set) / jar, "asked for, to half a grain");
}

TEST(PowderAsGrains, is_a_party_of_its_own_in_pairs) {
  const Case c =
      read_sample(grains +
                  "[[contact.pairs]]\nbetween = [\"powder\", \"balls\"]\nfriction = 0.1\n"
                  "[[contact.pairs]]\nbetween = [\"tic\", \"jar\"]\nfriction = 0.2\n");
  const contact::BounceTable table = bounce_table(c);
  EXPECT_EQ(table.balls(0, 0).friction, 0.5);
  EXPECT_EQ(table.balls(0, 1).friction, 0.1);
  EXPECT_EQ(table.balls(1, 1).friction, 0.5);
  EXPECT_EQ(table.wall(0, 0).friction, 0.5);
  EXPECT_EQ(table.wall(1, 0).friction, 0.2);
  EXPECT_EQ(set_name(c, 0), "balls.1");
  EXPECT_EQ(set_name(c, 1), "powder");
}

TEST(PowderAsGrains, is_read_back) {
  for (const std::string& text :
       {grains, with(grains, "ball_to", "filling = \"15 %\""),
        with_grains("as = \"grains\"\ngrain_size = \"1 mm\"\nyoungs_modulus = \"400 GPa\"")}) {
    const Case c = read_sample(text);
    EXPECT_TRUE(read_sample(write(c)) == c) << write(c);
  }
}

TEST(PowderAsGrains, stands_among_the_balls_when_a_run_starts) {
  const Case c = read_sample(grains);
  const std::vector<scene::Ball> balls = starting_balls(c, 0);
  const std::vector<std::int32_t> kinds = kinds_of_balls(c);
  ASSERT_EQ(balls.size(), kinds.size());
  for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_EQ(balls[i].kind, kinds[i]);
  EXPECT_EQ(kinds.front(), 0);
  EXPECT_EQ(kinds.back(), 1);
}

/// The only fault of a case: its cause, remedy and code.
std::string wrong(const std::string& text) {
  const std::vector<Fault> found = faults_of(text);
  return found.size() == 1 ? found[0].what + "; " + found[0].remedy + " [" + found[0].code + "]"
                           : fault_of(text);
}

TEST(PowderFaults, too_many_grains_name_a_size_that_is_not) {
  const std::string said = wrong(with_grains("as = \"grains\""));
  EXPECT_NE(said.find("[too-many-grains]"), std::string::npos) << said;
  const auto at = said.find("grain_size = \"");
  ASSERT_NE(at, std::string::npos) << said;
  const std::string size = said.substr(at + 14, said.find('"', at + 14) - at - 14);
  const Case c = read_sample(with_grains("as = \"grains\"\ngrain_size = \"" + size + "\""));
  EXPECT_NEAR(static_cast<double>(c.balls.back().count), 1e5, 0.2e5) << size;
}

TEST(PowderFaults, what_is_missing_or_means_nothing) {
  EXPECT_NE(
      wrong(with_grains("grain_size = \"1 mm\"")).find("unless the powder is simulated as grains"),
      std::string::npos);
  EXPECT_NE(wrong(with_grains("youngs_modulus = \"1 GPa\"")).find("[too-much]"), std::string::npos);
  EXPECT_NE(wrong(with_grains("as = \"dust\"")).find("there is no as = \"dust\""),
            std::string::npos);
  EXPECT_NE(wrong(with(grains, "material = \"tic\"", "")).find("lacks `density`"),
            std::string::npos);
  EXPECT_NE(wrong(with(with(planetary, "ball_to", "filling = \"10 %\""), "material = \"tic\"", ""))
                .find("lacks `density`"),
            std::string::npos);
  EXPECT_NE(wrong(with(with_grains("as = \"grains\""), "size", "")).find("lacks `grain_size`"),
            std::string::npos);
  EXPECT_NE(wrong(with_grains("as = \"grains\"\ngrain_size = \"30 um\""))
                .find("is smaller than the powder's own size"),
            std::string::npos);
  EXPECT_NE(wrong(with(grains, "ball_to", "filling = \"15 %\"\nmass = \"3 g\"")).find("[too-much]"),
            std::string::npos);
  EXPECT_NE(wrong(with(grains, "grain_size", "grain_size = \"50 mm\"")).find("[too-few-grains]"),
            std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::cases::powder_test
