// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mahlwerk/report/campaign/plots.hpp"
#include "unit/report/campaign_fake.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::sensitivity_test {
namespace {

using nlohmann::json;

/// The groups of bars of the first picture.
json groups_of(const Sensitivity& s) {
  return json::parse(sensitivity_pictures(s)[0].json)["groups"];
}

Sensitivity one_at_a_time() {
  return {.quantity = "dissipated_power",
          .unit = "W",
          .base = observe::IntervalEstimate::around(12, 0.3),
          .effects = {{.key = "contact.friction",
                       .low_end = "0.2",
                       .high_end = "0.8",
                       .low = observe::IntervalEstimate::around(11.8, 0.3),
                       .high = observe::IntervalEstimate::around(12.1, 0.3),
                       .significant = false},
                      {.key = "mill.speed",
                       .low_end = "200 rpm",
                       .high_end = "400 rpm",
                       .low = observe::IntervalEstimate::around(4, 0.1),
                       .high = observe::IntervalEstimate::around(28, 0.6),
                       .significant = true}}};
}

TEST(Tornado, bars_go_from_the_case_to_the_ends_the_longest_on_top) {
  const std::vector<Picture> pictures = sensitivity_pictures(one_at_a_time());
  ASSERT_EQ(pictures.size(), 1U);
  const json bars = json::parse(pictures[0].json);
  EXPECT_EQ(bars["title"], "dissipated power");
  EXPECT_EQ(bars["base"], 12);
  EXPECT_EQ(bars["groups"][0]["name"], "mill.speed");
  const json& speed = bars["groups"][0]["bars"];
  EXPECT_EQ(speed[0]["end"], 4);
  EXPECT_EQ(speed[0]["note"], "200 rpm");
  EXPECT_EQ(speed[1]["end"], 28);
  EXPECT_EQ(speed[1]["note"], "400 rpm");
  EXPECT_NEAR(speed[1]["low"], 27.4, 1e-6);
  EXPECT_EQ(bars["groups"][1]["name"], "contact.friction");
  EXPECT_TRUE(has(pictures[0].caption, "Base case: 12.00 ± 0.30 W."));
  EXPECT_TRUE(has(pictures[0].caption, "data-v=\"28\">28.00 ± 0.60<"));
}

TEST(Tornado, names_the_key_that_matters_and_those_that_may_not) {
  EXPECT_EQ(sensitivity_words(one_at_a_time()),
            "dissipated power: mill.speed matters most (changes it by 24.00 W over its range). "
            "Not significant: the effect of contact.friction.");
  Sensitivity none = one_at_a_time();
  none.effects.pop_back();
  EXPECT_EQ(sensitivity_words(none),
            "dissipated power: no key has an effect that differs significantly from zero.");
  // If the significance is unknown, the text does not mention zero.
  none.effects[0].significant = std::nullopt;
  EXPECT_EQ(sensitivity_words(none),
            "dissipated power: contact.friction matters most (changes it by "
            "300.0 mW over its range).");
}

TEST(Tornado, an_effect_is_never_said_to_matter_and_not_to_be_told_at_once) {
  Sensitivity s = one_at_a_time();
  s.effects[0].significant = true;
  EXPECT_FALSE(has(sensitivity_words(s), "Not significant"));
  s.effects[1].significant = false;
  EXPECT_EQ(sensitivity_words(s),
            "dissipated power: of the effects that differ significantly from zero, that of "
            "contact.friction is "
            "the largest (changes it by 300.0 mW over its range). Larger, but not significant: "
            "that of mill.speed.");
  s.effects[0].significant = std::nullopt;
  EXPECT_EQ(sensitivity_words(s),
            "dissipated power: the largest effect, that of mill.speed (changes it by 24.00 W over "
            "its range), does not differ significantly from zero.");
  s.effects[0].significant = false;
  EXPECT_TRUE(
      has(sensitivity_words(s), "no key has an effect that differs significantly from zero"));
}

TEST(Tornado, says_once_which_keys_change_nothing) {
  Campaign c = scattered(20);
  Sensitivity power = one_at_a_time(), size = one_at_a_time();
  size.quantity = "d50";
  power.effects[0].inactive = size.effects[0].inactive = true;
  c.sensitivities = {power, size};
  std::string html = campaign_page(c, "1");
  EXPECT_TRUE(in_order(
      html, {"<p>Without effect in this case: contact.friction.</p>", "class=\"picture\""}));
  EXPECT_FALSE(has(html, "Not significant"));
  // Now the key changes one of the two quantities.
  c.sensitivities[1].effects[0].inactive = false;
  html = campaign_page(c, "1");
  EXPECT_FALSE(has(html, "Without effect in"));
  EXPECT_TRUE(has(html, "Not significant: the effect of contact.friction."));
}

TEST(Tornado, an_effect_up_at_both_ends_is_drawn_as_two_bars) {
  Sensitivity s = one_at_a_time();
  s.effects[0].low.value = 20;
  s.effects[0].high.value = 30;
  const json bars = json::parse(sensitivity_pictures(s)[0].json);
  EXPECT_EQ(bars["side_by_side"], true) << "both from the case to the right";
  EXPECT_EQ(bars["groups"][1]["bars"][0]["end"], 20);
  EXPECT_EQ(bars["groups"][1]["bars"][1]["end"], 30);
  EXPECT_TRUE(has(sensitivity_words(s), "mill.speed matters most")) << "24 W over 18 W";
}

TEST(Tornado, ends_in_one_place_do_not_hide_each_other) {
  Sensitivity s = one_at_a_time();
  s.effects[0].low = s.effects[0].high = s.base;
  s.effects[0].inactive = true;
  const json idle = groups_of(s)[1]["bars"];
  EXPECT_EQ(idle[0]["note"], "") << "both ends in one note";
  EXPECT_EQ(idle[1]["note"], "0.2, 0.8");
  // The case is at the low end of the range.
  s.effects[0].high.value = 14;
  s.effects[0].inactive = false;
  const json one_end = json::parse(sensitivity_pictures(s)[0].json);
  EXPECT_EQ(one_end["groups"][1]["bars"][0]["note"], "0.2");
  EXPECT_EQ(one_end["groups"][1]["bars"][1]["note"], "0.8");
  EXPECT_EQ(one_end["side_by_side"], true) << "below each other";
}

TEST(Tornado, of_morris_has_bars_of_mean_sizes_and_a_scatter) {
  Sensitivity s{.quantity = "d50", .unit = "m", .design = Design::morris};
  s.effects.push_back({.key = "contact.friction",
                       .mean_absolute = observe::IntervalEstimate::around(5e-7, 6e-7),
                       .mean = observe::IntervalEstimate::around(1e-7, 6e-7),
                       .deviation = {.value = 6e-7},
                       .of_noise = 4e-7,
                       .count = 1,
                       .significant = false});
  s.effects.push_back({.key = "mill.speed",
                       .mean_absolute = observe::IntervalEstimate::around(8e-6, 6e-7),
                       .mean = observe::IntervalEstimate::around(-8e-6, 6e-7),
                       .deviation = observe::IntervalEstimate::around(1e-6, 4e-7),
                       .of_noise = 5e-7,
                       .count = 12,
                       .significant = true});
  const std::vector<Picture> pictures = sensitivity_pictures(s);
  ASSERT_EQ(pictures.size(), 2U);
  const json bars = groups_of(s);
  EXPECT_EQ(bars[0]["bars"][0]["end"], 8) << "µm";
  EXPECT_NEAR(bars[1]["bars"][0]["end"], 0.5, 1e-7);
  EXPECT_TRUE(has(pictures[0].caption, "data-v=\"-8e-06\">-8.00 ± 0.60<"));
  EXPECT_TRUE(in_order(pictures[0].caption, {">from noise<", ">effects<", ">8.00 ± 0.60<",
                                             "data-v=\"5e-07\">0.5000<", "data-v=\"12\">12<"}));
  const json scatter = json::parse(pictures[1].json);
  EXPECT_EQ(scatter["series"][0]["name"], "mill.speed");
  EXPECT_EQ(scatter["series"][0]["y"], json::parse("[1]")) << "sigma in µm";
  EXPECT_EQ(scatter["series"][1]["name"], "contact.friction");
  EXPECT_EQ(sensitivity_words(s),
            "D50: mill.speed matters most (on average 8.00 ± 0.60 µm over "
            "its range). Not significant: the effect of "
            "contact.friction.");
}

TEST(Tornado, of_sobol_has_a_pair_of_bars_a_key) {
  Sensitivity s{.quantity = "d50", .unit = "m", .design = Design::sobol_indices, .noise = 0.125};
  s.effects.push_back({.key = "mill.speed",
                       .first_order = observe::IntervalEstimate::around(0.5, 0.04),
                       .total = {0.75, 0.73, 0.79},
                       .count = 64,
                       .significant = true});
  s.effects.push_back({.key = "contact.friction",
                       .first_order = observe::IntervalEstimate::around(-0.01, 0.04),
                       .total = observe::IntervalEstimate::around(0.02, 0.03),
                       .count = 63,
                       .significant = false});
  s.effects.push_back({.key = "jar.material"});  // with unknown effects
  const std::vector<Picture> pictures = sensitivity_pictures(s);
  ASSERT_EQ(pictures.size(), 1U);
  const json bars = groups_of(s);
  EXPECT_EQ(bars[0]["bars"][0]["end"], 0.5);
  EXPECT_EQ(bars[0]["bars"][1]["end"], 0.75);
  EXPECT_EQ(bars[2]["name"], "jar.material");
  EXPECT_EQ(bars[2]["bars"][1]["end"], json()) << "unknown";
  EXPECT_EQ(sensitivity_words(s),
            "D50: mill.speed matters most (0.750 ± "
            "0.030 of the variance, with interactions). Not significant: the effect of "
            "contact.friction.");
  EXPECT_TRUE(in_order(pictures[0].caption, {"Noise is 12 % of the observed variance", ">groups<",
                                             ">0.75 (0.73 to 0.79)<", ">64<", ">63<"}));
  s.noise = NAN;
  EXPECT_TRUE(has(sensitivity_pictures(s)[0].caption, "errors of the points are unknown"));
}

TEST(Tornado, says_once_how_much_was_used_where_that_is_the_same_for_all) {
  Sensitivity s{.quantity = "d50", .unit = "m", .design = Design::sobol_indices, .noise = 0.125};
  s.effects = {{.key = "mill.speed", .total = {.value = 0.75}, .count = 64},
               {.key = "contact.friction", .total = {.value = 0.02}, .count = 64}};
  const std::string below = sensitivity_pictures(s)[0].caption;
  EXPECT_TRUE(has(below, "<p>Groups of runs: 64. Noise is")) << below;
  EXPECT_FALSE(has(below, ">groups<"));
}

TEST(Tornado, draws_an_interval_that_lies_unevenly) {
  Sensitivity s{.quantity = "d50", .unit = "m", .design = Design::sobol_indices, .noise = 0.125};
  s.effects = {{.key = "mill.speed", .total = {0.5, 0.25, 1.25}}};
  const json total = groups_of(s)[0]["bars"][1];
  EXPECT_EQ(total["low"], 0.25);
  EXPECT_EQ(total["high"], 1.25);
}

TEST(Tornado, of_an_outcome_that_varies_no_more_than_its_errors_is_a_sentence) {
  Sensitivity s{.quantity = "d50",
                .unit = "m",
                .design = Design::sobol_indices,
                .variance = -1e-14,
                .noise = 1.1,
                .effects = {{.key = "mill.speed", .count = 64, .significant = false}}};
  EXPECT_EQ(sensitivity_words(s),
            "D50: does not vary more than the errors of its points: more replicates or points are "
            "needed.");
  EXPECT_TRUE(sensitivity_pictures(s).empty()) << "no empty plot";
  s.variance = 0;
  s.noise = NAN;
  EXPECT_EQ(sensitivity_words(s), "D50: is the same at all points.");
}

TEST(Tornado, an_interval_that_is_not_known_is_not_shown) {
  Sensitivity s{.quantity = "dissipated_power", .unit = "W", .design = Design::morris};
  s.effects = {
      {.key = "mill.speed", .mean_absolute = {.value = 24}, .mean = {.value = -24}, .count = 1}};
  const std::vector<Picture> pictures = sensitivity_pictures(s);
  EXPECT_FALSE(has(pictures[0].caption, "±"));
  EXPECT_EQ(sensitivity_words(s),
            "dissipated power: mill.speed matters most (on average 24.00 W over its range).");
}

TEST(Tornado, stands_on_the_page) {
  Campaign c = scattered(20);
  c.sensitivities = {one_at_a_time()};
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "<p>dissipated power: mill.speed matters most"));
  EXPECT_EQ(picture_names(html).front(), "bars dissipated power");
}

}  // namespace
}  // namespace mahlwerk::report::sensitivity_test
