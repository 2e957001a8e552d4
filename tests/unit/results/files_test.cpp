// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/hdf5.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/files/writer.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "unit/results/fake.hpp"
#include "unit/results/scratch.hpp"

namespace mahlwerk::results::files_test {
namespace {

namespace fs = std::filesystem;

double sum(const Table& t, std::size_t column) {
  double all = 0;
  for (const auto& row : t.rows) all += row[column];
  return all;
}

std::vector<std::vector<std::string>> cells(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream row(line + ",");
    for (std::string cell; std::getline(row, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(Csv, reads_back_to_the_bit) {
  const std::vector<double> values{0.1, 1.0 / 3, 1e-300, 6.02214076e23, -2, 0, NAN};
  Table table{{{"a", "s", ""}}, {values}};
  table.columns.resize(values.size());
  const auto rows = cells(csv(table));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0][0], "a_s");
  for (std::size_t i = 0; i + 1 < values.size(); ++i) EXPECT_EQ(std::stod(rows[1][i]), values[i]);
  EXPECT_EQ(rows[1].size() == values.size() ? rows[1].back() : "", "");
}

TEST(Csv, quotes_what_would_break_a_line) {
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_cell("a \"b\""), "\"a \"\"b\"\"\"");
}

TEST(Csv, what_a_spreadsheet_would_compute_is_text) {
  EXPECT_EQ(csv_cell("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_cell("@SUM(A1)"), "\"'@SUM(A1)\"");
  EXPECT_EQ(csv_cell("-2+3+cmd|' /C calc'!A0"), "\"'-2+3+cmd|' /C calc'!A0\"");
  EXPECT_EQ(csv_cell("+A1"), "\"'+A1\"");
  EXPECT_EQ(csv_cell("\t=1"), "\"'\t=1\"");
  for (const char* number : {"-1.5e-3", "+5", "-2 rpm", "-9.81 m/s^2", "-3 kg m^-3", "-5 °C", "-"})
    EXPECT_EQ(csv_cell(number), number);
  EXPECT_EQ(csv_cell(-1.5e-3), "-0.0015");
}

TEST(Csv, control_characters_are_escaped) {
  EXPECT_EQ(csv_cell(std::string_view("c\0d\x1b", 4)), "c\\u0000d\\u001b");
  EXPECT_EQ(csv_cell("a\rb"), "a\\u000db");
  EXPECT_EQ(csv_cell("a\nb"), "\"a\nb\"");
}

TEST(Csv, columns_name_their_units) {
  EXPECT_EQ(column_name("energy", "J"), "energy_J");
  EXPECT_EQ(column_name("rate", "1/s"), "rate_per_s");
  EXPECT_EQ(column_name("speed", "m/s"), "speed_m_per_s");
  EXPECT_EQ(column_name("dose", "W/g"), "dose_W_per_g");
  EXPECT_EQ(column_name("share", "1"), "share");
}

TEST(Csv, heads_are_names_with_units_and_words_are_written) {
  Table table{{{"energy_low", "J", ""}, {"rate", "1/s", ""}, {"share", "1", ""}, {"set", "1", ""}},
              {}};
  for (const char* word : {"a,b", "plain", "a,b"})
    table.rows.push_back({0.5, 100000, NAN, table.columns[3].number_of(word)});
  EXPECT_EQ(csv(table),
            "energy_low_J,rate_per_s,share,set\n"
            "0.5,100000,,\"a,b\"\n0.5,100000,,plain\n0.5,100000,,\"a,b\"\n");
}

/// The column names are those of version 0.1.0, because scripts of users contain them.
TEST(Csv, heads_of_results_stay_as_they_are) {
  const auto head = [](const Table& t) { return csv(t).substr(0, csv(t).find('\n')); };
  const Outcome o = fake_outcome();
  EXPECT_EQ(head(spectrum(o)),
            "energy_low_J,energy_high_J,rate_normal_per_s,rate_contact_point_per_s,"
            "rate_centre_per_s,rate_lost_per_s,power_normal_W,power_contact_point_W,"
            "power_centre_W,power_lost_W,rate_lost_normal_per_s,rate_lost_tangential_per_s,"
            "power_lost_normal_W,power_lost_tangential_W");
  EXPECT_EQ(head(speeds(o)), "speed_low_m_per_s,speed_high_m_per_s,rate_per_s");
  EXPECT_EQ(head(angles(o)), "angle_low_deg,angle_high_deg,rate_per_s,rate_above_threshold_per_s");
  EXPECT_EQ(head(time_series(o)),
            "time_s,collision_rate_per_s,collision_rate_above_threshold_per_s,"
            "energy_normal_mean_J,dissipated_power_W,drawn_power_W,contact_time_share,"
            "kinetic_energy_J");
  EXPECT_EQ(head(balls_at_stop(Replicate(0.1))),
            "ball,kind,radius_m,x_m,y_m,z_m,velocity_x_m_per_s,velocity_y_m_per_s,"
            "velocity_z_m_per_s,spin_x_rad_per_s,spin_y_rad_per_s,spin_z_rad_per_s");
}

TEST(Tables, every_column_says_its_unit_and_what_it_is) {
  const Outcome o = fake_outcome();
  for (const Table& t :
       {spectrum(o), speeds(o), angles(o), time_series(o), replicates(o), collisions_by_pair({}),
        spectra_by_pair(o), sizes(o.mill_case), balls_at_stop(Replicate(0.1))})
    for (const Column& c : t.columns) {
      EXPECT_FALSE(c.unit.empty()) << c.name;
      EXPECT_FALSE(c.about.empty()) << c.name;
    }
}

/// A run that was stopped before it counted anything.
TEST(Tables, without_a_replicate_have_no_rows) {
  Outcome o = fake_outcome({});
  o.mill_case.powder.emplace().mass = 0.001;
  for (const cases::Part* part : cases::parts())
    for (const cases::PartSection& one : part->sections)
      if (one.add != nullptr) one.add(o.mill_case);
  for (const NamedTable& t : tables(o)) EXPECT_TRUE(t.table.rows.empty()) << t.name;
  o.replicates.emplace_back(0.1);
  EXPECT_TRUE(averaged_replicates(o).empty()) << "no time was counted";
  for (const NamedTable& t : tables(o)) EXPECT_TRUE(t.table.rows.empty()) << t.name;
}

TEST(Tables, the_spectrum_holds_every_collision_and_all_energy) {
  const Table t = spectrum(fake_outcome());
  ASSERT_FALSE(t.rows.empty());
  EXPECT_EQ(t.columns[2].name, "rate_normal");
  for (const std::size_t rate : {2U, 3U, 4U, 5U}) EXPECT_NEAR(sum(t, rate), 12, 1e-12);
  EXPECT_NEAR(sum(t, 6), 12 * 0.5 * (0.004 + 2.5e-6), 1e-12);  // power = rate times mean energy
  EXPECT_NEAR(sum(t, 9), 0.012, 1e-12);
  for (const auto& row : t.rows)
    if (row[2] > 0) {  // a bin holds energies within its edges
      EXPECT_LE(row[0] * row[2], row[6] * (1 + 1e-12));
      EXPECT_GE(row[1] * row[2], row[6]);
    }
}

TEST(Tables, neighbouring_bins_touch) {
  for (const Table& t : {spectrum(fake_outcome()), speeds(fake_outcome()), angles(fake_outcome())})
    for (std::size_t i = 0; i + 1 < t.rows.size(); ++i) EXPECT_EQ(t.rows[i][1], t.rows[i + 1][0]);
}

TEST(Tables, speeds_and_angles_hold_every_collision) {
  EXPECT_NEAR(sum(speeds(fake_outcome()), 2), 12, 1e-12);
  const Table t = angles(fake_outcome());
  ASSERT_EQ(t.rows.size(), 90U);
  EXPECT_NEAR(sum(t, 2), 12, 1e-12);
  EXPECT_NEAR(sum(t, 3), 6, 1e-12);
  EXPECT_NEAR(t.rows[0][2], 6, 1e-12);
}

TEST(Tables, the_time_series_is_a_mean_over_replicates) {
  const Table t = time_series(fake_outcome());
  ASSERT_EQ(t.rows.size(), 2U);
  const std::vector<double> expected{10, 12, 6, 0.002, 0.012, 0.012, 0.2, 0.003};
  ASSERT_EQ(t.columns.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(t.rows[1][i], expected[i], 1e-12);
}

TEST(Tables, replicates_have_a_row_each) {
  Outcome o = fake_outcome();
  o.replicates[2].complete = false;
  const Table t = replicates(o);
  ASSERT_EQ(t.rows.size(), 3U);
  EXPECT_EQ(t.columns[2].name, "collision_rate");
  EXPECT_EQ(t.rows[2][1], 0);
  EXPECT_DOUBLE_EQ(t.rows[2][2], 14);
  for (const auto& row : t.rows) EXPECT_EQ(row.size(), t.columns.size());
}

TEST(Tables, are_empty_when_nothing_was_counted) {
  Outcome o = fake_outcome();
  o.replicates.assign(1, Replicate(0.1));
  for (const Table& t : {spectrum(o), speeds(o), angles(o), time_series(o), replicates(o)})
    EXPECT_TRUE(t.rows.empty());
}

class FilesTest : public ScratchTest {};

TEST_F(FilesTest, a_result_is_complete) {
  Folder folder(scratch() / "r", false);
  write(folder, fake_outcome(), "1.2.3", "point-01/");
  folder.commit();
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(scratch() / "r" / "point-01"))
    names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{
                       "summary.json", "result.h5", "case.resolved.toml", "spectrum.csv",
                       "speeds.csv", "angles.csv", "timeseries.csv", "replicates.csv",
                       "normal_tangential.csv", "spectra_by_pair.csv", "wall_map.csv"}));
}

std::vector<scene::Collision> numbered(int from, int to) {
  auto all = fake_collisions(to);
  return {all.begin() + from, all.end()};
}

TEST_F(FilesTest, collisions_read_back_to_the_bit) {
  const fs::path file = scratch() / "c.h5";
  {
    CollisionFile out(file, "title = \"x\"\n", "1.2.3");
    CollisionLog one(out, 0), two(out, 1), none(out, 2);
    one.collisions(numbered(0, 20000));
    two.collisions(numbered(0, 10));
    one.collisions(numbered(20000, 50001));
  }
  {
    CollisionFile out(scratch() / "d.h5", "", "");  // closed explicitly
    CollisionLog(out, 0).collisions(numbered(0, 3));
    out.close();
    out.close();
  }
  const auto one = read_collisions(file, 0), expected = fake_collisions(50001);
  ASSERT_EQ(one.size(), expected.size());
  for (std::size_t i = 0; i < one.size(); i += 777) {
    EXPECT_EQ(one[i].time, expected[i].time);
    EXPECT_EQ(one[i].other, expected[i].other);
    EXPECT_EQ(one[i].where, expected[i].where);
    EXPECT_EQ(one[i].normal, expected[i].normal);
    EXPECT_EQ(one[i].lost_tangential, expected[i].lost_tangential);
  }
  EXPECT_EQ(read_collisions(file, 1).size(), 10U);
  EXPECT_EQ(read_collisions(file, 2).size(), 0U);
  EXPECT_THROW(read_collisions(file, 3), InputError);
  EXPECT_EQ(read_collisions(scratch() / "d.h5", 0).size(), 3U);
}

TEST_F(FilesTest, collisions_pack_well) {
  const fs::path file = scratch() / "c.h5";
  {
    CollisionFile out(file, "", "");
    CollisionLog(out, 0).collisions(fake_collisions(40000));
  }
  EXPECT_LT(fs::file_size(file), 40000 * sizeof(scene::Collision) / 4);
}

TEST_F(FilesTest, a_collision_file_that_cannot_be_made_is_an_error) {
  EXPECT_THROW(CollisionFile(scratch() / "no" / "c.h5", "", ""), InputError);
  EXPECT_THROW(read_collisions(scratch() / "none.h5", 0), InputError);
}

}  // namespace
}  // namespace mahlwerk::results::files_test
