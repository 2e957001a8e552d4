// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/cases/build.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::pairs_test {
namespace {

using namespace sample;
using contact::Restitution;

/// The vial; `lines` replace its [contact], which begins at line 16.
std::string contact(const std::string& lines) {
  std::string text = with(with(vial, "restitution", lines), "tangential_restitution", "");
  return text;
}
Restitution restitution(const std::string& lines) {
  return read_sample(contact(lines)).contact.rule.restitution;
}

/// The steel drum with 10 mm balls of steel and 20 mm balls of titanium carbide. Its [contact]
/// begins at line 17.
std::string two(const std::string& contact) {
  std::string text =
      with(with(drum, "density", "material = \"steel\""), "density", "material = \"tic\"");
  return with(text, "height", "height = \"60 mm\"\nmaterial = \"steel\"") + "[contact]\n" + contact;
}
double e(const contact::BounceRule& rule) {
  return rule.restitution.at(1);
}

TEST(ReadRestitution, one_number_unless_said_otherwise) {
  EXPECT_EQ(restitution("restitution = 0.6"), 0.6);
  EXPECT_EQ(restitution("restitution = 0.6\nrestitution_law = \"constant\""), 0.6);
  const Case c = read_sample(contact("restitution = 0.6"));
  EXPECT_EQ(source_of(c, "contact.restitution_law"), "default: the same at every speed");
}

TEST(ReadRestitution, viscoelastic_from_a_value_and_its_speed) {
  EXPECT_EQ(restitution("restitution = 0.6\nrestitution_law = \"viscoelastic\"\n"
                        "restitution_speed = \"50 cm/s\""),
            Restitution::viscoelastic(0.6, 0.5));
}

TEST(ReadRestitution, a_table_needs_no_further_word) {
  const auto expected = Restitution::tabulated({{0.1, 0.9}, {1, 0.75}});
  const std::string table = "restitution_table = [[\"0.1 m/s\", 0.9], [\"1 m/s\", \"75 %\"]]";
  EXPECT_EQ(restitution(table), expected);
  EXPECT_EQ(restitution(table + "\nrestitution_law = \"tabulated\""), expected);
  const Case c = read_sample(contact(table));
  EXPECT_EQ(source_of(c, "contact.restitution_law"), "default: a restitution_table is given");
  EXPECT_EQ(source_of(c, "contact.restitution_table"), "case.toml:17");
}

TEST(ReadRestitution, the_command_line_puts_a_number_in_a_table_s_place) {
  const std::string text = contact("restitution_table = [[\"0.1 m/s\", 0.9], [\"1 m/s\", 0.75]]");
  EXPECT_EQ(read_sample(text, {{"contact.restitution", "0.5"}}).contact.rule.restitution, 0.5);
}

TEST(ReadRestitution, what_makes_no_law_is_a_fault_in_its_line) {
  const auto fault = [](const std::string& lines) {
    const auto found = faults_of(contact(lines));
    return found.size() == 1 ? found[0].where + " " + found[0].code : fault_of(contact(lines));
  };
  const std::string visco = "restitution_law = \"viscoelastic\"\n";
  EXPECT_EQ(fault("restitution_law = \"plastic\""), "case.toml:17 unknown-word");
  EXPECT_EQ(fault(visco), "case.toml:16 missing-value");
  EXPECT_EQ(fault(visco + "restitution_speed = \"0 m/s\""), "case.toml:18 out-of-range");
  EXPECT_EQ(fault(visco + "restitution_speed = \"1 m/s\"\nrestitution = 0"),
            "case.toml:19 out-of-range");
  EXPECT_EQ(fault("restitution_speed = \"1 m/s\""), "case.toml:17 too-much");
  EXPECT_EQ(fault("restitution_law = \"tabulated\""), "case.toml:16 missing-value");
  EXPECT_EQ(fault("restitution_law = \"constant\"\nrestitution_table = [[\"1 m/s\", 0.5]]"),
            "case.toml:18 too-much");
  EXPECT_EQ(fault("restitution = 0.5\nrestitution_table = [[\"1 m/s\", 0.5]]"),
            "case.toml:18 too-much");
  EXPECT_EQ(fault("restitution_table = 3"), "case.toml:17 wrong-type");
  EXPECT_EQ(fault("restitution_table = []"), "case.toml:17 wrong-type");
  EXPECT_EQ(fault("restitution_table = [[\"1 m/s\"]]"), "case.toml:17 wrong-type");
  EXPECT_EQ(fault("restitution_table = [[1, 0.5]]"), "case.toml:17 bad-quantity");
  EXPECT_EQ(fault("restitution_table = [[\"1 m/s\", 1.5]]"), "case.toml:17 out-of-range");
  EXPECT_EQ(fault("restitution_table = [[\"1 m/s\", 0.5],\n[\"1 m/s\", 0.4]]"),
            "case.toml:18 out-of-range");
}

TEST(ReadPairs, what_is_not_said_is_inherited) {
  const Case c = read_sample(two(R"(restitution = 0.9
restitution_law = "viscoelastic"
restitution_speed = "2 m/s"
tangential_restitution = -0.2
friction = 0.4
[[contact.pairs]]
between = ["balls.1", "balls.2"]
restitution = 0.6
[[contact.pairs]]
between = ["balls", "jar"]
friction = 0.1
[[contact.pairs]]
between = ["balls", "jar.bottom"]
bounce = "constant"
restitution_table = [["1 m/s", 0.5]]
)"));
  ASSERT_EQ(c.contact.pairs.size(), 3U);
  const auto visco = [](double value) { return Restitution::viscoelastic(value, 2); };
  EXPECT_EQ(c.contact.pairs[0].rule, (contact::BounceRule{visco(0.6), -0.2, 0.4}));
  EXPECT_EQ(c.contact.pairs[1].rule, (contact::BounceRule{visco(0.9), -0.2, 0.1}));
  EXPECT_EQ(c.contact.pairs[2].rule,
            (contact::BounceRule{Restitution::tabulated({{1, 0.5}}), -0.2, INFINITY}));
  EXPECT_EQ(source_of(c, "contact.pairs.1.friction"), "default: as in [contact]");
  EXPECT_EQ(source_of(c, "contact.pairs.1.restitution"), "case.toml:25");
}

TEST(ReadPairs, friction_makes_a_rule_without_limit_walton_s) {
  const Case c =
      read_sample(two("tangential_restitution = 0.9\n[[contact.pairs]]\n"
                      "between = [\"balls\", \"jar\"]\nfriction = 0.2\n"));
  EXPECT_TRUE(std::isinf(c.contact.rule.friction));
  EXPECT_EQ(c.contact.pairs[0].rule, (contact::BounceRule{0.8, 0.9, 0.2}));
}

TEST(ReadPairs, a_number_takes_an_inherited_table_s_place) {
  const Case c =
      read_sample(two("restitution_table = [[\"1 m/s\", 0.5]]\n[[contact.pairs]]\n"
                      "between = [\"balls\", \"jar\"]\nrestitution = 0.2\n"
                      "[[contact.pairs]]\nbetween = [\"balls\", \"balls\"]\n"));
  EXPECT_EQ(c.contact.pairs[0].rule.restitution, 0.2);
  EXPECT_EQ(c.contact.pairs[1].rule.restitution, Restitution::tabulated({{1, 0.5}}));
}

TEST(ReadPairs, the_command_line_and_sweeps_reach_them) {
  const std::string text = two("[[contact.pairs]]\nbetween = [\"balls\", \"jar\"]\n");
  const std::string key = "contact.pairs.1.restitution";
  EXPECT_EQ(read_sample(text, {{key, "0.2"}}).contact.pairs[0].rule.restitution, 0.2);
  const Case c = read_sample(text + "[sweep]\n\"" + key + "\" = [0.3, 0.4]\n");
  EXPECT_EQ(c.contact.pairs[0].rule.restitution, 0.3);
  const std::string second = fault_of(text, {{"contact.pairs.2.restitution", "0.2"}});
  EXPECT_NE(second.find("entries of `pairs` in the case: 1"), std::string::npos) << second;
}

TEST(BounceTable, the_last_entry_that_fits_counts) {
  const Case c = read_sample(two(R"(restitution = 0.9
[[contact.pairs]]
between = ["balls", "jar"]
restitution = 0.1
[[contact.pairs]]
between = ["jar.bottom", "balls.2"]
restitution = 0.2
[[contact.pairs]]
between = ["balls.2", "balls.1"]
restitution = 0.3
)"));
  const contact::BounceTable table = bounce_table(c);
  EXPECT_EQ(table.kinds(), 2);
  EXPECT_EQ(table.faces(), 3);
  EXPECT_EQ(e(table.balls(0, 0)), 0.9);
  EXPECT_EQ(e(table.balls(0, 1)), 0.3);
  EXPECT_EQ(e(table.balls(1, 0)), 0.3);
  EXPECT_EQ(e(table.balls(1, 1)), 0.9);
  for (const int face : {0, 1, 2}) EXPECT_EQ(e(table.wall(0, face)), 0.1);
  EXPECT_EQ(e(table.wall(1, 0)), 0.1);
  EXPECT_EQ(e(table.wall(1, 1)), 0.2);  // side, bottom, top
  EXPECT_EQ(e(table.wall(1, 2)), 0.1);
}

TEST(BounceTable, a_material_is_all_that_is_made_of_it) {
  const contact::BounceTable table = bounce_table(read_sample(two(R"(restitution = 0.9
[[contact.pairs]]
between = ["steel", "steel"]
restitution = 0.1
[[contact.pairs]]
between = ["tic", "steel"]
restitution = 0.2
)")));
  EXPECT_EQ(e(table.balls(0, 0)), 0.1);
  EXPECT_EQ(e(table.wall(0, 2)), 0.1);
  EXPECT_EQ(e(table.balls(1, 0)), 0.2);
  EXPECT_EQ(e(table.wall(1, 0)), 0.2);
  EXPECT_EQ(e(table.balls(1, 1)), 0.9);
}

TEST(PairTable, moduli_of_the_two_softened) {
  const std::string lines = "softening = 0.01\nrestitution = 0.35\nfriction = 0.5\n";
  const contact::PairTable table = pair_table(read_sample(two(lines)));
  EXPECT_EQ(table.kinds(), 2);
  EXPECT_EQ(table.faces(), 3);
  // Steel on steel, 200 GPa and 0.265: E / (2 (1 - nu^2)), E / (4 (2 - nu) (1 + nu)).
  const double e = 2e9, nu = 0.265;
  EXPECT_NEAR(table.balls(0, 0).modulus, e / (2 * (1 - nu * nu)), 1e-6 * e);
  EXPECT_NEAR(table.balls(0, 0).shear_modulus, e / (4 * (2 - nu) * (1 + nu)), 1e-6 * e);
  EXPECT_EQ(table.wall(0, 1), table.balls(0, 0));
  // Steel on the assumed steel that stands in for the carbide: 210 GPa, 0.3.
  const double compliance = (1 - nu * nu) / e + (1 - 0.09) / 2.1e9;
  EXPECT_NEAR(table.balls(0, 1).modulus, 1 / compliance, 1e-6 * e);
  EXPECT_EQ(table.balls(1, 0), table.balls(0, 1));
  EXPECT_EQ(table.wall(1, 2), table.balls(0, 1));
  EXPECT_EQ(table.balls(1, 1).restitution, 0.35);
  EXPECT_EQ(table.balls(1, 1).friction, 0.5);
  EXPECT_EQ(table.balls(1, 1).rolling_friction, 0.01);
  EXPECT_TRUE(
      std::isinf(pair_table(read_sample(two("bounce = \"constant\"\n"))).wall(0, 0).friction));
}

TEST(PairTable, the_last_entry_that_fits_counts) {
  const contact::PairTable table = pair_table(read_sample(two(R"(law = "jkr"
surface_energy = "0.1 J/m2"
rolling_friction = 0.05
restitution = 0.9
[[contact.pairs]]
between = ["balls", "jar"]
surface_energy = "20 mJ/m2"
[[contact.pairs]]
between = ["jar.bottom", "balls.2"]
rolling_friction = 0.2
restitution = 0.3
)")));
  EXPECT_EQ(table.balls(0, 1).surface_energy, 0.1);
  EXPECT_EQ(table.balls(0, 1).rolling_friction, 0.05);
  EXPECT_EQ(table.wall(1, 0).surface_energy, 0.02);
  EXPECT_EQ(table.wall(1, 0).rolling_friction, 0.05);
  EXPECT_EQ(table.wall(1, 1).surface_energy, 0.1);
  EXPECT_EQ(table.wall(1, 1).rolling_friction, 0.2);
  EXPECT_EQ(table.wall(1, 1).restitution, 0.3);
  EXPECT_GT(table.wall(1, 1).modulus, 0);
}

TEST(ReadPairs, pairs_that_mean_nobody_are_faults) {
  const auto fault = [](const std::string& between) {
    return fault_of(two("[[contact.pairs]]\nbetween = " + between + "\n"));
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos && text.find('\n') == std::string::npos;
  };
  EXPECT_TRUE(has(fault("[\"balls.3\", \"jar\"]"), "case.toml:19|nothing in the case is called"));
  EXPECT_TRUE(has(fault("[\"balls\", \"jar.sied\"]"), "did you mean \"jar.side\"?"));
  EXPECT_TRUE(has(fault("[\"stele\", \"jar\"]"), "did you mean \"steel\"?"));
  EXPECT_TRUE(has(fault("[\"stele\", \"jar\"]"), "|unknown-name"));
  EXPECT_TRUE(has(fault("[\"jar.side\", \"jar\"]"), "|no-such-pair"));
  EXPECT_TRUE(has(fault("[\"balls\"]"), "case.toml:19|`between` must name two partners"));
  EXPECT_TRUE(has(fault("\"balls\""), "|wrong-type"));
  EXPECT_TRUE(has(fault_of(two("[[contact.pairs]]\nfriction = 0.2\n")), "lacks `between`"));
  EXPECT_TRUE(has(fault_of(two("pairs = 3\n")), "write [[contact.pairs]]"));
  EXPECT_TRUE(has(fault("[\"balls\", \"jar\"]\nfrction = 0.3"),
                  "unknown key `frction` in [[contact.pairs]]"));
  EXPECT_TRUE(has(fault("[\"balls\", \"jar\"]\nrestitution = 3"), "case.toml:20|"));
}

TEST(ReadContact, several_balls_have_the_tc_rule_unless_said_otherwise) {
  const Case one = read_sample(vial), many = read_sample(planetary);
  EXPECT_EQ(one.contact.lasting, SustainedContactModel::roll);
  EXPECT_EQ(many.contact.lasting, SustainedContactModel::tc);
  EXPECT_EQ(source_of(many, "contact.lasting"),
            "default: with several balls, sustained contacts follow the TC rule");
  EXPECT_EQ(read_sample(planetary, {{"contact.lasting", "none"}}).contact.lasting,
            SustainedContactModel::none);
}

}  // namespace
}  // namespace mahlwerk::cases::pairs_test
