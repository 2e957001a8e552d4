// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tables of papers: quantities, and captured grains between their bounds.
#include <gtest/gtest.h>

#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/report/paper/tables.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report::paper_tables_test {
namespace {

const std::string head = "title = \"T\"\nsource = \"S\"\n";
const std::string table =
    "[[table]]\nname = \"t\"\ntitle = \"rate\"\ncampaign = \"c\"\n"
    "quantity = \"collision_rate\"\nagainst = \"mill.frequency\"\nratio = true\n";
const std::string captured =
    "[[table]]\nname = \"t\"\ntitle = \"N\"\ncampaign = \"c\"\nkind = \"captured\"\n"
    "other = \"jar.side\"\nagainst = \"capture.fracture_energy\"\nenergies = [\"1 mJ\"]\n";

std::string code_of(const std::string& text) {
  try {
    read_paper_text(head + text, "paper.toml");
  } catch (const InputError& e) {
    return e.faults()[0].code;
  }
  return "";
}

TEST(PaperTable, is_read_strictly) {
  const Paper paper = read_paper_text(head + table + captured, "paper.toml");
  ASSERT_EQ(paper.tables.size(), 2U);
  EXPECT_TRUE(paper.tables[0].ratio);
  EXPECT_EQ(paper.tables[1].kind, PaperTable::Kind::captured);
  EXPECT_EQ(paper.tables[1].one, "balls.1");
  EXPECT_DOUBLE_EQ(paper.tables[1].energies.at(0), 1e-3);
  EXPECT_EQ(paper.campaigns(), std::vector<std::string>{"c"});
  EXPECT_EQ(code_of(table + "kindly = 1\n"), "unknown-key");
  EXPECT_EQ(code_of(table + "energies = [\"1 mJ\"]\n"), "unknown-key");
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  EXPECT_EQ(code_of(changed(table, "\"t\"", "\"../t\"")), "wrong-type");
  EXPECT_EQ(code_of(changed(captured, "[\"1 mJ\"]", "[]")), "missing-value");
  EXPECT_EQ(code_of(changed(captured, "1 mJ", "-1 mJ")), "out-of-range");
  EXPECT_EQ(code_of(changed(captured, "1 mJ", "1 mQ")), "bad-quantity");
}

TEST(PaperTable, references_are_checked_before_the_campaigns_run) {
  cases::Case c = results::fake_outcome().mill_case;
  c.sweep.keys = {{.key = "mill.frequency", .values = {"10 Hz", "20 Hz"}}};
  const auto faults = [&](const std::string& text) {
    return paper_faults(read_paper_text(head + text, "paper.toml"), {{"c", c}});
  };
  EXPECT_TRUE(faults(table).empty());
  const std::string bounds =
      "[[claim]]\nfigure = \"1\"\nsays = \"s\"\ncampaign = \"c\"\nkind = \"capture-bounds\"\n";
  ASSERT_EQ(faults(bounds).size(), 1U);
  EXPECT_EQ(faults(bounds)[0].code, "paper-no-capture");
}

TEST(PaperTable, has_a_row_for_each_combination_of_the_other_keys_and_the_ratio_of_the_ends) {
  const Paper paper = read_paper_text(head + table, "paper.toml");
  RunCampaign run;
  for (const char* friction : {"0.1", "0.5"})
    for (const int hits : {100, 300}) {
      run.outcomes.push_back(results::fake_outcome({hits, hits, hits}));
      add(run.numbers,
          {.number = run.outcomes.size(), .values = {friction, hits == 100 ? "10 Hz" : "20 Hz"}},
          results::summarise(run.outcomes.back()).quantities);
    }
  run.numbers.keys = campaign_keys({"contact.friction", "mill.frequency"}, run.numbers.points);
  const MadeTable made = made_table(paper.tables[0], run);
  EXPECT_EQ(made.heads,
            (std::vector<std::string>{"contact.friction", "10 Hz", "20 Hz", "last over first"}));
  ASSERT_EQ(made.rows.size(), 2U);
  EXPECT_EQ(made.rows[1][0], "0.5");
  EXPECT_EQ(made.rows[1][3], "3.00");
  EXPECT_TRUE(made.csv.starts_with("contact.friction,mill.frequency,collision_rate_per_s,"))
      << made.csv;
  EXPECT_TRUE(table_markdown(made).starts_with("| contact.friction | 10 Hz | 20 Hz |"));
}

/// Five balls of 15 mm in a vial of 42 mm, as the paper on the planetary mill has them.
cases::Case planetary_case() {
  cases::Case c = results::fake_outcome().mill_case;
  c.jar.shape = geometry::Cylinder{0.042, 0.0325};
  c.jar.elastic = {200e9, 0.265};
  c.balls = {{5, 0.015, 7700, ""}};
  c.balls[0].elastic = {200e9, 0.265};
  c.powder = cases::Powder{.material = "tic", .mass = 1e-3, .size = 40e-6, .density = 4930};
  c.capture = cases::Capture{.model = powder::Barrios{1000}};
  return c;
}

TEST(CaptureBounds, are_those_of_the_hertz_spot_and_of_the_greatest_deformation) {
  // A separate program in Python gives these numbers for 1 mJ and 40 um: (cap.1), (cap.5) to
  // (cap.8).
  const cases::Case c = planetary_case();
  ASSERT_TRUE(has_capture_bounds(c));
  struct Expected {
    const char* other;
    double low, high;
  };
  const std::vector<Expected> expected{{"balls.1", 67.668322, 505.007444},
                                       {"jar.side", 140.323554, 1181.123918},
                                       {"jar.bottom", 117.632117, 961.559782}};
  for (const Expected& e : expected) {
    const auto found = capture_bounds(c, "balls.1", e.other, 1e-3);
    ASSERT_TRUE(found) << e.other;
    EXPECT_NEAR(found->low, e.low, 1e-6) << e.other;  // printed to six places
    EXPECT_NEAR(found->high, e.high, 1e-6) << e.other;
  }
  EXPECT_FALSE(capture_bounds(c, "balls.2", "balls.1", 1e-3));
  EXPECT_FALSE(capture_bounds(c, "balls.1", "jar", 1e-3));
}

TEST(CaptureBounds, hold_for_grains_of_any_strength_and_are_reached_by_the_extreme_ones) {
  const cases::Case c = planetary_case();
  const powder::Nip nip{0.00375, 200e9 / (2 * (1 - 0.265 * 0.265))};
  for (const double energy : {1e-6, 1e-4, 1e-2}) {
    const CaptureBounds bounds = *capture_bounds(c, "balls.1", "balls.1", energy);
    double last = bounds.low;
    for (const double strength : {1e12, 1e6, 1e3, 1.0, 1e-9, 1e-30}) {
      const double grains =
          powder::Barrios{strength}
              .capture(nip, energy, {.size = 40e-6, .density = 4930, .fracture_energy = strength})
              .grains;
      EXPECT_GE(grains, last) << "J: " << energy << ", J/kg: " << strength;
      EXPECT_LE(grains, bounds.high * (1 + 1e-12)) << energy << ' ' << strength;
      last = grains;
    }
    // exp(-0.152 x^0.413) is below 1e-16 for the weakest grains: the bound itself.
    EXPECT_NEAR(last / bounds.high, 1, 1e-9) << energy;
  }
}

}  // namespace
}  // namespace mahlwerk::report::paper_tables_test
