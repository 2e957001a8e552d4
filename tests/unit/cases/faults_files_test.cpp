// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::faults_files_test {
namespace {

using namespace sample;

TEST(CaseFaults, files_that_are_not_there) {
  const Folder folder;
  const auto code = [&](const std::string& name) {
    try {
      read(folder.path() / name, catalogue());
    } catch (const InputError& error) {
      return error.faults().at(0).code;
    }
    return std::string();
  };
  EXPECT_EQ(code("nowhere.toml"), "no-such-file");
  EXPECT_EQ(code("."), "no-such-file");
}

/// A device may have no end.
TEST(CaseFaults, devices_and_folders_are_no_files_of_numbers) {
  const Folder folder;
  const auto code = [&](const std::string& text) {
    folder.write("case.toml", text);
    try {
      read(folder.path() / "case.toml", catalogue());
    } catch (const InputError& error) {
      return error.faults().at(0).code;
    }
    return std::string();
  };
  for (const std::string place : {"/dev/null", "."})
    EXPECT_EQ(code(with(with(with(vial, "kind", "kind = \"tabulated\"\nfile = \"" + place + "\""),
                             "frequency", ""),
                        "amplitude", "")),
              "no-such-file")
        << place;
  EXPECT_EQ(code(with(vial, "time", "time = \"1 s\"\nstart_from = \"/dev/null\"")), "no-such-file");
}

TEST(CaseFaults, bad_rows_of_a_measured_motion) {
  const Folder folder;
  folder.write("case.toml", with(with(with(vial, "kind", "kind = \"tabulated\"\nfile = \"m.csv\""),
                                      "frequency", ""),
                                 "amplitude", ""));
  const auto found = [&](const std::string& csv) {
    folder.write("m.csv", csv);
    std::vector<std::string> places;
    try {
      read(folder.path() / "case.toml", catalogue());
    } catch (const InputError& error) {
      for (const Fault& f : error.faults())
        places.push_back(f.where.substr(f.where.find_last_of('/') + 1) + " " + f.code);
    }
    return places;
  };
  using Places = std::vector<std::string>;
  const std::string head = "time_s,x_m,y_m,z_m\n";
  EXPECT_EQ(
      found(head + "0,0,0,0\n1,0,0,1\n2,0,0,0,5\n3,0,x,0\n4,0,0,nan\n3,0,0,0\n"),
      (Places{"m.csv:4 bad-motion-file", "m.csv:5 bad-motion-file", "m.csv:6 bad-motion-file"}));
  EXPECT_EQ(found(head + "0,0,0,0\n1,0,0,1\n1,0,0,0\n2,0,0,0\n"),
            (Places{"m.csv:4 bad-motion-file"}));
  EXPECT_EQ(found("t,x,y,z\n0,0,0,0\n"), (Places{"m.csv:1 bad-motion-file"}));
  EXPECT_EQ(found(head + "0,0,0,0\n1,1e308,0,0\n2,0,0,0\n"), (Places{"m.csv:3 bad-motion-file"}));
  EXPECT_EQ(found(head + "0,0,0,0\n1,0,0,1\n"), (Places{"m.csv bad-motion-file"}));
  EXPECT_EQ(found(""), (Places{"m.csv bad-motion-file"}));
  std::filesystem::remove(folder.path() / "m.csv");
  try {
    read(folder.path() / "case.toml", catalogue());
    FAIL() << "a missing motion file was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().at(0).where, (folder.path() / "case.toml").generic_string() + ":5");
    EXPECT_EQ(error.faults().at(0).code, "no-such-file");
  }
}

}  // namespace
}  // namespace mahlwerk::cases::faults_files_test
