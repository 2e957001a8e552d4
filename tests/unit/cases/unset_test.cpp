// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// --unset: a key or a section is taken from a case.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/read.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::unset_test {
namespace {

using sample::catalogue;

const std::string text = sample::vial_with_two_balls + R"([[balls]]
count = 3
diameter = "4 mm"
density = "7850 kg/m3"
[powder]
mass = "1 g"
[contact]
restitution = 0.9
friction = 0.25
[run]
time = "1 s"
replicates = 7
)";

Override unset(const std::string& key) {
  return {.key = key, .value = "", .unset = true};
}

Case read_with(const std::vector<Override>& overrides, const std::string& more = "") {
  return read_text(text + more, "case.toml", catalogue(), overrides);
}

Fault fault_of(const std::vector<Override>& overrides, const std::string& more = "") {
  try {
    read_with(overrides, more);
    return {};
  } catch (const InputError& error) {
    return error.faults().front();
  }
}

TEST(Unset, a_key_gets_its_default) {
  const Case c = read_with({unset("run.replicates")});
  EXPECT_NE(c.run.replicates, 7);
  const auto origin = std::ranges::find(c.origins, "run.replicates", &Origin::key);
  ASSERT_NE(origin, c.origins.end());
  EXPECT_TRUE(origin->assumed) << origin->source;
}

TEST(Unset, a_section_is_gone_as_if_it_had_not_been_written) {
  const Case c = read_with({unset("powder")});
  EXPECT_TRUE(read_with({}).powder.has_value());
  EXPECT_FALSE(c.powder.has_value());
}

TEST(Unset, a_value_that_is_set_as_well_counts) {
  EXPECT_EQ(read_with({unset("run.replicates"), {"run.replicates", "3"}}).run.replicates, 3);
}

TEST(Unset, a_key_that_the_file_does_not_give_is_refused_with_the_nearest) {
  const Fault near = fault_of({unset("run.replicatse")});
  EXPECT_EQ(near.where, "--unset run.replicatse");
  EXPECT_EQ(near.what, "the case file gives no run.replicatse");
  EXPECT_EQ(near.remedy, "did you mean run.replicates?");
  EXPECT_EQ(near.code, "unknown-key");
  EXPECT_EQ(fault_of({unset("balls.2.material")}).where, "--unset balls.2.material");
  EXPECT_EQ(fault_of({unset("balls.9.count")}).where, "--unset balls.9.count");
}

TEST(Unset, a_required_key_is_missing_then) {
  EXPECT_EQ(fault_of({unset("balls.2.diameter")}).code, "missing-value");
}

TEST(Unset, a_swept_key_may_lose_its_value_in_the_file) {
  const std::string sweep = "[sweep]\n\"run.replicates\" = [3, 4]\n";
  EXPECT_EQ(fault_of({{"run.replicates", "5"}}, sweep).code, "swept-value") << "as by --set";
  EXPECT_EQ(read_with({unset("run.replicates")}, sweep).run.replicates, 3);
}

TEST(Unset, gives_no_value) {
  EXPECT_TRUE(gives_value({{"mill.frequency", "3 Hz"}}, "mill.frequency"));
  EXPECT_FALSE(gives_value({unset("mill.frequency")}, "mill.frequency"));
}

}  // namespace
}  // namespace mahlwerk::cases::unset_test
