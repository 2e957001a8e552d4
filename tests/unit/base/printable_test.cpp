// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/printable.hpp"

#include <gtest/gtest.h>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::printable_test {
namespace {

using namespace std::string_literals;

TEST(Printable, text_stays_as_it_is) {
  for (const char* text : {"", "a ball", "two\nlines\tand a tab", "Mühle 5 µm ≥ 10⁻³ 🙂"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, control_characters_are_escaped_as_in_toml) {
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\u001b[31mred\\u0007");
  EXPECT_EQ(printable("c\0d\r\x7f"s), "c\\u0000d\\u000d\\u007f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\u009b") << "CSI as one character";
  EXPECT_EQ(printable("\xef\xbf\xbf"), "\\uffff") << "XML has no place for it";
}

TEST(Printable, bytes_that_are_no_utf8_are_shown) {
  EXPECT_EQ(printable("a\xff\xfe"), "a\\xff\\xfe");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut short";
  EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "ESC in two bytes";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last";
}

TEST(Printable, faults_are_described_in_printable_text) {
  EXPECT_EQ(describe({Fault{"a\x1b", "b\x01", "", ""}}), "a\\u001b: b\\u0001");
}

TEST(Printable, control_characters_are_found) {
  EXPECT_FALSE(has_control("partition=long µ"));
  EXPECT_TRUE(has_control("a\nb"));
  EXPECT_TRUE(has_control("\x7f"));
}

}  // namespace
}  // namespace mahlwerk::printable_test
