// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/table.hpp"

#include <gtest/gtest.h>

namespace mahlwerk::cases::table_test {
namespace {

TEST(Table, keeps_the_place_of_every_value) {
  const Node root =
      parse_tree("a = 1\n[b]\nc = \"x\"\n[[balls]]\nd = 2.5\n[[balls]]\nd = true\n", "dir/f.toml");
  EXPECT_EQ(root.find("a")->where, "dir/f.toml:1");
  EXPECT_EQ(root.find("a")->source, "f.toml:1");
  EXPECT_TRUE(root.find("a")->is_integer);
  EXPECT_EQ(root.find("b")->find("c")->text, "x");
  ASSERT_EQ(root.find("balls")->items.size(), 2U);
  EXPECT_EQ(root.find("balls")->items[0].find("d")->text, "2.5");
  EXPECT_EQ(root.find("balls")->items[1].find("d")->where, "dir/f.toml:7");
  EXPECT_EQ(root.find("nothing"), nullptr);
}

TEST(Table, keys_of_fifty_thousand_parts_are_refused_with_their_line) {
  std::string deep = "a";
  for (int i = 1; i < 50'000; ++i) deep += ".a";
  for (const std::string& text : {"x = 1\n" + deep + " = 1\n", "x = 1\n[" + deep + "]\ny = 1\n"})
    try {
      parse_tree(text, "case.toml");
      FAIL() << "such a tree would end the program";
    } catch (const InputError& e) {
      EXPECT_EQ(e.faults().at(0).where, "case.toml:2");
      EXPECT_EQ(e.faults().at(0).code, "not-toml");
    }
  EXPECT_NO_THROW(parse_tree("x = \"" + std::string(500, '.') + "\"  # " + deep, "case.toml"));
}

TEST(Table, loose_values_are_toml_or_text) {
  const auto value = [](const char* text) {
    return value_from_text(text, "--set x", Precedence::command);
  };
  EXPECT_EQ(value("400 rpm").kind, Node::Kind::text);
  EXPECT_EQ(value("400 rpm").text, "400 rpm");
  EXPECT_EQ(value("\"400 rpm\"").text, "400 rpm");
  EXPECT_EQ(value("\"\"").text, "");
  EXPECT_EQ(value("0.5").kind, Node::Kind::number);
  EXPECT_EQ(value("5").text, "5");
  EXPECT_TRUE(value("5").is_integer);
  EXPECT_EQ(value("true").kind, Node::Kind::boolean);
  EXPECT_EQ(value("1:-2").text, "1:-2");
  EXPECT_EQ(value("2024-01-01").kind, Node::Kind::text);
  EXPECT_EQ(value("2024-01-01").text, "2024-01-01");
  EXPECT_EQ(value("{a = 1}").kind, Node::Kind::text);
  EXPECT_EQ(value("1\nseed = 2").kind, Node::Kind::text);
  EXPECT_EQ(value("").kind, Node::Kind::text);
  EXPECT_EQ(value("5").where, "--set x");
}

TEST(Table, puts_and_finds_by_dotted_key) {
  Node root = parse_tree("[mill]\nspeed = \"1 Hz\"\n[[balls]]\n[[balls]]\n", "f.toml");
  const auto five = [] { return value_from_text("5", "--set", Precedence::command); };
  EXPECT_NE(value_at(root, "mill.speed"), nullptr);
  EXPECT_EQ(value_at(root, "mill.other"), nullptr);
  EXPECT_EQ(value_at(root, "balls.count"), nullptr);
  EXPECT_EQ(set_value(root, "balls.count", five()), "");
  EXPECT_NE(value_at(root, "balls.1.count"), nullptr);
  EXPECT_EQ(value_at(root, "balls.2.count"), nullptr);
  EXPECT_EQ(set_value(root, "balls.2.count", five()), "");
  EXPECT_NE(value_at(root, "balls.2.count"), nullptr);
  EXPECT_EQ(set_value(root, "run.time", five()), "");
  EXPECT_NE(value_at(root, "run.time"), nullptr);
  EXPECT_EQ(set_value(root, "seed", five()), "");
  EXPECT_NE(value_at(root, "seed"), nullptr);
  for (const char* key :
       {"", ".", "a.", ".a", "balls.3.count", "balls.x.count", "mill.speed.x", "a.b.c"})
    EXPECT_NE(set_value(root, key, five()), "") << key;
}

TEST(Table, what_is_no_toml_names_its_line) {
  try {
    parse_tree("a = 1\nb = \n", "f.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().at(0).where, "f.toml:2");
  }
}

}  // namespace
}  // namespace mahlwerk::cases::table_test
