// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/plot/picture_json.hpp"

// Pictures of a campaign's page.
namespace mahlwerk::report {

/// A picture as JSON (picture_json.hpp), and its caption (HTML).
struct Picture {
  std::string json, caption = {};
};

/// How the quantities of a campaign are drawn: lines over the key with the most values if there are
/// few lines; maps if two keys have at least three values each; else dots over each key, joined if
/// the design is a star.
struct Layout {
  std::size_t axis = 0;    ///< the key with the most values
  std::size_t second = 0;  ///< the numeric key with the second most values
  bool lines = false, maps = false, dots = false;
};
Layout layout_of(const Sheet& sheet);

/// The points of one line of a plot along the axis, and the values of the other keys as text.
struct Line {
  std::string others;
  std::vector<std::size_t> points;
};
std::vector<Line> lines_of(const Sheet& sheet, std::size_t axis);

/// The values of a quantity at `points`, in the displayed multiple of its unit, over a key.
Series series_of(const Sheet& sheet, const std::vector<std::size_t>& points, std::size_t key,
                 std::size_t column);

/// The pictures of a quantity for the layout.
std::vector<Picture> quantity_pictures(const Sheet& sheet, const Layout& layout,
                                       std::size_t column);

/// A heat map over the two keys of the layout for each combination of the other keys.
std::vector<Picture> heat_maps(const Sheet& sheet, const Layout& layout, std::size_t column);

/// Map of the charge's regime if exactly two keys vary; empty if no point has a regime.
std::vector<Picture> regime_map(const Sheet& sheet);

/// Sensitivity of a quantity to the keys: bars, and for Morris's method a scatter plot of the
/// effects.
std::vector<Picture> sensitivity_pictures(const Sensitivity& sensitivity);

/// Size of an effect: the range of the quantity, mu*, or the share of variance. NaN: unknown.
double magnitude(const Effect& effect, const Sensitivity& sensitivity);
/// The effects by decreasing magnitude; unknown ones last.
std::vector<Effect> largest_first(const Sensitivity& sensitivity);

/// Sentences: the key that matters most, and the effects that do not differ significantly from
/// zero. Keys in `inactive` are omitted.
std::string sensitivity_words(const Sensitivity& sensitivity,
                              const std::vector<std::string>& inactive = {});
/// Keys that affect none of the quantities.
std::vector<std::string> inactive_keys(const std::vector<Sensitivity>& sensitivities);
/// "a, b and c".
std::string joined(const std::vector<std::string>& words);

/// Laws fitted to the points of each line: table and verdict (HTML), and the best law as a curve.
struct FittedLines {
  std::string table;
  std::vector<Series> curves;
};
FittedLines laws_of_lines(const Sheet& sheet, std::size_t axis, std::size_t column,
                          const std::vector<Series>& lines);

}  // namespace mahlwerk::report
