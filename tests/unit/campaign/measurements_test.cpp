// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/measurements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace mahlwerk::campaign::measurements_test {
namespace {

Measurements of(const std::string& text) {
  return read_measurements_text(text, "data.csv");
}

std::vector<Fault> faults_of(const std::string& text) {
  try {
    of(text);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

/// Reading `text` gives exactly one fault, with this place, cause and code.
void expect_fault(const std::string& text, const std::string& where, const std::string& what,
                  const std::string& code) {
  const std::vector<Fault> faults = faults_of(text);
  ASSERT_EQ(faults.size(), 1U) << text << "\n" << describe(faults);
  EXPECT_EQ(faults[0].where, where) << text;
  EXPECT_NE(faults[0].what.find(what), std::string::npos) << faults[0].what;
  EXPECT_EQ(faults[0].code, code) << faults[0].what;
  EXPECT_FALSE(faults[0].remedy.empty()) << faults[0].what;
}

TEST(Measurements, are_read_in_the_units_of_their_headings) {
  const Measurements all =
      of("# a comment\n\n"
         "time (min), D50 [mm], D90_um, specific_surface_m2_per_kg, conversion (%)\n"
         "2, 0.25, 800, 12.5, 40\n");
  ASSERT_EQ(all.values.size(), 4U);
  for (const Measurement& m : all.values) {
    EXPECT_EQ(m.time, 120);
    EXPECT_EQ(m.line, 4);
    EXPECT_EQ(m.condition, 0U);
    EXPECT_TRUE(std::isnan(m.error));
  }
  EXPECT_EQ(all.values[0].what, MeasuredQuantity::quantile);
  EXPECT_EQ(all.values[0].percent, 50);
  EXPECT_EQ(all.values[0].value, 0.25e-3);
  EXPECT_EQ(all.values[1].percent, 90);
  EXPECT_EQ(all.values[1].value, 800e-6);
  EXPECT_EQ(all.values[2].what, MeasuredQuantity::specific_surface);
  EXPECT_EQ(all.values[2].value, 12.5);
  EXPECT_EQ(all.values[3].what, MeasuredQuantity::conversion);
  EXPECT_EQ(all.values[3].value, 0.4);
  EXPECT_FALSE(all.errors_known());
  ASSERT_EQ(all.conditions.size(), 1U);
  EXPECT_TRUE(all.conditions[0].empty());
}

TEST(Measurements, may_be_whole_distributions_with_errors) {
  const Measurements all =
      of("size (um);passing (%);passing_error (%)\n"
         "100;12,5;2\n"
         "200;60;2\n"
         "400;60;2\n");
  ASSERT_EQ(all.values.size(), 3U);
  EXPECT_EQ(all.values[0].what, MeasuredQuantity::passing);
  EXPECT_EQ(all.values[0].size, 100e-6);
  EXPECT_EQ(all.values[0].value, 0.125) << "a decimal comma, as spreadsheets may write it";
  EXPECT_EQ(all.values[0].error, 0.02);
  EXPECT_TRUE(std::isnan(all.values[0].time));
  EXPECT_TRUE(all.errors_known());
}

TEST(Measurements, share_conditions_that_are_equal) {
  const Measurements all =
      of("mill.frequency (Hz),balls.1.count,D90 (um)\r\n"
         "16,1,900\r\n19,1,700\r\n16,1,880\r\n,2,500\r\n");
  ASSERT_EQ(all.conditions.size(), 3U);
  ASSERT_EQ(all.conditions[0].size(), 2U);
  EXPECT_EQ(all.conditions[0][0].key, "mill.frequency");
  EXPECT_EQ(all.conditions[0][0].value, "16 Hz");
  EXPECT_EQ(all.conditions[0][1].value, "1");
  EXPECT_EQ(all.conditions[1][0].value, "19 Hz");
  ASSERT_EQ(all.conditions[2].size(), 1U) << "an empty cell leaves it as the case says";
  EXPECT_EQ(all.conditions[2][0].key, "balls.1.count");
  ASSERT_EQ(all.values.size(), 4U);
  EXPECT_EQ(all.values[2].condition, 0U);
  EXPECT_EQ(all.values[3].condition, 2U);
}

TEST(Measurements, empty_cells_were_not_measured) {
  const Measurements all = of("time (s),D50 (um),D90 (um)\n10,,900\n20,300,\n,250,600,,\n");
  ASSERT_EQ(all.values.size(), 4U);
  EXPECT_EQ(all.values[0].percent, 90);
  EXPECT_EQ(all.values[1].percent, 50);
  EXPECT_TRUE(std::isnan(all.values[2].time));
}

TEST(Measurements, may_be_quoted_and_begin_with_a_byte_order_mark) {
  const Measurements all =
      of("\xEF\xBB\xBF\"D90 (um)\",\"mill.model\"\n\"900\",\"a \"\"b\"\", c\"\n");
  ASSERT_EQ(all.values.size(), 1U);
  EXPECT_EQ(all.conditions[0][0].value, "a \"b\", c");
}

TEST(Measurements, may_repeat_what_was_measured) {
  EXPECT_EQ(of("size (um),passing (%)\n100,10\n200,50\n100,12\n200,47\n").values.size(), 4U);
  EXPECT_EQ(of("size (um),passing (%)\n200,50\n100,10\n200,47\n100,12\n").values.size(), 4U);
}

TEST(Measurements, of_which_there_is_no_file_are_refused) {
  EXPECT_THROW(read_measurements("/no/such/file.csv"), InputError);
  EXPECT_THROW(read_measurements(std::filesystem::temp_directory_path()), InputError);
}

TEST(Measurements, unknown_columns_are_named_with_what_may_have_been_meant) {
  expect_fault("D9O (um)\n900\n", "data.csv:1", "unknown column \"D9O (um)\"", "unknown-column");
  EXPECT_EQ(faults_of("d50 (um)\n9\n").at(0).remedy, "did you mean \"D50 (um)\"?");
  EXPECT_EQ(faults_of("D90 (um),D90_eror (um)\n9,1\n").at(0).remedy,
            "did you mean \"D90_error (um)\"?");
  expect_fault("D90 (um),\n900,\n", "data.csv:1", "unknown column \"\"", "unknown-column");
  expect_fault("D0 (um)\n900\n", "data.csv:1", "unknown column", "unknown-column");
  expect_fault("D100 (um)\n900\n", "data.csv:1", "unknown column", "unknown-column");
  expect_fault("D90 (um),time_error (s)\n900,1\n", "data.csv:1", "unknown column",
               "unknown-column");
}

TEST(Measurements, units_that_are_missing_or_wrong_are_told_once) {
  expect_fault("D90\n900\n800\n", "data.csv:1", "column \"D90\": the unit is missing",
               "bad-quantity");
  expect_fault("D90 (kg)\n900\n", "data.csv:1", "is not a length", "bad-quantity");
  expect_fault("D90 (umm)\n900\n", "data.csv:1", "there is no unit", "bad-quantity");
  expect_fault("time,D90 (um)\n1,900\n", "data.csv:1", "column \"time\"", "bad-quantity");
}

TEST(Measurements, cells_that_are_no_numbers_are_named) {
  expect_fault("D90 (um)\n900\nmany\n", "data.csv:3", "\"many\" in column \"D90\"", "bad-quantity");
  expect_fault("D90 (um)\nnan\n", "data.csv:2", "\"nan\"", "bad-quantity");
  expect_fault("D90 (um)\n1e999\n", "data.csv:2", "\"1e999\"", "bad-quantity");
  expect_fault("D90 (um)\n9 mm\n", "data.csv:2", "\"9 mm\"", "bad-quantity");
}

TEST(Measurements, numbers_out_of_range_are_named) {
  expect_fault("D90 (um)\n-9\n", "data.csv:2", "D90 = -9 is out of range: it must be above 0 m",
               "out-of-range");
  expect_fault("D90 (um),D90_error (um)\n9,0\n", "data.csv:2", "D90_error = 0", "out-of-range");
  expect_fault("time (s),D90 (um)\n-1,9\n", "data.csv:2", "time = -1", "out-of-range");
  expect_fault("size (um),passing\n0,0.5\n", "data.csv:2", "size = 0", "out-of-range");
  expect_fault("size (um),passing\n9,35\n", "data.csv:2",
               "passing = 35 is out of range: it must be at least 0 and at most 1", "out-of-range");
  expect_fault("conversion\n1.2\n", "data.csv:2", "conversion = 1.2", "out-of-range");
}

TEST(Measurements, that_contradict_themselves_are_refused) {
  expect_fault("D50 (um),D90 (um)\n900,800\n", "data.csv:2", "D50 is larger than D90", "bad-data");
  expect_fault("size (um),passing (%)\n100,40\n200,30\n", "data.csv:3", "share passing falls",
               "bad-data");
  expect_fault("size (um),passing (%)\n200,30\n100,40\n", "data.csv:3", "share passing falls",
               "bad-data");
}

TEST(Measurements, tables_that_say_nothing_are_refused) {
  expect_fault("", "data.csv", "no table", "bad-data");
  expect_fault("# a remark\n", "data.csv:1", "no table", "bad-data");
  expect_fault("D90 (um)\n", "data.csv", "no row", "bad-data");
  expect_fault("time (s)\n5\n", "data.csv:1", "no column holds measured values", "bad-data");
  expect_fault("time (s),D90 (um)\n5,\n", "data.csv:2", "holds no measured value", "bad-data");
}

TEST(Measurements, columns_that_do_not_go_together_are_refused) {
  expect_fault("D90 (um),D90 (mm)\n9,8\n", "data.csv:1", "two columns", "bad-data");
  expect_fault("size (um),D90 (um)\n9,8\n", "data.csv:1", "a distribution needs", "bad-data");
  expect_fault("passing (%)\n9\n", "data.csv:1", "a distribution needs", "bad-data");
  expect_fault("D90 (um),D50_error (um)\n9,8\n", "data.csv:1", "none of \"D50\"", "bad-data");
  expect_fault("D90 (um),D50 (um)\n9\n", "data.csv:2", "1 cells under 2 headings", "bad-data");
  expect_fault("D90 (um)\n9,8\n", "data.csv:2", "2 cells under 1 headings", "bad-data");
  expect_fault("D90 (um),size (um),passing\n9,8,\n", "data.csv:2", "no share passing", "bad-data");
  expect_fault("D90 (um),size (um),passing\n9,,0.3\n", "data.csv:2", "no size", "bad-data");
  expect_fault("D90 (um),D90_error (um),D10 (um)\n,1,9\n", "data.csv:2", "but no value",
               "bad-data");
  expect_fault("D90 (um),D90_error (um)\n9,1\n8,\n", "data.csv", "1 of 2 values have no error",
               "bad-data");
}

TEST(Measurements, all_faults_are_told_together_up_to_twenty) {
  EXPECT_EQ(faults_of("D90 (um),D50 (um)\n-1,x\ny,3\n").size(), 3U);
  std::string wrong = "D90 (um)\n";
  for (int i = 0; i < 100; ++i) wrong += "wrong\n";
  EXPECT_EQ(faults_of(wrong).size(), 20U);
}

TEST(Measurements, know_their_names_and_units) {
  EXPECT_EQ(name_of(MeasuredQuantity::quantile, 90), "D90");
  EXPECT_EQ(name_of(MeasuredQuantity::specific_surface, 0), "specific_surface");
  EXPECT_EQ(unit_of(MeasuredQuantity::quantile), "m");
  EXPECT_EQ(unit_of(MeasuredQuantity::specific_surface), "m2/kg");
  EXPECT_EQ(unit_of(MeasuredQuantity::passing), "");
}

}  // namespace
}  // namespace mahlwerk::campaign::measurements_test
