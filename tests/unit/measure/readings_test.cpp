// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/readings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/measure/clock_time.hpp"

namespace mahlwerk::measure::readings_test {
namespace {

std::string refusal(const std::string& text, const char* headings = "") {
  try {
    read_readings(text, "a.csv", headings);
  } catch (const InputError& e) {
    return e.faults().front().where + " " + e.faults().front().what;
  }
  return "";
}

TEST(Readings, have_the_same_numbers_with_every_separator) {
  for (const char* text :
       {"t (s),x (mm)\n0.5,-1\n1.5,2e3\n", "t (s);x (mm)\n0,5;-1\n1,5;2e3\n",
        "t (s)\tx (mm)\r\n0.5\t-1\r\n1.5\t+2e3\r\n", "t/s x/mm\n0,5 -1\n1,5   2e3\n",
        "t (s), x (mm)\n 0.5 -1\n 1.5 2e3",
        "\xEF\xBB\xBFMeter 7\n\n# mine\n\"t [s]\";\"x [mm]\"\n0,5;-1\n1.5;2e3\n"}) {
    const Readings table = read_readings(text, "a.csv");
    ASSERT_EQ(table.columns.size(), 2U) << text;
    const ReadingColumn *t = table.find({"t"}), *x = table.find({"X"});
    if (x == nullptr) x = table.find({"x"});
    ASSERT_TRUE(t != nullptr && x != nullptr) << text;
    EXPECT_EQ(t->values, (std::vector<double>{0.5, 1.5})) << text;
    EXPECT_EQ(in_unit(table, *x, "m"), (std::vector<double>{-0.001, 2})) << text;
    EXPECT_EQ(t->unit, "s");
  }
}

TEST(Readings, take_headings_from_elsewhere) {
  const Readings table = read_readings("1;2\n3;4\n", "a.csv", "time (ms), x1 (px)");
  EXPECT_EQ(in_unit(table, table.columns[0], "s"), (std::vector<double>{0.001, 0.003}));
  EXPECT_EQ(table.columns[1].unit, "px");
  EXPECT_EQ(read_readings("1;2\n", "a.csv").columns[1].name, "2");
}

TEST(Readings, may_lack_numbers) {
  const Readings table = read_readings("a (W),b\n1,\n-,3\nNaN,4\n", "a.csv");
  EXPECT_TRUE(std::isnan(table.columns[0].values[1]));
  EXPECT_THROW(in_unit(table, table.columns[0], "W", 2), InputError);
}

TEST(Readings, that_are_no_table_are_refused_with_the_line) {
  EXPECT_NE(refusal("").find("a.csv the file holds no row"), std::string::npos);
  EXPECT_NE(refusal("t,x\n").find("no row"), std::string::npos);
  EXPECT_NE(refusal("t,x\n1,2\n3\n").find("a.csv:3 1 cells under 2"), std::string::npos);
  EXPECT_NE(refusal("t,x\n1,2\n3,4q\n").find("a.csv:3 \"4q\" is not a number"), std::string::npos);
  EXPECT_NE(refusal("t,x\n1,2\n3,inf\n").find("\"inf\""), std::string::npos);
  EXPECT_NE(refusal("t,t\n1,2\n").find("two columns"), std::string::npos);
  EXPECT_NE(refusal("t,x\n1,2,3\n").find("3 numbers under 2"), std::string::npos);
  EXPECT_NE(refusal("1,2\n", "a").find("under 1 headings"), std::string::npos);
  EXPECT_NE(refusal(std::string("t,x\n1,2\0", 9)).find("no text file"), std::string::npos);
}

TEST(Readings, in_the_wrong_unit_are_refused) {
  const Readings table = read_readings("t (kg),x\n1,2\n", "a.csv");
  EXPECT_THROW(in_unit(table, table.columns[0], "s"), InputError);
  EXPECT_THROW(in_unit(table, table.columns[1], "m"), InputError) << "no unit";
}

TEST(ClockTime, of_day_and_date_counts_seconds) {
  EXPECT_EQ(clock_time("12:31"), 45060);
  EXPECT_EQ(clock_time("00:00:01.5"), 1.5);
  EXPECT_EQ(clock_time("1970-01-02 00:00:01"), 86401);
  EXPECT_EQ(clock_time("1970-01-02T00:00:01Z"), 86401);
  for (const char* none :
       {"", "12", "12:60", "25:00", "12:30:61", "2026-02-30 12:00", "12:30x", ":", "-1:00"})
    EXPECT_FALSE(clock_time(none)) << none;
  const Readings log = read_readings("clock,P (W)\n23:59:59,1\n24:00:00,2\n", "a.csv");
  EXPECT_EQ(log.columns[0].unit, "s");
  EXPECT_EQ(log.columns[0].values[1] - log.columns[0].values[0], 1);
}

}  // namespace
}  // namespace mahlwerk::measure::readings_test
