// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mahlwerk::report::fit_test {
namespace {

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

FittedParameter found(const std::string& key, double value, double low, double high) {
  FittedParameter p{
      {.name = key, .least = 0.01, .most = 100, .unit = "kg/J/m", .about = "a <number>"}};
  p.value = value;
  p.low = low;
  p.high = high;
  p.determined = true;
  p.text = campaign::texts_of(p);
  return p;
}

PredictedMeasurement point(int i, bool error_known) {
  PredictedMeasurement p;
  p.what = campaign::MeasuredQuantity::quantile;
  p.percent = 90;
  p.condition = static_cast<std::size_t>(i / 2);
  p.time = i % 2 == 0 ? 10.0 : 20.0;
  p.value = 900e-6 - 100e-6 * i;
  p.error = error_known ? 20e-6 : NAN;
  p.predicted.value = 910e-6 - 100e-6 * i;
  p.residual = 0.5;
  p.line = i + 2;
  return p;
}

/// D90 over time under two conditions. One parameter is determined, one is not.
Fit report(bool errors_known) {
  Fit fit;
  fit.title = "A & B";
  fit.case_file = "case.toml";
  fit.data_file = "data.csv";
  fit.result.parameters = {found("breakage.f_mat", 1.234, 1.1, 1.4),
                           found("breakage.lost", 1, 0.01, 100)};
  FittedParameter& lost = fit.result.parameters[1];
  lost.open_low = lost.open_high = true;
  lost.determined = false;
  lost.remarks = {"no measured quantity depends on it"};
  fit.result.correlation = {{1, -0.25}, {-0.25, 1}};
  fit.conditions = {"mill.frequency = 16 Hz", "mill.frequency = 22 Hz"};
  for (int i = 0; i < 4; ++i) fit.points.push_back(point(i, errors_known));
  fit.curves = {{"D90", 0, 0, {0, 10, 20}, {1e-3, 9e-4, 8e-4}},
                {"D90", 1, 0, {0, 10, 20}, {1e-3, 7e-4, 6e-4}}};
  fit.result.remarks = {"the mill ran one replicate"};
  fit.result.scatter = 0.9;
  fit.result.degrees_of_freedom = 2;
  fit.errors_known = errors_known;
  return fit;
}

TEST(FitReport, counts_warnings_of_its_mills) {
  Fit fit = report(true);
  EXPECT_EQ(fit_table(fit).find("Warning:"), std::string::npos);
  fit.notices = {{invalid("long-contacts", "They <touch>."), 1}};
  EXPECT_NE(fit_table(fit).find("Warning: 1 of 2 conditions: long-contacts: They <touch>."),
            std::string::npos);
  EXPECT_NE(fit_page(fit, "1").find("1 of 2 conditions: long-contacts: They &lt;touch&gt;."),
            std::string::npos);
}

TEST(FitReport, says_intervals_as_far_as_there_are_any) {
  FittedParameter n = found("x", 1.234, 1.1, 1.4);
  EXPECT_EQ(n.text.value, "1.23 kg/J/m");
  EXPECT_EQ(n.interval_text(), "1.1 kg/J/m to 1.4 kg/J/m");
  n.open_low = true;
  EXPECT_EQ(n.interval_text(), "up to 1.4 kg/J/m");
  n.open_low = false;
  n.open_high = true;
  EXPECT_EQ(n.interval_text(), "1.1 kg/J/m or more");
  n.determined = false;
  EXPECT_EQ(n.interval_text(), "not determined");
}

TEST(FitReport, shows_as_many_digits_as_the_interval_keeps_apart) {
  const FittedParameter sharp = found("x", 1.23456789, 1.2345, 1.2347);
  EXPECT_EQ(sharp.text.value, "1.23457 kg/J/m");
  EXPECT_EQ(sharp.interval_text(), "1.2345 kg/J/m to 1.2347 kg/J/m");
}

TEST(FitReport, on_the_terminal_names_what_is_not_determined) {
  const std::string table = fit_table(report(false));
  EXPECT_TRUE(has(table, "breakage.f_mat  1.23 kg/J/m  1.1 kg/J/m to 1.4 kg/J/m\n")) << table;
  EXPECT_TRUE(has(table, "not determined            NOT DETERMINED\n")) << table;
  EXPECT_TRUE(has(table, "breakage.lost: no measured quantity depends on it.\n")) << table;
  EXPECT_TRUE(has(table, "the mill ran one replicate.\n")) << table;
  EXPECT_TRUE(has(table, "4 values under 2 conditions, 2 degrees of freedom, scatter 90 %."));
  EXPECT_TRUE(has(fit_table(report(true)), "scatter 0.9 errors."));
}

TEST(FitReport, as_a_table_has_a_row_for_each_value) {
  const std::string csv = fit_csv(report(true));
  EXPECT_TRUE(
      csv.starts_with("line,condition,what,unit,time_s,size_m,measured,error,fitted,residual\n"
                      "2,mill.frequency = 16 Hz,D90,m,10,,0.0009,2e-05,0.00091,0.5\n"))
      << csv;
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  EXPECT_TRUE(has(fit_csv(report(false)), ",0.0009,,0.00091,0.5\n"));
}

TEST(FitReport, as_a_page_shows_numbers_curves_and_what_is_not_determined) {
  for (const bool known : {false, true}) {
    const std::string page = fit_page(report(known), "1.2.3");
    for (const char* part :
         {"A &amp; B", "a &lt;number&gt;", "1.1 kg/J/m to 1.4 kg/J/m", "<s>1 kg/J/m</s>",
          "do not determine <code>breakage.lost</code>", "no measured quantity depends on it.",
          "the mill ran one replicate.", "D90: measured and fitted", "time of milling (s)",
          "Residuals", "-0.250", "mill.frequency = 22 Hz", "910.0 µm", "Mahlwerk 1.2.3"})
      EXPECT_TRUE(has(page, part)) << part;
    EXPECT_FALSE(has(page, "nan"));
    EXPECT_FALSE(has(page, "<number>"));
  }
}

TEST(FitReport, sets_conditions_beside_each_other_where_time_is_one) {
  Fit fit = report(true);
  for (PredictedMeasurement& p : fit.points) p.time = 30;
  EXPECT_TRUE(has(fit_page(fit, "1"), "number of the condition"));
  EXPECT_FALSE(has(fit_page(fit, "1"), "time of milling (s)"));
}

TEST(FitReport, draws_distributions_over_size) {
  Fit fit = report(true);
  for (PredictedMeasurement& p : fit.points) {
    p.what = campaign::MeasuredQuantity::passing;
    p.size = p.value;
    p.value = 0.5;
  }
  for (FitCurve& c : fit.curves) c.what = "passing";
  const std::string page = fit_page(fit, "1");
  EXPECT_TRUE(has(page, "size (µm)"));
  EXPECT_TRUE(has(page, "passing: measured and fitted"));
}

}  // namespace
}  // namespace mahlwerk::report::fit_test
