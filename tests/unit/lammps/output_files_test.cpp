// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/output_files.hpp"

#include <fmt/format.h>

#include <fstream>

#include "mahlwerk/base/error.hpp"
#include "program.hpp"

namespace mahlwerk::lammps::output_files_test {
namespace {

std::string snapshot(int step, const std::vector<std::string>& rows) {
  std::string text = fmt::format(
      "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS id x\n",
      step, rows.size());
  for (const std::string& row : rows) text += row + " \n";
  return text;
}

class OutputFiles : public tests::ProgramTest {
 protected:
  void add(const std::string& name, const std::string& text) const {
    std::ofstream(here_ / name, std::ios::app) << text;
  }
  OutputFile dump() const { return {here_, "balls", OutputFile::Kind::dump, 2}; }
};

TEST_F(OutputFiles, a_snapshot_is_given_once_it_is_complete) {
  add("from.0.txt", "0\n");
  OutputFile file = dump();
  const std::string whole = snapshot(10, {"1 0.5", "2 -1e-3"});
  EXPECT_EQ(file.next(sessions(here_)), nullptr);  // no file yet
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(file.next(sessions(here_)), nullptr) << "after " << i << " characters";
    add("balls.0.txt", whole.substr(i, 1));
  }
  const Rows* rows = file.next(sessions(here_));
  ASSERT_NE(rows, nullptr);
  EXPECT_EQ(rows->step, 10);
  ASSERT_EQ(rows->count(), 2U);
  EXPECT_EQ(rows->row(1)[1], -1e-3);
  EXPECT_EQ(file.next(sessions(here_)), nullptr);
}

TEST_F(OutputFiles, what_a_killed_process_wrote_after_its_restart_file_is_left_out) {
  add("from.0.txt", "0\n");
  add("balls.0.txt", snapshot(0, {"1 0"}) + snapshot(10, {"1 1"}) + snapshot(20, {"1 2"}) +
                         "ITEM: TIMESTEP\n30\nITEM: NUM");
  add("from.1.txt", "10\n");
  add("balls.1.txt", snapshot(10, {"1 1"}) + snapshot(20, {"1 9"}));
  add("balance.0.txt", "# head\n0 0\n10 1\n20 2\n30");
  add("balance.1.txt", "20 9\n");
  OutputFile balls = dump(), balance(here_, "balance", OutputFile::Kind::table, 2);
  std::string found;
  for (OutputFile* file : {&balls, &balance}) {
    while (const Rows* rows = file->next(sessions(here_)))
      found += fmt::format("{}:{} ", rows->step, rows->row(0)[1]);
    found += "| ";
  }
  EXPECT_EQ(found, "0:0 10:1 20:9 | 0:0 10:1 20:9 | ");
}

TEST_F(OutputFiles, a_damaged_file_is_named) {
  add("from.0.txt", "0\n");
  for (const std::string& bad :
       {snapshot(10, {"1 x"}), snapshot(10, {"1"}), snapshot(10, {"1 2 3"}),
        std::string("ITEM: TIMESTEP\nten\nITEM: NUMBER OF ATOMS\n0\na\nb\nc\nd\ne\n"),
        std::string("a\nb\nc\nd\ne\nf\ng\nh\ni\n")}) {
    std::filesystem::remove(here_ / "balls.0.txt");
    add("balls.0.txt", bad);
    OutputFile file = dump();
    try {
      file.next(sessions(here_));
      ADD_FAILURE() << bad;
    } catch (const RunError& e) {
      EXPECT_NE(std::string(e.what()).find("balls"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace mahlwerk::lammps::output_files_test
