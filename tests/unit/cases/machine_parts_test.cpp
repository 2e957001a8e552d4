// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Faults of [[parts]], the bodies of the mill in the jar.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::machine_parts_test {
namespace {

using namespace sample;

/// A vessel with the parts of `parts`.
std::string vessel(const std::string& parts) {
  return R"(title = "Vessel"
[mill]
kind = "still"
[jar]
kind = "cylinder"
diameter = "100 mm"
height = "100 mm"
[[balls]]
diameter = "10 mm"
density = "7800 kg/m3"
count = 20
[run]
time = "1 s"
engine = "soft"
)" + parts;
}

const std::string disc = R"([[parts]]
name = "disc"
kind = "disc"
diameter = "60 mm"
thickness = "5 mm"
motion = "turning"
speed = "300 rpm"
)";

/// "code: what|remedy" of each fault.
std::vector<std::string> told(const std::string& text, const std::vector<Override>& set = {}) {
  std::vector<std::string> all;
  for (const Fault& f : faults_of(text, set))
    all.push_back(f.where + "|" + f.code + "|" + f.what + "|" + f.remedy);
  return all;
}

TEST(MachineParts, that_a_change_names_and_the_case_lacks_are_counted) {
  const std::string remedy =
      "|name a value of a part by the number of its [[parts]] in the case, from 1: parts.1.speed; "
      "a further part needs a [[parts]] of its own in the case file";
  EXPECT_TRUE(told(vessel(disc), {{"parts.1.speed", "200 rpm"}}).empty());
  EXPECT_EQ(told(vessel(disc), {{"parts.3.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.3.speed|unknown-key|\"parts.3.speed\" names "
                                     "nothing in the case; parts in the case: 1" +
                                     remedy});
  EXPECT_EQ(told(vessel(disc), {{"parts.stirrer.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.stirrer.speed|unknown-key|"
                                     "\"parts.stirrer.speed\" names nothing in the case; parts in "
                                     "the case: 1" +
                                     remedy});
  EXPECT_EQ(told(vessel(""), {{"parts.1.speed", "200 rpm"}}),
            std::vector<std::string>{"--set parts.1.speed|unknown-key|\"parts.1.speed\" names "
                                     "nothing in the case; parts in the case: 0" +
                                     remedy});
}

/// The table says where the part is: without one nothing is known of it.
TEST(MachineParts, with_a_bad_motion_file_have_this_fault_alone) {
  const auto faults_with = [](const std::string& table) {
    const Folder folder;
    if (!table.empty()) folder.write("motion.csv", table);
    folder.write("case.toml", vessel(R"([[parts]]
name = "piston"
kind = "disc"
diameter = "60 mm"
thickness = "5 mm"
position = ["0 mm", "0 mm", "500 mm"]
motion = "tabulated"
motion_file = "motion.csv"
)"));
    std::vector<std::string> codes;
    try {
      read(folder.path() / "case.toml", catalogue());
    } catch (const InputError& error) {
      for (const Fault& f : error.faults()) codes.push_back(f.code);
    }
    return codes;
  };
  using Codes = std::vector<std::string>;
  EXPECT_EQ(faults_with(""), Codes{"no-such-file"});
  EXPECT_EQ(faults_with("nonsense\n"), Codes{"bad-motion-file"});
  EXPECT_EQ(faults_with("time_s,x_m,y_m,z_m\n0,0,0,0\n1,0,0,0\n"), Codes{"bad-motion-file"});
  EXPECT_EQ(
      faults_with("time_s,x_m,y_m,z_m\n0,0,0,0\n1,0,0,0.001\n2,0,0,0\n3,0,0,0.001\n4,0,0,0\n"),
      Codes{"bad-part"})
      << "a sound table that keeps the part outside the jar";
}

}  // namespace
}  // namespace mahlwerk::cases::machine_parts_test
