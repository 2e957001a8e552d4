// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/figure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/paper/band.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/plot/axis_labels.hpp"
#include "mahlwerk/report/plot/figure_sheet.hpp"
#include "mahlwerk/report/plot/law_words.hpp"
#include "mahlwerk/report/plot/rich_text.hpp"
#include "mahlwerk/report/plot/scale.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// A figure, the units of its axes and the range of its quantity.
struct FigureContext {
  const PaperFigure& figure;
  const Campaign& campaign;
  std::string x_unit, y_unit;
  Multiple multiple;  // of y_unit
  Axis range;         // the range of y in SI units
};

/// The points of a line with the ends of their intervals.
Series points_of(const std::vector<LinePoint>& points, const FigureContext& c) {
  Series made;
  for (const LinePoint& s : points) {
    made.x.push_back(s.x);
    made.y.push_back(s.value);
    made.error.push_back(s.ci95);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Interval ends = interval_at(made, i, c.range);
    made.low.push_back(ends.low);
    made.high.push_back(ends.high);
  }
  return made;
}

/// Curve of a law over the points of a line.
Series curve(const FittedLaw& law, const ClaimLine& line) {
  Series drawn{.name = "", .mark = Mark::line};
  constexpr int steps = 60;
  const auto [least, most] = std::ranges::minmax(line.points, {}, &LinePoint::x);
  for (int i = 0; i <= steps; ++i) {
    drawn.x.push_back(std::lerp(least.x, most.x, static_cast<double>(i) / steps));
    drawn.y.push_back(law.at(drawn.x.back()));
  }
  return drawn;
}

/// "mean of 5 replicates, bars: 95 % interval".
std::string points_words(const std::vector<ClaimLine>& lines, const FigureContext& c) {
  const auto column =
      static_cast<std::size_t>(std::ranges::find(c.campaign.columns, "replicates", &Column::name) -
                               c.campaign.columns.begin());
  double least = INFINITY, most = 0;
  bool bars = false;
  for (const ClaimLine& line : lines)
    for (const LinePoint& s : line.points) {
      bars = bars || s.ci95 > 0;
      const double count = value_at(*s.point, column);
      if (!std::isfinite(count)) continue;
      least = std::min(least, count);
      most = std::max(most, count);
    }
  std::string words = "mean";
  if (least == 1 && most == 1)
    words = "one replicate";
  else if (least == most)
    words = fmt::format("mean of {} replicates", most);
  else if (least < most)
    words = fmt::format("mean of {} to {} replicates", least, most);
  return bars ? words + ", bars: 95 % interval" : words;
}

/// Points and laws of each line.
std::vector<Series> line_series(const std::vector<ClaimLine>& lines, const FigureContext& c) {
  std::vector<Series> list;
  const bool alone = lines.size() == 1 && lines.front().others.empty();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Series points = points_of(lines[i].points, c);
    points.name = alone ? points_words(lines, c) : lines[i].others;
    points.mark = c.figure.law ? Mark::dots : Mark::points;
    points.colour = i;
    const auto law = c.figure.law ? law_along(*c.figure.law, lines[i]) : std::nullopt;
    list.push_back(std::move(points));
    if (!law) continue;
    Series fitted = curve(*law, lines[i]);
    fitted.name = law_words(*law, {.x = symbol_of_key(c.figure.against),
                                   .x_unit = c.x_unit,
                                   .y = symbol_of_quantity(c.figure.quantity),
                                   .multiple = c.multiple});
    fitted.colour = i;
    list.push_back(std::move(fitted));
  }
  if (!alone && !lines.empty())
    list.push_back({.name = points_words(lines, c), .mark = Mark::note});
  return list;
}

std::string keys_words(const std::vector<std::string>& keys) {
  std::string words;
  for (const std::string& key : keys) words += (words.empty() ? "" : ", ") + key_words(key);
  return words;
}

/// The band over free numbers of each line and, if the figure names them, their nominal values.
std::vector<Series> band_series(const FigureContext& c) {
  std::vector<Series> list;
  std::vector<ClaimLine> nominal;
  const std::vector<BandLine> bands = bands_along(c.figure, c.campaign);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    Series area{
        .name = fmt::format("{}{}all values of {}, with 95 % intervals", bands[i].others,
                            bands[i].others.empty() ? "" : ": ", keys_words(c.figure.band_over)),
        .mark = Mark::area,
        .colour = i};
    for (const BandPoint& b : bands[i].points) {
      area.x.push_back(b.x);
      area.y.push_back(NAN);
      area.low.push_back(std::clamp(b.low, c.range.range_least, c.range.range_most));
      area.high.push_back(std::clamp(b.high, c.range.range_least, c.range.range_most));
    }
    list.push_back(std::move(area));
    if (!bands[i].nominal.empty()) nominal.push_back({bands[i].others, bands[i].nominal});
  }
  for (Series& points : line_series(nominal, c)) list.push_back(std::move(points));
  return list;
}

Series measured_series(const MeasuredSeries& given, const FigureContext& c) {
  Series made{.name = given.name, .x = given.x, .y = given.y, .mark = Mark::squares};
  for (std::size_t i = 0; i < given.y.size(); ++i) {
    const bool bars = i < given.error_low.size() && i < given.error_high.size();
    made.low.push_back(bars ? std::max(given.y[i] - given.error_low[i], c.range.range_least) : NAN);
    made.high.push_back(bars ? std::min(given.y[i] + given.error_high[i], c.range.range_most)
                             : NAN);
  }
  return made;
}

std::string_view kind_of(Mark mark) {
  return mark == Mark::line      ? "law"
         : mark == Mark::area    ? "band"
         : mark == Mark::squares ? "measured"
                                 : "mean";
}

std::string table(const std::vector<Series>& list, const FigureContext& c) {
  std::string key = c.figure.against;
  std::ranges::replace(key, '.', '_');
  std::string text = results::csv_line({"series", "kind", results::column_name(key, c.x_unit),
                                        results::column_name(c.figure.quantity, c.y_unit),
                                        results::column_name("low", c.y_unit),
                                        results::column_name("high", c.y_unit)});
  for (const Series& s : list)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const Interval ends = interval_at(s, i, c.range);
      text += results::csv_line({results::csv_cell(std::string_view(plain_text(s.name))),
                                 std::string(kind_of(s.mark)), results::csv_cell(s.x[i]),
                                 results::csv_cell(s.y[i]), results::csv_cell(ends.low),
                                 results::csv_cell(ends.high)});
    }
  return text;
}

double largest(const std::vector<Series>& list) {
  double most = 0;
  for (const Series& s : list)
    for (const std::vector<double>* values : {&s.y, s.mark == Mark::area ? &s.high : &s.y})
      for (const double v : *values)
        if (std::isfinite(v)) most = std::max(most, std::abs(v));
  return most;
}

std::vector<Series> all_series(const FigureContext& c) {
  std::vector<Series> list =
      c.figure.band_over.empty()
          ? line_series(lines_along(c.campaign, c.figure.at, c.figure.against, c.figure.quantity),
                        c)
          : band_series(c);
  for (const MeasuredSeries& given : c.figure.measured) list.push_back(measured_series(given, c));
  return list;
}

/// Height of the plot: its axes with the rows of its legend.
double height_of(const Plot& plot) {
  const auto letters =
      static_cast<std::size_t>((plot.width - 54) / (letter_width * plot.font / 12));
  double height = 225;
  for (const Series& s : plot.series)
    height += (plot.font + 5) * static_cast<double>(wrapped(s.name, letters).size());
  return height;
}

}  // namespace

FigurePlot figure_plot(const PaperFigure& figure, const Campaign& campaign) {
  const auto key = std::ranges::find(campaign.keys, figure.against, &CampaignKey::key);
  const results::Range range = results::range_of(figure.quantity);
  FigureContext c{figure,
                  campaign,
                  key == campaign.keys.end() ? "" : key->unit,
                  unit_of(campaign, figure.quantity),
                  {},
                  {.label = "", .range_least = range.least, .range_most = range.most}};
  c.multiple = multiple(largest(all_series(c)), c.y_unit);
  std::vector<Series> list = all_series(c);  // again: laws name the multiple of the unit
  FigurePlot made{.plot = {.title = "",
                           .x = {key_axis(figure.against, c.x_unit)},
                           .y = {.label = quantity_axis(figure.quantity, c.multiple),
                                 .range_least = range.least / c.multiple.factor,
                                 .range_most = range.most / c.multiple.factor},
                           .series = {},
                           .width = column_width,
                           .font = figure_font},
                  .csv = table(list, c)};
  for (Series& s : list) {
    for (std::vector<double>* values : {&s.y, &s.error, &s.low, &s.high})
      for (double& v : *values) v /= c.multiple.factor;
    made.plot.series.push_back(std::move(s));
  }
  // Areas first, so that they cover nothing; then curves; points on top.
  std::ranges::stable_sort(made.plot.series, {}, [](const Series& s) {
    return s.mark == Mark::area ? 0 : s.mark == Mark::line ? 1 : s.mark == Mark::note ? 3 : 2;
  });
  made.plot.height = height_of(made.plot);
  return made;
}

}  // namespace mahlwerk::report
