// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/archive.hpp"

#include <gtest/gtest.h>

#include <string>

namespace mahlwerk::archive_test {
namespace {

/// Not inlined: GCC 12 would warn of unwritten bytes in the string's own buffer, a false alarm.
[[gnu::noinline]] Archive reader(const std::string& bytes) {
  return Archive(bytes);
}

TEST(Archive, gives_back_what_was_written) {
  Archive out;
  bool yes = true, no = false;
  double x = 0.1;
  std::string text = "ball";
  out(yes)(no)(x)(text);
  Archive in = reader(out.bytes());
  bool first = false, second = true;
  double y = 0;
  std::string read;
  in(first)(second)(y)(read);
  in.finish();
  EXPECT_TRUE(first);
  EXPECT_FALSE(second);
  EXPECT_EQ(x, y);
  EXPECT_EQ(text, read);
}

TEST(Archive, refuses_a_byte_that_is_neither_true_nor_false) {
  bool value = false;
  EXPECT_THROW(reader("e")(value), RunError);
  EXPECT_FALSE(value);
}

TEST(Archive, refuses_too_few_and_too_many_bytes) {
  double x = 0;
  EXPECT_THROW(reader(std::string(7, 'x'))(x), RunError);
  Archive more = reader(std::string(9, '\0'));
  more(x);
  EXPECT_THROW(more.finish(), RunError);
}

}  // namespace
}  // namespace mahlwerk::archive_test
