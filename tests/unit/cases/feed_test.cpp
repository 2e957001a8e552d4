// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Particle sizes of the powder in a case, and powder that does not fit its jar.
#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "statement.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::feed_test {
namespace {

using namespace sample;
using tests::states;

powder::Feed feed_of(const std::string& lines) {
  return read_sample(with(powdered, "size", lines)).powder->feed;
}

TEST(ReadFeed, of_one_size_unless_said_otherwise) {
  const Case c = read_sample(powdered);
  EXPECT_EQ(c.powder->feed, (powder::Feed{powder::Feed::Law::equal, 1.3e-3}));
  EXPECT_EQ(c.powder->size, 1.3e-3);
  EXPECT_TRUE(read_sample(with(powdered, "size", "size = \"1.3 mm\"\ndistribution = \"equal\"")) ==
              c);
  EXPECT_FALSE(read_sample(with(powdered, "size", "")).powder->size.has_value());
}

TEST(ReadFeed, distributions_by_mass) {
  using Law = powder::Feed::Law;
  const std::string sieves = "distribution = \"sieves\"\n";
  const std::string passing = sieves +
                              "passing = [[\"1 mm\", \"0 %\"], [\"2 mm\", \"50 %\"], "
                              "[\"4 mm\", \"100 %\"]]";
  EXPECT_EQ(feed_of(passing),
            (powder::Feed{.law = Law::sieves, .passing = {{1e-3, 0}, {2e-3, 0.5}, {4e-3, 1}}}));
  EXPECT_EQ(feed_of(sieves + "retained = [[\"1 mm\", \"50 %\"], [\"2 mm\", \"50 %\"], "
                             "[\"4 mm\", \"0 %\"]]"),
            feed_of(passing));
  states("median of sieves [m]",
         read_sample(with(powdered, "size", passing)).powder->size.value_or(0), 2e-3, 1e-15,
         "half passes 2 mm");
  EXPECT_EQ(feed_of("distribution = \"lognormal\"\nsize = \"1 mm\"\nspread = 1.5"),
            (powder::Feed{Law::lognormal, 1e-3, 1.5}));
  const std::string rosin = "distribution = \"rosin-rammler\"\nsize = \"1 mm\"\nspread = 2";
  EXPECT_EQ(feed_of(rosin), (powder::Feed{Law::rosin_rammler, 1e-3, 2}));
  states("median of Rosin-Rammler [m]",
         read_sample(with(powdered, "size", rosin)).powder->size.value_or(0),
         1e-3 * std::sqrt(std::log(2)), 1e-15, "1 - exp(-(x/1 mm)^2) = 1/2");
}

TEST(ReadFeed, faults) {
  const auto feed = [](const std::string& lines) { return with(powdered, "size", lines); };
  const std::string sieves = "distribution = \"sieves\"\n";
  expect_says("there is no distribution = \"normal\"", feed("distribution = \"normal\""));
  expect_says("|sieve-shares", feed(sieves + "retained = [[\"1 mm\", \"40 %\"], [\"2 mm\", "
                                             "\"0 %\"]]"));
  expect_says("sum to 40 %, not to 100 %",
              feed(sieves + "retained = [[\"1 mm\", \"40 %\"], [\"2 mm\", \"0 %\"]]"));
  expect_says("90 % of the mass pass the largest sieve",
              feed(sieves + "passing = [[\"1 mm\", \"0 %\"], [\"2 mm\", \"90 %\"]]"));
  expect_says("the openings of `passing` do not increase|",
              feed(sieves + "passing = [[\"2 mm\", \"0 %\"], [\"1 mm\", \"100 %\"]]"));
  expect_says("[powder] lacks `passing`", feed(sieves));
  expect_says("size has no meaning under distribution = \"sieves\"",
              feed(sieves + "size = \"1 mm\"\npassing = [[\"1 mm\", 0], [\"2 mm\", 1]]"));
  expect_says("passing has no meaning under distribution = \"equal\"",
              feed("passing = [[\"1 mm\", 0], [\"2 mm\", 1]]"));
  expect_says("spread has no meaning under distribution = \"equal\"", powdered + "spread = 2\n");
  expect_says("lacks `spread`: geometric standard deviation",
              feed("distribution = \"lognormal\"\nsize = \"1 mm\""));
  expect_says("lacks `size`: grain size that 63.2 % of the mass pass",
              feed("distribution = \"rosin-rammler\"\nspread = 1"));
  expect_says("|out-of-range", feed("distribution = \"lognormal\"\nsize = \"1 mm\"\nspread = 0.5"));
  expect_says("lacks `grain_size`",
              feed("distribution = \"lognormal\"\nsize = \"1 mm\"\nspread = 2\nas = \"grains\""));
}

TEST(PowderFaults, more_than_the_jar_holds) {
  expect_says(
      "the powder's solid (4.922 ml) and the balls (0.2681 ml) are more than the jar holds "
      "(5 ml)|give less powder, fewer balls or a larger jar|powder-too-much",
      with(powdered, "mass", "mass = \"6.3 g\""));
  EXPECT_EQ(one_fault(with(powdered, "mass", "mass = \"6 g\"")), "");
}

TEST(PowderWarnings, loose_powder_that_has_no_room) {
  // The free volume is 5 ml - 0.268 ml = 4.732 ml. 3.634 g of 1280 kg/m3 fill it at 60 %.
  const auto warnings = [](const std::string& mass) {
    return jar_warnings(read_sample(with(powdered, "mass", "mass = \"" + mass + "\"")));
  };
  EXPECT_TRUE(warnings("3.63 g").empty());
  ASSERT_EQ(warnings("3.64 g").size(), 1U);
  EXPECT_NE(warnings("3.64 g")[0].text.find("packed to 60 % of solid"), std::string::npos);
}

}  // namespace
}  // namespace mahlwerk::cases::feed_test
