// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/picture_json.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mahlwerk/report/page.hpp"
#include "unit/report/html.hpp"

namespace mahlwerk::report::picture_json_test {
namespace {

using Json = nlohmann::json;

Plot plot() {
  return {.title = "A </script> \"plot\"",
          .x = Axis{.label = "speed (rpm)", .logarithmic = true, .least = 10},
          .y = Axis{.label = "share", .range_least = 0, .range_most = 1},
          .series = {{"both", {1, 2}, {0.9, NAN}, {0.3, 0.1}, Mark::points, {}, true},
                     {"bins", {1, 2, 4}, {3, 0}, {}, Mark::steps, 9}},
          .shape = 0.5};
}

TEST(PlotJson, holds_what_the_script_draws) {
  const Json made = Json::parse(picture_json(plot()));
  EXPECT_EQ(made["title"], "A </script> \"plot\"");
  EXPECT_EQ(made["shape"], 0.5);
  EXPECT_EQ(made["x"],
            Json::parse(R"json({"label":"speed (rpm)","log":true,"least":10,"most":null})json"));
  EXPECT_EQ(made["series"][0]["mark"], "points");
  EXPECT_EQ(made["series"][0]["colour"], 0);
  EXPECT_EQ(made["series"][0]["band"], true);
  EXPECT_EQ(made["series"][1], Json::parse(R"({"name":"bins","mark":"steps","colour":9,"band":false,
                                               "x":[1,2,4],"y":[3,0]})"));
}

TEST(PlotJson, cuts_intervals_at_the_range_and_has_null_for_no_number) {
  const Json series = Json::parse(picture_json(plot()))["series"][0];
  EXPECT_EQ(series["y"], Json::parse("[0.9,null]"));
  EXPECT_NEAR(series["low"][0], 0.6, 1e-7);  // 0.9 - 0.3
  EXPECT_EQ(series["high"], Json::parse("[1,null]")) << "not 1.2: a share is at most 1";
}

TEST(MapJson, holds_its_cells_and_null_where_there_is_none) {
  ColourMap map{.title = "Wall", .quantity = "power", .unit = "W", .most = 2};
  map.panels = {{.title = "side",
                 .x = {.label = "angle (°)", .edges = {0, 180, 360}},
                 .y = {.label = "material", .names = {"steel"}},
                 .values = {1.23456, NAN},
                 .failed = {false, true},
                 .shape = 0.5}};
  const Json made = Json::parse(picture_json(map));
  EXPECT_EQ(made["kind"], "map");
  EXPECT_EQ(made["most"], 2);
  const Json& panel = made["panels"][0];
  EXPECT_EQ(panel["values"], Json::parse("[1.235,null]"));
  EXPECT_EQ(panel["failed"], Json::parse("[false,true]"));
  EXPECT_EQ(panel["x"]["edges"], Json::parse("[0,180,360]"));
  EXPECT_EQ(panel["y"]["names"], Json::parse(R"(["steel"])"));
  EXPECT_FALSE(panel.contains("told")) << "the axes say where a cell is";
}

TEST(BarsJson, holds_ends_and_intervals) {
  const BarPlot plot{.title = "Power",
                     .label = "W",
                     .base = 1,
                     .groups = {{"speed", {{3, 0.5, 1, "400 rpm"}, {NAN, NAN}}}},
                     .legend = {"low", "high"}};
  const Json made = Json::parse(picture_json(plot));
  EXPECT_EQ(made["groups"][0]["bars"][0],
            Json::parse(R"({"end":3,"low":2.5,"high":3.5,"colour":1,"note":"400 rpm"})"));
  EXPECT_EQ(made["groups"][0]["bars"][1]["end"], Json());
  EXPECT_EQ(made["base"], 1);
}

TEST(PlotJson, cannot_end_its_script_element) {
  const std::string html = figure(plot(), "");
  EXPECT_EQ(times(html, "</script>"), 1U);
  EXPECT_TRUE(well_formed(html));
}

TEST(PlotPage, has_the_script_once_and_only_where_there_are_plots) {
  const std::string one = figure(plot(), "");
  EXPECT_EQ(times(page("", one + one, ""), "uPlot:"), 1U);
  EXPECT_EQ(times(page("", "<p>words</p>", ""), "uPlot:"), 0U);
}

}  // namespace
}  // namespace mahlwerk::report::picture_json_test
