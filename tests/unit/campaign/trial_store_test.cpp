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

TEST(TrialStore, a_damaged_trial_is_told_and_run_again) {
  const cases::sample::Folder here;
  const auto file = here.path() / "trials.sqlite";
  std::string told;
  const auto trouble = [&](const Fault& fault) { told = fault.what; };
  for (const char* damage :
       {"", "UPDATE told SET replicate = -1 WHERE replicate = 1",
        "UPDATE told SET replicate = 1e18 WHERE replicate = 1",
        "DELETE FROM told WHERE replicate = 0", "DELETE FROM told WHERE outcome = 0",
        "DELETE FROM told WHERE outcome = 1 AND replicate = 1"}) {
    std::filesystem::remove(file);
    TrialStore(file, "power", trouble).keep(7, {.replicates = {{1.5, 2}, {3, 4}}, .failure = ""});
    Database(file, Database::Access::write).run(damage);
    EXPECT_EQ(told, "") << "nothing fails so far";
    TrialStore again(file, "power", trouble);
    const bool sound = std::string(damage).empty();
    EXPECT_EQ(again.find(7).has_value(), sound) << damage;
    EXPECT_EQ(told.find("damaged") != std::string::npos, !sound) << damage;
    told.clear();
  }
}

}  // namespace
}  // namespace mahlwerk::campaign::trial_store_test
