// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/contact/bounce_table.hpp"

#include <gtest/gtest.h>

namespace mahlwerk::contact::bounce_table_test {
namespace {

TEST(BounceTable, every_pair_has_the_rule_of_all_until_it_gets_its_own) {
  const BounceRule all{0.8, 0, 0.3};
  const BounceTable table(3, 2, all);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) EXPECT_EQ(table.balls(a, b), all);
    for (int face = 0; face < 2; ++face) EXPECT_EQ(table.wall(a, face), all);
  }
  EXPECT_EQ(table.kinds(), 3);
  EXPECT_EQ(table.faces(), 2);
}

TEST(BounceTable, a_rule_set_is_found_at_its_place_alone_and_from_both_sides) {
  const BounceRule all{0.8, 0, 0.3};
  BounceTable table(3, 2, all);
  table.set_balls(0, 2, {0.1, 0, 0.3});
  table.set_balls(1, 1, {0.2, 0, 0.3});
  table.set_wall(1, 0, {0.3, 0, 0.3});
  table.set_wall(2, 1, {0.4, 0, 0.3});
  const auto e = [](const BounceRule& rule) { return rule.restitution.at(1); };
  const double balls[3][3] = {{0.8, 0.8, 0.1}, {0.8, 0.2, 0.8}, {0.1, 0.8, 0.8}};
  const double walls[3][2] = {{0.8, 0.8}, {0.3, 0.8}, {0.8, 0.4}};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) EXPECT_EQ(e(table.balls(a, b)), balls[a][b]);
    for (int face = 0; face < 2; ++face) EXPECT_EQ(e(table.wall(a, face)), walls[a][face]);
  }
}

TEST(BounceTable, a_jar_without_faces_has_pairs_of_balls_alone) {
  const BounceTable table(2, 0, {0.5, 1, INFINITY});
  EXPECT_EQ(table.balls(1, 0).restitution, 0.5);
  EXPECT_EQ(table.faces(), 0);
}

}  // namespace
}  // namespace mahlwerk::contact::bounce_table_test
