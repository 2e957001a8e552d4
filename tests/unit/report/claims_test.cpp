// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Claims judged against campaigns made by hand.
#include "mahlwerk/report/paper/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mahlwerk::report::claims_test {
namespace {

using Kind = Claim::Kind;

/// y at x for each key "mill.speed", in rpm, with the same interval everywhere.
Campaign campaign(const std::vector<double>& x, const std::vector<double>& y, double ci95) {
  Campaign c;
  c.title = "by hand";
  c.keys = {{"mill.speed", "rpm"}};
  c.columns = {{"power", "W", "made up"}};
  for (std::size_t i = 0; i < x.size(); ++i) {
    Point p;
    p.number = i + 1;
    p.values = {std::to_string(static_cast<int>(x[i])) + " rpm"};
    p.value = {y[i]};
    p.ci95 = {ci95};
    p.regime = x[i] > 250 ? "cataracting" : "cascading";
    c.points.push_back(std::move(p));
  }
  return c;
}

Claim claim(Kind kind, const std::string& is = "") {
  Claim made;
  made.kind = kind;
  made.quantity = "power";
  made.against = "mill.speed";
  made.is = is;
  return made;
}

bool has(const Verdict& judged, const std::string& part) {
  return judged.finding.find(part) != std::string::npos;
}

TEST(Claims, a_trend_holds_if_each_step_is_larger_than_both_intervals) {
  const Claim rises = claim(Kind::trend, "rises");
  const Verdict all = judge(rises, campaign({100, 200, 300}, {1, 2, 3}, 0.49));
  EXPECT_EQ(all.holds, Holds::yes);
  EXPECT_TRUE(has(all, "1.00 ± 0.49 W at speed 100 rpm, 3.00 ± 0.49 W at 300 rpm")) << all.finding;
  EXPECT_TRUE(has(all, "at 2 of 2 steps")) << all.finding;
  const Verdict some = judge(rises, campaign({100, 200, 300}, {1, 1.5, 3}, 0.49));
  EXPECT_EQ(some.holds, Holds::partly);
  EXPECT_TRUE(has(some, "not from 100 rpm to 200 rpm")) << some.finding;
  EXPECT_EQ(judge(rises, campaign({100, 200, 300}, {3, 2, 1}, 0.49)).holds, Holds::no);
  EXPECT_EQ(judge(claim(Kind::trend, "falls"), campaign({100, 200, 300}, {3, 2, 1}, 0.49)).holds,
            Holds::yes);
  EXPECT_EQ(judge(rises, campaign({100, 200, 300}, {1, 2, 3}, NAN)).holds, Holds::undecided);
}

TEST(Claims, the_order_of_a_trend_is_that_of_the_key_not_of_the_runs) {
  const Verdict judged =
      judge(claim(Kind::trend, "rises"), campaign({300, 100, 200}, {3, 1, 2}, 0.1));
  EXPECT_EQ(judged.holds, Holds::yes);
}

TEST(Claims, values_in_other_units_stand_where_they_belong) {
  Campaign c = campaign({1, 2, 3}, {1, 2, 3}, 0.1);
  c.keys[0].unit.clear();
  c.points[0].values = {"100 rpm"};
  c.points[1].values = {"3 Hz"};  // 180 rpm
  c.points[2].values = {"240 rpm"};
  EXPECT_EQ(judge(claim(Kind::trend, "rises"), c).holds, Holds::yes);
  std::swap(c.points[1].value, c.points[2].value);
  EXPECT_EQ(judge(claim(Kind::trend, "rises"), c).holds, Holds::partly);
}

TEST(Claims, a_comparison_gives_the_ratio_with_its_interval) {
  Claim larger = claim(Kind::compare, "larger");
  larger.first = "100 rpm", larger.second = "300 rpm";
  // 6/2 = 3; its half-width sqrt(0.4^2 + (3*0.4)^2)/2 = 0.632.
  const Verdict judged = judge(larger, campaign({100, 200, 300}, {2, 4, 6}, 0.4));
  EXPECT_EQ(judged.holds, Holds::yes);
  EXPECT_TRUE(has(judged, "3.00 ± 0.63 times")) << judged.finding;
  EXPECT_EQ(judge(larger, campaign({100, 300}, {6, 2}, 0.4)).holds, Holds::no);
  EXPECT_EQ(judge(larger, campaign({100, 300}, {2, 2.5}, 0.4)).holds, Holds::undecided);
  EXPECT_EQ(judge(larger, campaign({100, 200}, {2, 4}, 0.4)).holds, Holds::undecided);
  larger.first = "36000 deg/min";  // the same in another unit
  EXPECT_EQ(judge(larger, campaign({100, 300}, {2, 6}, 0.4)).holds, Holds::yes);
}

TEST(Claims, what_is_alike_stays_within_its_bound) {
  Claim alike = claim(Kind::alike);
  alike.within = 0.1;
  EXPECT_EQ(judge(alike, campaign({100, 200, 300}, {1, 1.03, 1.01}, 0.01)).holds, Holds::yes);
  EXPECT_EQ(judge(alike, campaign({100, 200, 300}, {1, 2, 1}, 0.01)).holds, Holds::no);
  EXPECT_EQ(judge(alike, campaign({100, 200, 300}, {1, 1.03, 1.01}, 0.2)).holds, Holds::undecided);
}

TEST(Claims, a_line_is_straight_if_its_curvature_is_surely_small) {
  Claim law = claim(Kind::law);
  law.law = LawForm::line;
  const Verdict line = judge(law, campaign({100, 200, 300, 400}, {5, 7, 9, 11}, 0.1));
  EXPECT_EQ(line.holds, Holds::yes);
  EXPECT_TRUE(has(line, "mW for each rpm")) << line.finding;
  EXPECT_TRUE(line.finding.starts_with("20")) << line.finding;  // 2 W for each 100 rpm
  EXPECT_TRUE(has(line, "R² = 1.0000")) << line.finding;

  // y = x^2 over 1 to 5: the middle is at 9, the chord at 13, the rise is 24: 16.7 %.
  const Campaign square = campaign({100, 200, 300, 400, 500}, {1, 4, 9, 16, 25}, 0.1);
  const Verdict bent = judge(law, square);
  EXPECT_EQ(bent.holds, Holds::no);
  EXPECT_TRUE(has(bent, "deviates by -16.67")) << bent.finding;
  law.within = 0.2;
  EXPECT_EQ(judge(law, square).holds, Holds::yes);
  // A scatter as large as the rise leaves both open.
  law.within = 0.1;
  EXPECT_EQ(judge(law, campaign({100, 200, 300, 400, 500}, {1, 9, 2, 12, 8}, 1)).holds,
            Holds::undecided);
  law.is = "falls";
  EXPECT_EQ(judge(law, campaign({100, 200, 300, 400}, {5, 7, 9, 11}, 0.1)).holds, Holds::no);
}

TEST(Claims, an_exponent_is_judged_by_its_interval_alone) {
  Claim law = claim(Kind::law);
  law.law = LawForm::power;
  law.exponent = 2;
  law.within = 0.05;
  const Campaign square = campaign({100, 200, 300, 400}, {1, 4, 9, 16}, 0.1);
  EXPECT_EQ(judge(law, square).holds, Holds::yes);
  law.exponent = 1.9;
  EXPECT_EQ(judge(law, square).holds, Holds::no);
  law.exponent = 1;
  law.is = "above";
  EXPECT_EQ(judge(law, square).holds, Holds::yes);
  law.is = "below";
  EXPECT_EQ(judge(law, square).holds, Holds::no);
  // A scatter that hides the exponent decides nothing, whatever R2 is.
  const Campaign scattered = campaign({100, 200, 300, 400}, {1, 6, 6, 20}, 0.1);
  law.exponent = 2;
  EXPECT_EQ(judge(law, scattered).holds, Holds::undecided);
  law.is.clear();
  EXPECT_EQ(judge(law, scattered).holds, Holds::undecided);
  EXPECT_EQ(judge(law, campaign({100, 200, 300}, {1, 4, 9}, 0.1)).holds, Holds::undecided);
}

TEST(Claims, a_maximum_lies_where_no_value_outside_may_be_the_largest) {
  Claim most = claim(Kind::maximum);
  most.first = "200 rpm", most.second = "300 rpm";
  const Verdict judged = judge(most, campaign({100, 200, 300, 400}, {1, 3, 2.9, 1}, 0.1));
  EXPECT_EQ(judged.holds, Holds::yes);
  EXPECT_TRUE(has(judged, "anywhere from 200 rpm to 300 rpm")) << judged.finding;
  EXPECT_EQ(judge(most, campaign({100, 200, 300, 400}, {1, 3, 2.9, 2.95}, 0.1)).holds,
            Holds::undecided);
  EXPECT_EQ(judge(most, campaign({100, 200, 300, 400}, {1, 2, 3, 4}, 0.1)).holds, Holds::no);
}

/// Power at frictions 0.2 and 0.8 for each speed, and measured values with their errors.
Campaign assumed_friction(const std::vector<double>& x, const std::vector<double>& low,
                          const std::vector<double>& high) {
  Campaign c = campaign(x, low, 0.1);
  c.keys.push_back({"contact.friction", ""});
  for (Point& p : c.points) p.values.emplace_back("0.2");
  for (std::size_t i = 0; i < x.size(); ++i) {
    Point p = c.points[i];
    p.values[1] = "0.8";
    p.value = {high[i]};
    c.points.push_back(std::move(p));
  }
  return c;
}

TEST(Claims, measured_values_agree_if_their_interval_meets_the_band_over_what_is_assumed) {
  Claim one = claim(Kind::measured);
  Measurement measured{.name = "m",
                       .source = "s",
                       .error_is = "",
                       .status = Measurement::Status::verified,
                       .values = {{"100 rpm", "10 W", "0.5 W"}, {"200 rpm", "20 W", "0.5 W"}},
                       .where = ""};
  const Verdict both = judge(one, assumed_friction({100, 200}, {9, 18}, {11, 19.6}), &measured);
  EXPECT_EQ(both.holds, Holds::yes) << both.finding;
  EXPECT_NEAR(both.deviation, 0.11, 1e-12);  // (9 - 0.1)/10 and (11 + 0.1)/10
  EXPECT_TRUE(has(both, "100 rpm: measured 10.00 ± 0.50 W, predicted 8.90")) << both.finding;
  EXPECT_EQ(judge(one, assumed_friction({100, 200}, {9, 18}, {11, 19}), &measured).holds,
            Holds::partly);
  EXPECT_EQ(judge(one, assumed_friction({100, 200}, {5, 8}, {6, 9}), &measured).holds, Holds::no);
  const Verdict wide = judge(one, assumed_friction({100, 200}, {5, 10}, {15, 30}), &measured);
  EXPECT_EQ(wide.holds, Holds::undecided);
  EXPECT_TRUE(has(wide, "factor of 2")) << wide.finding;
  measured.status = Measurement::Status::unverified;
  const Verdict open = judge(one, assumed_friction({100, 200}, {9, 18}, {11, 19.6}), &measured);
  EXPECT_EQ(open.holds, Holds::undecided);
  EXPECT_TRUE(std::isnan(open.deviation));
  EXPECT_TRUE(has(open, "unverified")) << open.finding;
}

TEST(Claims, many_combinations_of_other_keys_are_counted) {
  Campaign c = assumed_friction({100, 200, 300}, {1, 2, 3}, {3, 2, 1});
  const std::size_t half = c.points.size() / 2;
  for (const char* more : {"0.3", "0.4", "0.5"})
    for (std::size_t i = 0; i < half; ++i) {
      Point p = c.points[i];
      p.values[1] = more;
      c.points.push_back(std::move(p));
    }
  const Verdict judged = judge(claim(Kind::trend, "rises"), c);
  EXPECT_EQ(judged.holds, Holds::partly);
  EXPECT_EQ(judged.finding, "yes in 4, no in 1 of 5 combinations of the other keys");
}

TEST(Claims, regimes_are_counted_and_told) {
  const Campaign c = campaign({100, 200, 300}, {1, 2, 3}, 0.1);
  const Verdict judged = judge(claim(Kind::regime, "cascading"), c);
  EXPECT_EQ(judged.holds, Holds::partly);
  EXPECT_EQ(judged.finding, "cascading at speed 100 rpm, 200 rpm; cataracting at speed 300 rpm");
  EXPECT_EQ(judge(claim(Kind::regime, "rolling"), c).holds, Holds::no);
  Claim slow = claim(Kind::regime, "cascading");
  slow.at = {{"mill.speed", {"100 rpm", "200 rpm"}}};
  EXPECT_EQ(judge(slow, c).holds, Holds::yes);
}

TEST(Claims, a_bound_is_kept_by_more_than_the_interval) {
  Claim bound = claim(Kind::bound, "above");
  bound.bound = 0.8;
  EXPECT_EQ(judge(bound, campaign({100, 200}, {1, 2}, 0.1)).holds, Holds::yes);
  EXPECT_EQ(judge(bound, campaign({100, 200}, {0.5, 2}, 0.1)).holds, Holds::partly);
  EXPECT_EQ(judge(bound, campaign({100, 200}, {0.5, 0.6}, 0.1)).holds, Holds::no);
  EXPECT_EQ(judge(bound, campaign({100, 200}, {0.8, 0.8}, 0.1)).holds, Holds::undecided);
}

TEST(Claims, a_bound_is_compared_in_the_unit_of_its_quantity) {
  Campaign doses = campaign({100, 200}, {100, 200}, 10);  // J/g
  doses.columns[0].unit = "J/g";
  Claim bound = claim(Kind::bound, "above");
  bound.bound = 50e3;  // J/kg
  EXPECT_EQ(judge(bound, doses).holds, Holds::yes);
  bound.bound = 300e3;
  EXPECT_EQ(judge(bound, doses).holds, Holds::no);
}

TEST(Claims, other_keys_make_lines_of_their_own_but_not_those_that_go_together) {
  Campaign c;
  c.title = "two lines";
  c.keys = {{"mill.speed", "rpm"}, {"run.time", "s"}, {"contact.friction", ""}};
  c.columns = {{"power", "W", "made up"}};
  for (const bool rough : {false, true})
    for (const int i : {1, 2, 3}) {
      Point p;
      p.values = {std::to_string(100 * i) + " rpm", std::to_string(i) + " s", rough ? "0.5" : "0"};
      p.value = {rough ? 1.0 * i : 1.0};
      p.ci95 = {0.1};
      c.points.push_back(std::move(p));
    }
  const Verdict judged = judge(claim(Kind::trend, "rises"), c);
  EXPECT_EQ(judged.holds, Holds::partly);
  EXPECT_TRUE(judged.finding.starts_with("friction 0: ")) << judged.finding;
  EXPECT_TRUE(has(judged, "; friction 0.5: ")) << judged.finding;
  EXPECT_FALSE(has(judged, "time")) << judged.finding;
  c.keys[0].key = "wall.friction";  // then the last word of the key is ambiguous
  Claim along = claim(Kind::trend, "rises");
  along.against = "wall.friction";
  EXPECT_TRUE(judge(along, c).finding.starts_with("contact friction 0: "));
}

TEST(Claims, a_point_that_gave_nothing_is_no_evidence) {
  Campaign c = campaign({100, 200, 300}, {1, NAN, 3}, 0.1);
  EXPECT_EQ(judge(claim(Kind::trend, "rises"), c).holds, Holds::undecided);
  c.points.clear();
  EXPECT_EQ(judge(claim(Kind::trend, "rises"), c).holds, Holds::undecided);
}

}  // namespace
}  // namespace mahlwerk::report::claims_test
