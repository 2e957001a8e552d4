// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "mahlwerk/report/campaign/plots.hpp"
#include "unit/report/campaign_fake.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::sensitivity_test {
namespace {

/// x and width of the bars, in drawing order.
std::vector<std::pair<double, double>> bars(const std::string& picture) {
  std::vector<std::pair<double, double>> list;
  for (std::size_t at = picture.find("<rect x=\""); at != std::string::npos;
       at = picture.find("<rect x=\"", at + 1)) {
    const std::size_t wide = picture.find("width=\"", at) + 7;
    const std::string rest = picture.substr(at, picture.find("/>", at) - at);
    if (!has(rest, "fill-opacity")) continue;  // of the legend
    list.emplace_back(std::strtod(picture.c_str() + at + 9, nullptr),
                      std::strtod(picture.c_str() + wide, nullptr));
  }
  return list;
}

/// y of a text.
double place_of(const std::string& picture, const std::string& text) {
  const std::size_t at = picture.rfind(" y=\"", picture.find(text));
  return std::strtod(picture.c_str() + at + 4, nullptr);
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
  EXPECT_EQ(pictures[0].name, "tornado-dissipated_power");
  const std::string& svg = pictures[0].svg;
  EXPECT_TRUE(well_formed(svg));
  EXPECT_TRUE(in_order(svg, {">mill.speed<", ">200 rpm<", ">400 rpm<", ">contact.friction<"}));
  const auto drawn = bars(svg);
  ASSERT_EQ(drawn.size(), 4U);
  const double foot = drawn[1].first;
  EXPECT_NEAR(drawn[0].first + drawn[0].second, foot, 0.11);  // written to a tenth
  // 12 - 4 = 8 to the left, 28 - 12 = 16 to the right.
  EXPECT_NEAR(drawn[0].second / drawn[1].second, 0.5, 0.005);
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
  EXPECT_TRUE(in_order(html, {"<p>Without effect in this case: contact.friction.</p>", "<svg"}));
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
  const std::string svg = sensitivity_pictures(s)[0].svg;
  const auto drawn = bars(svg);
  ASSERT_EQ(drawn.size(), 4U);
  EXPECT_EQ(drawn[2].first, drawn[3].first) << "both from the case to the right";
  EXPECT_NEAR(drawn[2].second / drawn[3].second, 8.0 / 18, 0.005);
  EXPECT_TRUE(has(sensitivity_words(s), "mill.speed matters most")) << "24 W over 18 W";
}

TEST(Tornado, ends_in_one_place_do_not_hide_each_other) {
  Sensitivity s = one_at_a_time();
  s.effects[0].low = s.effects[0].high = s.base;
  s.effects[0].inactive = true;
  const std::string idle = sensitivity_pictures(s)[0].svg;
  EXPECT_TRUE(has(idle, ">0.2, 0.8<"));
  EXPECT_FALSE(has(idle, ">0.2<"));
  EXPECT_EQ(bars(idle)[0].first + bars(idle)[0].second, bars(idle)[1].first) << "on one line";
  // The case is at the low end of the range.
  s.effects[0].high.value = 14;
  s.effects[0].inactive = false;
  const std::string one_end = sensitivity_pictures(s)[0].svg;
  EXPECT_TRUE(in_order(one_end, {">0.2<", ">0.8<"}));
  EXPECT_NE(place_of(one_end, ">0.2<"), place_of(one_end, ">0.8<")) << "below each other";
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
  EXPECT_EQ(pictures[1].name, "tornado-d50-scatter");
  const auto drawn = bars(pictures[0].svg);
  ASSERT_EQ(drawn.size(), 2U);
  EXPECT_NEAR(drawn[1].second / drawn[0].second, 5e-7 / 8e-6, 0.001);
  EXPECT_TRUE(has(pictures[0].caption, "data-v=\"-8e-06\">-8.00 ± 0.60<"));
  EXPECT_TRUE(in_order(pictures[0].caption, {">from noise<", ">effects<", ">8.00 ± 0.60<",
                                             "data-v=\"5e-07\">0.5000<", "data-v=\"12\">12<"}));
  EXPECT_TRUE(in_order(pictures[1].svg, {">mill.speed<", ">contact.friction<", "<circle"}));
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
  EXPECT_TRUE(well_formed(pictures[0].svg));
  EXPECT_FALSE(has(pictures[0].svg, "nan"));
  const auto drawn = bars(pictures[0].svg);
  ASSERT_EQ(drawn.size(), 4U);
  EXPECT_NEAR(drawn[0].second / drawn[1].second, 2.0 / 3, 0.005);
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
  const std::string svg = sensitivity_pictures(s)[0].svg;
  const auto drawn = bars(svg);
  ASSERT_EQ(drawn.size(), 1U);
  const auto [foot, unit] = std::pair(drawn[0].first, drawn[0].second / 0.5);
  const std::size_t at = svg.find("<path d=\"M", svg.find("fill-opacity")) + 10;
  char* rest = nullptr;
  const double low = std::strtod(svg.c_str() + at, &rest);
  const double high = std::strtod(std::strchr(rest, 'H') + 1, nullptr);
  const double digit = 0.051;  // places and widths are written to a tenth, the unit is two widths
  EXPECT_NEAR(low, foot + 0.25 * unit, (2 + 0.25 / 0.5) * digit);
  EXPECT_NEAR(high, foot + 1.25 * unit, (2 + 1.25 / 0.5) * digit);
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

TEST(Tornado, stands_on_the_page_and_among_the_figures) {
  Campaign c = scattered(20);
  c.sensitivities = {one_at_a_time()};
  const std::string html = campaign_page(c, "1");
  EXPECT_TRUE(well_formed(html));
  EXPECT_TRUE(has(html, "<p>dissipated power: mill.speed matters most"));
  EXPECT_TRUE(campaign_figures(c).contains("figures/tornado-dissipated_power.svg"));
}

}  // namespace
}  // namespace mahlwerk::report::sensitivity_test
