// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mahlwerk/report/campaign/campaign.hpp"
#include "mahlwerk/report/key_numbers.hpp"
#include "mahlwerk/report/states.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "unit/report/html.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::report::report_test {
namespace {

using results::fake_outcome;

TEST(Readable, rounds_where_the_half_width_says_so) {
  EXPECT_EQ(readable(0.0024192, 0.000012345, "J").text(), "2.419 ± 0.012 mJ");
  EXPECT_EQ(readable(159.234, 1.04, "1/s").text(), "159.2 ± 1.0 /s");
  EXPECT_EQ(readable(0.0442, NAN, "W").text(), "44.20 mW");
  EXPECT_EQ(readable(46.82, 0.36, "deg").text(), "46.82 ± 0.36°");
  EXPECT_EQ(readable(0.806, 0.021, "m/s").text(), "0.806 ± 0.021 m/s");
  EXPECT_EQ(readable(1.8e-15, NAN, "1").text(), "1.8 × 10⁻¹⁵");
  EXPECT_EQ(readable(5, NAN, "1").text(), "5");
  EXPECT_EQ(readable(0, 0, "1").text(), "0");  // no replicate differs
  EXPECT_EQ(readable(NAN, NAN, "J").text(), "-");
  EXPECT_EQ(readable(0.000966, 0.000029, "J", 0.001022).text(), "0.966 ± 0.029 mJ");
}

TEST(Readable, has_the_texts_that_the_page_and_python_are_held_to) {
  std::ifstream file(std::filesystem::path(MAHLWERK_HOME) / "tests/unit/report/numbers.json");
  const nlohmann::json all = nlohmann::json::parse(file);
  EXPECT_GT(all.size(), 60U);
  const auto number = [](const nlohmann::json& one, const char* key, double otherwise) {
    return one.at(key).is_null() ? otherwise : one.at(key).get<double>();
  };
  for (const nlohmann::json& one : all)
    EXPECT_EQ(readable_within(number(one, "value", NAN), number(one, "ci95", NAN),
                              one.at("unit").get<std::string>(),
                              {number(one, "least", -INFINITY), number(one, "most", INFINITY)})
                  .text(),
              one.at("text"))
        << one;
}

TEST(Readable, rounds_to_zero_without_a_sign) {
  EXPECT_EQ(readable(-0.004, 0.14, "").text(), "0.00 ± 0.14");
  EXPECT_EQ(readable(-0.3, 43, "1/s").text(), "0 ± 43 /s");
  EXPECT_EQ(readable(-0.05, 0.14, "").text(), "-0.05 ± 0.14");
}

TEST(Readable, is_as_fine_as_a_half_width_larger_than_the_value) {
  EXPECT_EQ(readable(-773e-6, 12221e-6, "W").text(), "-1 ± 12 mW");
  EXPECT_EQ(readable(0.769, 1.687, "W").text(), "0.8 ± 1.7 W");
  EXPECT_EQ(readable(0.000773, 0.0000121, "W").text(), "773 ± 12 µW");
}

TEST(Readable, says_shares_far_above_all_as_times) {
  EXPECT_EQ(share_of(0.52), "52 % of");
  EXPECT_EQ(share_of(1.31), "131 % of");
  EXPECT_EQ(share_of(9518.79), "9519 times");
}

TEST(Ticks, of_logarithmic_axes_say_their_value) {
  for (const auto& [value, text] : std::vector<std::pair<double, std::string>>{{2000, "2·10³"},
                                                                               {5000, "5·10³"},
                                                                               {10000, "10⁴"},
                                                                               {20000, "2·10⁴"},
                                                                               {1000, "10³"},
                                                                               {500, "500"},
                                                                               {0.01, "0.01"},
                                                                               {0.005, "5·10⁻³"},
                                                                               {0.001, "10⁻³"},
                                                                               {2.5e6, "2.5·10⁶"}})
    EXPECT_EQ(tick_text(value, true), text);
  EXPECT_EQ(tick_text(2000, false), "2000");
}

TEST(Readable, knows_the_width_on_a_terminal) {
  EXPECT_EQ(width("2.4 ± 0.1 µJ"), 12U);
}

TEST(Table, shows_twins_beside_each_other) {
  const auto quantities = results::summarise(fake_outcome()).quantities;
  const std::string text = table(quantities, 0.1);
  EXPECT_TRUE(has(text, "u_n >= 0.1 m/s"));
  EXPECT_TRUE(has(text, "12.0 ± 5.0 /s"));
  EXPECT_TRUE(has(text, "6.0 ± 2.5 /s"));
  EXPECT_FALSE(has(text, "above threshold"));
  for (const Row& row : rows(quantities))
    if (row.above != nullptr) {
      EXPECT_EQ(row.above->name, row.all->name + "_above_threshold");
    }
}

TEST(KeyNumbers, come_first_with_the_dose_of_an_hour_and_no_dose_of_the_simulated_time) {
  auto o = fake_outcome();
  o.mill_case.powder = cases::Powder{"tic", 0.002, {}, {}};
  const std::string without = key_table(ended(o));
  EXPECT_TRUE(has(without, "no milling time given")) << without;
  EXPECT_TRUE(has(without, "21.6 ± 8.9 J/g")) << without;  // 0.006 W/g x 3600 s
  EXPECT_TRUE(has(without, "time to a dose of 1 kJ/g")) << without;
  o.mill_case.milling = cases::MillingTime{.time = 7200};
  const std::string timed = key_table(ended(o));
  EXPECT_TRUE(has(timed, "specific energy dose after 2 h")) << timed;
  EXPECT_TRUE(has(timed, "43 ± 18 J/g")) << timed;
  for (const auto& [time, words] :
       {std::pair(1800.0, "after 30 min"), std::pair(90.0, "after 90 s")}) {
    auto shorter = o;
    shorter.mill_case.milling = cases::MillingTime{.time = time};
    EXPECT_TRUE(has(key_table(ended(shorter)), words)) << words;
  }
  const std::string html = report_page(ended(o), "1");
  EXPECT_TRUE(well_formed(html));
  EXPECT_LT(html.find("43 ± 18 J/g"), html.find("<details"));
}

TEST(KeyNumbers, show_what_assumed_values_decide) {
  auto o = ended(fake_outcome());  // 12 mW, 6 hits/s
  o.summary.sensitivity = results::Sensitivity{
      .time = 2,
      .quantities = {"dissipated_power", "collision_rate_above_threshold"},
      .scatter = {0, 0},
      .keys =
          {{"contact.restitution", "0.8", {"0.3", "0.9"}, "default: x", {{{0.006, 4}, {0.02, 9}}}}},
      .left_out = {"contact.friction"}};
  const std::string text = key_table(o);
  EXPECT_TRUE(has(text, "6 to 20 mW")) << text;
  EXPECT_TRUE(has(text, "4 to 9 /s")) << text;
  EXPECT_TRUE(has(text, "contact.restitution  0.3 to 0.9, assumed 0.8")) << text;
  EXPECT_TRUE(has(text, "was not computed: contact.friction")) << text;
  const std::string html = report_page(o, "1");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "What assumed values decide"));
  EXPECT_FALSE(has(report_page(ended(fake_outcome()), "1"), "assumed values decide"));
}

TEST(Table, what_is_counted_above_the_threshold_stands_in_its_column) {
  auto o = fake_outcome();
  o.mill_case.powder = cases::Powder{"tic", 0.002, {}, {}};
  const auto quantities = results::summarise(o).quantities;
  for (const char* name : {"collision_rate_in_flight", "stress_energy"}) {
    const auto all = rows(quantities);
    const auto row = std::ranges::find_if(all, [&](const Row& r) { return r.all->name == name; });
    ASSERT_NE(row, all.end());
    EXPECT_EQ(row->all_text(), "") << name;
    EXPECT_EQ(row->above_text(), readable(*row->all).text()) << name;
  }
  const std::string html = report_page(ended(o), "1");
  const auto at = html.find("data-quantity=\"collision_rate_in_flight\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_TRUE(html.substr(0, at).ends_with("<td class=\"n\"></td><td class=\"n\" "));
}

TEST(Report, names_two_states_instead_of_their_mean_alone) {
  EXPECT_EQ(states_table(fake_outcome()), "");
  EXPECT_FALSE(has(report_page(fake_outcome(), "1"), "Two states"));
  auto o = fake_outcome({100, 900, 102, 98, 904, 101, 99, 100});
  o.notices = warnings(ended(o));
  const std::string text = states_table(o);
  EXPECT_TRUE(has(text, "6 of 8 replicates (75 %)")) << text;
  EXPECT_TRUE(has(text, "2 of 8 replicates (25 %)")) << text;
  EXPECT_TRUE(has(text, "90.2 ± 2.5 mW")) << text;
  const std::string html = report_page(ended(o), "1");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "<h2>Two states</h2>"));
  EXPECT_TRUE(has(html, "describes neither"));
}

TEST(Report, says_the_result_in_a_sentence) {
  const std::string text = sentence(fake_outcome());
  EXPECT_TRUE(has(text, "In 3 runs of 10 s there were 6.0 ± 2.5 collisions per second")) << text;
  EXPECT_TRUE(has(text, "12.0 ± 5.0 mW")) << text;
}

TEST(Report, is_one_well_formed_page_that_loads_nothing) {
  const std::string html = report_page(fake_outcome(), "1.2.3");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "A &lt;fake&gt; case &amp; more"));
  EXPECT_FALSE(has(html, "<fake>"));
  EXPECT_TRUE(has(html, "class=\"picture\""));
  EXPECT_TRUE(has(html, "Assumed, not measured"));
  EXPECT_TRUE(has(html, "default: on Earth"));
  EXPECT_FALSE(has(without_scripts(html), "nan"));
  for (const char* outside : {"src=", "href=\"http", "@import", "url("})
    EXPECT_FALSE(has(without_scripts(html), outside));
}

TEST(Report, warns_of_what_makes_it_doubtful) {
  EXPECT_TRUE(warnings(fake_outcome()).empty());
  auto o = fake_outcome();
  o.interrupted = true;
  o.replicates[1].complete = false;
  o.replicates[1].stop_reason = "too many bounces";
  o.replicates[0].energy_balance.kinetic = 1;
  o.replicates[0].energy_balance.worst_collision = 1e-3;
  EXPECT_EQ(warnings(ended(o)).size(), 4U);
  auto steps = fake_outcome();
  steps.replicates[0].energy_balance.kinetic = 1e-3;
  EXPECT_EQ(warnings(ended(steps)).size(), 1U);
  steps.engine = cases::EngineName::soft;  // has time steps within contacts
  EXPECT_TRUE(warnings(ended(steps)).empty());
  o.notices = warnings(ended(o));
  EXPECT_TRUE(has(report_page(ended(o), "1"), "too many bounces"));
}

TEST(Report, of_nothing_is_still_a_page) {
  auto o = fake_outcome();
  o.replicates.assign(2, results::Replicate(0.1));
  o.notices = warnings(ended(o));
  const std::string html = report_page(ended(o), "1.2.3");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "there is no result"));
  EXPECT_TRUE(well_formed(report_page(fake_outcome({0}), "1.2.3")));
}

Campaign campaign() {
  Campaign c{.title = "Speeds"};
  const auto point = [&](const char* speed, const char* wall, int hits) {
    add(c, {.number = c.points.size() + 1, .values = {speed, wall}, .folder = "point-1/"},
        results::summarise(fake_outcome({hits, hits + 10})).quantities);
  };
  point("400 rpm", "steel", 200);
  point("200 rpm", "steel", 100);
  point("200 rpm", "a, \"b\"", 300);
  c.keys = campaign_keys({"mill.speed", "jar.material"}, c.points);
  return c;
}

TEST(Campaign, units_of_swept_keys_are_found_where_they_are_shared) {
  const Campaign c = campaign();
  EXPECT_EQ(c.keys[0].unit, "rpm");
  EXPECT_EQ(c.keys[1].unit, "");
  const std::vector<Point> mixed{{.number = 1, .values = {"1 Hz"}},
                                 {.number = 2, .values = {"60 rpm"}}};
  EXPECT_EQ(campaign_keys({"mill.speed"}, mixed)[0].unit, "");
}

TEST(Campaign, page_links_its_points_and_plots_every_line) {
  const std::string html = campaign_page(campaign(), "1.2.3");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "href=\"point-1/report.html\""));
  EXPECT_TRUE(has(html, "mill.speed (rpm)"));
  EXPECT_EQ(pictures_in(html)[0]["series"][1]["name"], "material a, \"b\"");
  EXPECT_TRUE(has(html, "a, &quot;b&quot;"));
}

}  // namespace
}  // namespace mahlwerk::report::report_test
