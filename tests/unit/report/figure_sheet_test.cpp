// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Figures of several panels, and what programs that convert SVG see of them.
#include "mahlwerk/report/plot/figure_sheet.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"

namespace mahlwerk::report::figure_sheet_test {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Plot plot() {
  Plot made{"", {"time (s)"}, {"$E_{n}$ (J)"}, {}};
  made.series.push_back({.name = "points",
                         .x = {1, 2, 3},
                         .y = {1, 2, 4},
                         .error = {0.5, 0.5, 0.5},
                         .mark = Mark::points,
                         .band = true});
  made.series.push_back({.name = "measured", .x = {2}, .y = {3}, .mark = Mark::squares});
  made.width = column_width;
  made.height = 250;
  made.font = figure_font;
  return made;
}

std::string figure() {
  const std::string drawing = svg(plot());
  return figure_svg("Figure <1>", {{"", {{"a", "first & last", drawing}}},
                                   {"", {{"b", "second", drawing}}},
                                   {"third", {{"c", "", drawing}}}});
}

std::vector<std::string> all_kinds() {
  return {svg(plot()), figure()};
}

TEST(Figures, have_plain_colours_on_a_white_ground) {
  for (const std::string& picture : all_kinds()) {
    EXPECT_FALSE(has(picture, "var(")) << picture;
    EXPECT_FALSE(has(picture, " style=")) << picture;
    const std::size_t ground = picture.find("<rect width=");
    EXPECT_EQ(ground, picture.find('\n') + 1) << "behind all else";
    EXPECT_TRUE(has(picture.substr(ground, 80), "fill=\"#ffffff\"/>")) << picture.substr(0, 600);
  }
}

TEST(Figures, of_two_columns_are_twice_as_wide_as_those_of_one) {
  const FigurePanel panel{"", "", svg(plot())};
  EXPECT_TRUE(figure_svg("f", {{"", {panel}}}).find("width=\"340\"") < 200U);
  EXPECT_TRUE(figure_svg("f", {{"", {panel}}, {"", {panel}}}).find("width=\"680\"") < 200U);
}

TEST(Figures, hold_each_panel_with_its_letter_and_title_once) {
  const std::string drawn = figure();
  for (const char* text : {"font-weight=\"700\">a<", "font-weight=\"700\">b<",
                           "font-weight=\"700\">c<", ">first &amp; last<", ">second<", ">third<"}) {
    const std::size_t at = drawn.find(text);
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_EQ(drawn.find(text, at + 1), std::string::npos) << text;
  }
  // The second panel stands beside the first, the third below both.
  EXPECT_TRUE(has(drawn, "<svg x=\"340.0\" y=\"18.0\" width=\"340\" height=\"250\""));
  EXPECT_TRUE(has(drawn, "<svg x=\"0.0\" y=\"309.0\" width=\"340\" height=\"250\"")) << drawn;
  EXPECT_FALSE(has(drawn.substr(drawn.find("<rect width=") + 1), "<rect width="))
      << "panels have no ground of their own";
}

/// What rsvg-convert draws, as SVG without text, classes and variables; empty without the program.
std::string converted(const std::string& picture) {
  const std::filesystem::path place =
      std::filesystem::temp_directory_path() / ("mahlwerk-figure-" + std::to_string(::getpid()));
  std::filesystem::create_directories(place);
  std::ofstream(place / "in.svg") << picture;
  const std::string command = "rsvg-convert --format svg --output '" +
                              (place / "out.svg").string() + "' '" + (place / "in.svg").string() +
                              "' 2>&1";
  const int status = std::system(command.c_str());
  std::ifstream file(place / "out.svg");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  file.close();
  std::filesystem::remove_all(place);
  return status == 0 ? text : "";
}

TEST(Figures, keep_axes_and_grid_in_librsvg) {
  if (std::system("rsvg-convert --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "rsvg-convert is not installed";
  const std::string drawn = converted(figure());
  ASSERT_FALSE(drawn.empty());
  // Axes #59636e and grid #e3e6ea; 0x59 is 34.9 % of 255, 0xe3 is 89.0 %.
  for (const char* colour : {"stroke:rgb(34.9", "stroke:rgb(89.0"})
    EXPECT_TRUE(has(drawn, colour)) << colour;
}

}  // namespace
}  // namespace mahlwerk::report::figure_sheet_test
