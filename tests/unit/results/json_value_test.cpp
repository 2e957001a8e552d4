// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/files/json_value.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>

namespace mahlwerk::results::json_value_test {
namespace {

TEST(JsonValue, a_number_that_is_not_finite_is_null) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Json(infinity).text(), "null");
  EXPECT_EQ(Json(std::vector<double>{1, -infinity, nan}).text(), "[1.0,null,null]");
}

TEST(JsonValue, numbers_keep_every_bit_and_their_kind) {
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).text(), "18446744073709551615");
  EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).text(), "-9223372036854775808");
  EXPECT_EQ(Json::array({0.1, 1.0, -0.0, 5e-324, 1}).text(), "[0.1,1.0,-0.0,5e-324,1]");
}

TEST(JsonValue, a_text_is_no_truth_value) {
  EXPECT_EQ(Json::array({"yes", std::string_view("yes"), std::string("yes"), true}).text(),
            R"(["yes","yes","yes",true])");
}

TEST(JsonValue, objects_keep_their_order) {
  Json made = Json::object({{"speed", 1}, {"ball", 2}});
  made["jar"] = 3;
  made["about"] = nullptr;
  made["ball"] = "again";
  EXPECT_EQ(made.text(), R"({"speed":1,"ball":"again","jar":3,"about":null})");
}

TEST(JsonValue, null_becomes_what_is_put_into_it) {
  Json object, array;
  EXPECT_EQ(object.text(), "null");
  object["key"] = 1;
  array.push_back(object);
  array.back()["key"] = Json::array();
  EXPECT_EQ(object.text(), R"({"key":1})");
  EXPECT_EQ(array.text(), R"([{"key":[]}])");
  EXPECT_THROW(array["key"], std::bad_variant_access);
  EXPECT_THROW(object.push_back(1), std::bad_variant_access);
}

TEST(JsonValue, a_list_of_pairs_of_texts_is_no_object) {
  EXPECT_EQ(Json::array({Json::array({"a", "b"}), Json::array({"c", "d"})}).text(),
            R"([["a","b"],["c","d"]])");
}

TEST(JsonValue, control_characters_and_broken_utf8_are_escaped) {
  EXPECT_EQ(Json("\x1b[2J \"M\xC3\xBChle\"\n").text(), "\"\\u001b[2J \\\"M\xC3\xBChle\\\"\\n\"");
  EXPECT_EQ(Json::object({{"M\xFChle", "\xC3"}}).text(), "{\"M\xEF\xBF\xBDhle\":\"\xEF\xBF\xBD\"}");
}

TEST(JsonValue, text_is_what_nlohmann_writes) {
  const Json ours = Json::object(
      {{"title", "A <fake> case & more"},
       {"seed", 7U},
       {"complete", true},
       {"empty", Json::object()},
       {"range", Json::array({1e-9, 2.5e300, nullptr, -3})},
       {"pairs", std::vector<Json>{Json::object({{"between", Json::array({"large", "jar"})}})}},
       {"correlation", std::vector<std::vector<double>>{{1, 0.5}, {}}}});
  const nlohmann::ordered_json theirs{
      {"title", "A <fake> case & more"},
      {"seed", 7U},
      {"complete", true},
      {"empty", nlohmann::ordered_json::object()},
      {"range", {1e-9, 2.5e300, nullptr, -3}},
      {"pairs", nlohmann::ordered_json::array({{{"between", {"large", "jar"}}}})},
      {"correlation", std::vector<std::vector<double>>{{1, 0.5}, {}}}};
  EXPECT_EQ(ours.text(), theirs.dump());
  EXPECT_EQ(ours.text(2), theirs.dump(2));
  EXPECT_EQ(ours.text(0), theirs.dump(0));
}

}  // namespace
}  // namespace mahlwerk::results::json_value_test
