// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"

// The pictures of a campaign's page.
namespace mahlwerk::report {

/// A picture, its file's name without "figures/" and ".svg", and what stands below it (HTML).
struct Picture {
  std::string name, svg, caption;
};

/// How the quantities of a campaign are drawn: against the key with most values, as lines where
/// they are few; as maps where two keys have three values and more; else as dots against each
/// key, which of a star are joined.
struct Layout {
  std::size_t axis = 0;    ///< the key with most values
  std::size_t second = 0;  ///< that with most after it, of numbers
  bool lines = false, maps = false, dots = false;
};
Layout layout_of(const Sheet& sheet);

/// The points of one line of a plot, along the axis, and what the other keys say there.
struct Line {
  std::string others;
  std::vector<std::size_t> points;
};
std::vector<Line> lines_of(const Sheet& sheet, std::size_t axis);

/// The values of a quantity at `points`, in the multiple it is shown in, against a key.
Series series_of(const Sheet& sheet, const std::vector<std::size_t>& points, std::size_t key,
                 std::size_t column);

/// A quantity as the layout asks.
std::vector<Picture> quantity_pictures(const Sheet& sheet, const Layout& layout,
                                       std::size_t column);

/// A map for each combination of what varies besides the two keys.
std::vector<Picture> heat_maps(const Sheet& sheet, const Layout& layout, std::size_t column);

/// Which regime the charge is in, where two keys vary; nothing where there is none.
std::vector<Picture> regime_map(const Sheet& sheet);

/// A quantity's answer to the keys: bars, and for Morris's method how the effects scatter.
std::vector<Picture> sensitivity_pictures(const Sensitivity& sensitivity);

/// How far a quantity goes with the key, or its share of variance.
double magnitude(const Effect& effect, const Sensitivity& sensitivity);
/// Those of which nothing is known last.
std::vector<Effect> largest_first(const Sensitivity& sensitivity);

/// Which key matters most, and which cannot be told from none: a sentence or two. Of keys that are
/// `inactive` in the whole campaign it need not be said again.
std::string sensitivity_words(const Sensitivity& sensitivity,
                              const std::vector<std::string>& inactive = {});
/// Keys that change none of the quantities.
std::vector<std::string> inactive_keys(const std::vector<Sensitivity>& sensitivities);
/// "a, b and c".
std::string joined(const std::vector<std::string>& words);

/// Laws through a line's points: a table and what it says (HTML), and the best of them as a curve.
struct FittedLines {
  std::string table;
  std::vector<Series> curves;
};
FittedLines laws_of_lines(const Sheet& sheet, std::size_t axis, std::size_t column,
                          const std::vector<Series>& lines);

}  // namespace mahlwerk::report
