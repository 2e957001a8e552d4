// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/notices/notice_counts.hpp"

#include <gtest/gtest.h>

namespace mahlwerk::results::notice_counts_test {
namespace {

TEST(NoticeCounts, count_runs_by_code_and_keep_the_words_of_the_first) {
  NoticeCounts counts;
  count(counts, {note("engine-chosen", "event")});
  count(counts, {warning("long-contacts", "31 %"), note("engine-chosen", "soft")});
  count(counts, {});
  count(counts, {invalid("long-contacts", "77 %")});
  sort(counts);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].first, invalid("long-contacts", "31 %")) << "the gravest severity, and first";
  EXPECT_EQ(counts[0].runs, 2U);
  EXPECT_EQ(counts[1].first, note("engine-chosen", "event"));
  EXPECT_EQ(counts[1].runs, 2U);
  EXPECT_EQ(sentence(counts[0], 4, "point"), "2 of 4 points: long-contacts: 31 %");
}

TEST(NoticeCounts, a_code_that_a_run_has_twice_counts_once) {
  NoticeCounts counts;
  count(counts, {warning("stopped", "Replicate 1"), warning("stopped", "Replicate 2")});
  ASSERT_EQ(counts.size(), 1U);
  EXPECT_EQ(counts[0].runs, 1U);
  EXPECT_EQ(counts[0].first.text, "Replicate 1");
}

TEST(NoticeCounts, codes_of_warnings_are_a_cell_of_a_table) {
  EXPECT_EQ(warning_codes({}), "");
  EXPECT_EQ(warning_codes({note("engine-chosen", "")}), "");
  EXPECT_EQ(warning_codes({invalid("long-contacts", ""), warning("stopped", "a"),
                           warning("stopped", "b"), note("engine-chosen", "")}),
            "long-contacts;stopped");
}

}  // namespace
}  // namespace mahlwerk::results::notice_counts_test
