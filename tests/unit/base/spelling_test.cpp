// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/spelling.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace mahlwerk::spelling_test {
namespace {

TEST(Spelling, finds_the_word_that_was_meant) {
  const std::vector<std::string> words{"frequency", "amplitude", "tilt", "kind"};
  EXPECT_EQ(nearest_word("frequancy", words), "frequency");
  EXPECT_EQ(nearest_word("Amplitude", words), "amplitude");
  EXPECT_EQ(nearest_word("tlit", words), "tilt");
  EXPECT_EQ(nearest_word("colour", words), "");
  EXPECT_EQ(nearest_word("", words), "");
}

}  // namespace
}  // namespace mahlwerk::spelling_test
