// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/trial_store.hpp"

#include <gtest/gtest.h>

#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::trial_store_test {
namespace {

TEST(TrialStore, notices_are_there_again_when_a_search_goes_on) {
  const cases::sample::Folder here;
  const auto file = here.path() / "trials.sqlite";
  const TrialResult results{
      .replicates = {{1.5, 2}, {3, 4}},
      .failure = "",
      .notices = {invalid("long-contacts", "it's 77 %"), note("time-step", "1 us")}};
  const auto trouble = [](const Fault& fault) { ADD_FAILURE() << fault.what; };
  TrialStore(file, "power", trouble).keep(7, results);
  TrialStore again(file, "power", trouble);
  const auto found = again.find(7);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->replicates, results.replicates);
  EXPECT_EQ(found->notices, results.notices);
  EXPECT_FALSE(again.find(8));
}

}  // namespace
}  // namespace mahlwerk::campaign::trial_store_test
