// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Hollow and coated balls of a case, and the hardness of pairs.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::layers_test {
namespace {

using namespace sample;

const std::vector<Override> hollow{{"balls.wall_thickness", "1 mm"}};
const std::vector<Override> coated{{"balls.coating_thickness", "0.5 mm"},
                                   {"balls.coating_density", "15600 kg/m3"}};

TEST(ReadLayers, mass_and_inertia_of_the_balls_follow) {
  for (const auto& given : {hollow, coated}) {
    const Case c = read_sample(planetary, given);
    const BallSet& set = c.balls[0];
    const double radius = 0.5 * set.diameter;
    ASSERT_TRUE(set.layers().layered());
    for (const scene::Ball& b : starting_balls(c, 0)) {
      EXPECT_EQ(b.density, set.layers().mean_density(radius));
      EXPECT_EQ(b.inertia_ratio, set.layers().inertia_ratio(radius));
      EXPECT_EQ(b.mass(), set.mass());
      EXPECT_GT(b.inertia_ratio, 0.4);
    }
    EXPECT_TRUE(read_text(write(c), "case.toml", catalogue()) == c) << write(c);
  }
  EXPECT_LT(read_sample(planetary, hollow).balls[0].mass(), read_sample(planetary).balls[0].mass());
  EXPECT_EQ(starting_balls(read_sample(planetary), 0)[0].inertia_ratio, 0.4);
}

TEST(ReadLayers, worn_and_heated_is_the_coating) {
  const Case c = read_sample(planetary, coated);
  EXPECT_EQ(c.balls[0].surface_density(), 15600);
  EXPECT_EQ(read_sample(planetary, hollow).balls[0].surface_density(), c.balls[0].density);
}

TEST(ReadLayers, that_do_not_fit_are_refused) {
  const auto code = [](const std::vector<Override>& given) {
    const auto found = faults_of(planetary, given);
    return found.size() == 1 ? found[0].code : std::to_string(found.size()) + " faults";
  };
  EXPECT_EQ(code({{"balls.wall_thickness", "1 m"}}), "impossible-ball");
  EXPECT_EQ(code({{"balls.coating_thickness", "1 mm"}}), "impossible-ball");
  EXPECT_EQ(code({{"balls.coating_density", "1 kg/m3"}}), "impossible-ball");
  EXPECT_EQ(code({{"balls.wall_thickness", "0 mm"}}), "out-of-range");
}

TEST(ReadLayers, are_refused_by_lammps) {
  const auto refuses = [](const Case& c) {
    return std::ranges::any_of(lammps::faults(c), [](const Fault& f) {
      return f.what.find("hollow or coated") != std::string::npos;
    });
  };
  EXPECT_TRUE(refuses(read_sample(planetary, hollow)));
  EXPECT_FALSE(refuses(read_sample(planetary)));
}

TEST(ReadHardness, of_a_pair_is_that_of_the_softer_body_in_pascal) {
  const Case c = read_sample(planetary, {{"balls.hardness", "800"}, {"jar.hardness", "300"}});
  const contact::PairTable table = pair_table(c);
  EXPECT_DOUBLE_EQ(table.balls(0, 0).hardness, 800 * 9.80665e6);
  EXPECT_DOUBLE_EQ(table.wall(0, 0).hardness, 300 * 9.80665e6);
}

TEST(ReadHardness, is_an_assumption_where_the_yield_pressure_follows_from_it) {
  const auto assumed = [](const std::vector<Override>& given) {
    const Case c = read_sample(drum, given);
    return std::ranges::find(c.origins, "balls.1.hardness", &Origin::key)->assumed;
  };
  EXPECT_TRUE(assumed({{"run.engine", "soft"}, {"contact.law", "thornton-ning"}}));
  EXPECT_FALSE(assumed({{"run.engine", "soft"},
                        {"contact.law", "thornton-ning"},
                        {"contact.yield_pressure", "3 GPa"}}));
  EXPECT_FALSE(assumed({{"run.engine", "soft"}}));
}

}  // namespace
}  // namespace mahlwerk::cases::layers_test
