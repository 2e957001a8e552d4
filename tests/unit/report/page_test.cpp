// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/page.hpp"

#include <gtest/gtest.h>

#include "unit/report/html.hpp"

namespace mahlwerk::report::page_test {
namespace {

std::string some_page() {
  const Plot plot{.title = "Power",
                  .x = Axis{.label = "time (s)"},
                  .y = Axis{.label = "power (W)"},
                  .series = {{"all", {1, 2}, {3, 4}}}};
  return page("A title", "<p>Words.</p>\n" + figure(plot, "caption"), "Mahlwerk 9.9.");
}

TEST(RenewedPage, of_this_version_is_the_same_page) {
  EXPECT_EQ(renewed_page(some_page()), some_page());
}

TEST(RenewedPage, has_the_style_and_scripts_of_this_version_and_its_own_words) {
  std::string old = some_page();
  const auto put = [&](std::string_view begin, std::string_view end) {
    const std::size_t from = old.find(begin) + begin.size();
    old.replace(from, old.find(end, from) - from, "old");
  };
  put("<style>", "</style>");
  put("<script>", "</script>");
  ASSERT_TRUE(has(old, "<style>old</style>") && has(old, "<script>old</script>"));
  EXPECT_EQ(renewed_page(old), some_page());
}

TEST(RenewedPage, of_another_program_there_is_none) {
  EXPECT_FALSE(renewed_page("<!doctype html><style></style><footer>Others</footer>"));
  EXPECT_FALSE(renewed_page(""));
  const std::string whole = some_page();
  EXPECT_FALSE(renewed_page(std::string_view(whole).substr(0, 300))) << "cut";
}

}  // namespace
}  // namespace mahlwerk::report::page_test
