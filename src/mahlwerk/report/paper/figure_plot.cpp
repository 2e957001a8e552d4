// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/figure_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// A series of the plot and its name in the CSV file.
struct FigureSeries {
  Series series;
  std::string name = {};
};

/// The law of a line; nothing if the figure has none or there are too few points.
std::optional<FigureSeries> law_series(const ClaimLine& line, const FigureContext& c) {
  const auto law = c.figure.law ? law_along(*c.figure.law, line) : std::nullopt;
  if (!law) return std::nullopt;
  FigureSeries made{curve(*law, line)};
  made.series.name = (line.others.empty() ? "" : line.others + ": ") +
                     law_words(*law, {.x = symbol_of_key(c.figure.against),
                                      .x_unit = c.x_unit,
                                      .y = symbol_of_quantity(c.figure.quantity),
                                      .multiple = c.multiple});
  made.name = plain_text(made.series.name);
  return made;
}

/// Points and laws of each line. In a figure of several lines the curves name them, and a note
/// explains the points.
std::vector<FigureSeries> line_series(const std::vector<ClaimLine>& lines, const FigureContext& c) {
  std::vector<FigureSeries> list;
  const bool alone = lines.size() == 1 && lines.front().others.empty();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::optional<FigureSeries> law = law_series(lines[i], c);
    FigureSeries points{points_of(lines[i].points, c), lines[i].others};
    points.series.name = alone ? points_words(lines, c) : law ? "" : lines[i].others;
    points.series.mark = c.figure.law ? Mark::dots : Mark::points;
    points.series.colour = i;
    if (law) law->series.colour = i;
    if (law) list.push_back(std::move(*law));
    list.push_back(std::move(points));
  }
  if (!alone && !lines.empty())
    list.push_back({{.name = "points: " + points_words(lines, c), .mark = Mark::note}});
  return list;
}

std::string keys_words(const std::vector<std::string>& keys) {
  std::string words;
  for (const std::string& key : keys) {
    const std::string symbol = symbol_of_key(key);
    words += (words.empty() ? "" : ", ") + (symbol.empty() ? key_words(key) : symbol);
  }
  return words;
}

/// The band over free numbers of each line and, if the figure names them, their nominal values.
std::vector<FigureSeries> band_series(const FigureContext& c) {
  std::vector<FigureSeries> list;
  std::vector<ClaimLine> nominal;
  const std::vector<BandLine> bands = bands_along(c.figure, c.campaign);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    FigureSeries area{
        {.name = fmt::format("{}{}all values of {}, with 95 % intervals", bands[i].others,
                             bands[i].others.empty() ? "" : ": ", keys_words(c.figure.band_over)),
         .mark = Mark::area,
         .colour = i}};
    area.name = plain_text(area.series.name);
    for (const BandPoint& b : bands[i].points) {
      area.series.x.push_back(b.x);
      area.series.y.push_back(NAN);
      area.series.low.push_back(std::clamp(b.low, c.range.range_least, c.range.range_most));
      area.series.high.push_back(std::clamp(b.high, c.range.range_least, c.range.range_most));
    }
    list.push_back(std::move(area));
    if (!bands[i].nominal.empty()) nominal.push_back({bands[i].others, bands[i].nominal});
  }
  for (FigureSeries& points : line_series(nominal, c)) list.push_back(std::move(points));
  return list;
}

FigureSeries measured_series(const MeasuredSeries& given, const FigureContext& c) {
  FigureSeries made{{.name = given.name, .x = given.x, .y = given.y, .mark = Mark::squares},
                    given.name};
  for (std::size_t i = 0; i < given.y.size(); ++i) {
    const bool bars = i < given.error_low.size() && i < given.error_high.size();
    made.series.low.push_back(bars ? std::max(given.y[i] - given.error_low[i], c.range.range_least)
                                   : NAN);
    made.series.high.push_back(bars ? std::min(given.y[i] + given.error_high[i], c.range.range_most)
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

std::string table(const std::vector<FigureSeries>& list, const FigureContext& c) {
  std::string key = c.figure.against;
  std::ranges::replace(key, '.', '_');
  std::string text = results::csv_line({"series", "kind", results::column_name(key, c.x_unit),
                                        results::column_name(c.figure.quantity, c.y_unit),
                                        results::column_name("low", c.y_unit),
                                        results::column_name("high", c.y_unit)});
  for (const auto& [s, name] : list)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const Interval ends = interval_at(s, i, c.range);
      text += results::csv_line({results::csv_cell(std::string_view(name)),
                                 std::string(kind_of(s.mark)), results::csv_cell(s.x[i]),
                                 results::csv_cell(s.y[i]), results::csv_cell(ends.low),
                                 results::csv_cell(ends.high)});
    }
  return text;
}

double largest(const std::vector<FigureSeries>& list) {
  double most = 0;
  for (const auto& [s, name] : list)
    for (const std::vector<double>* values : {&s.y, s.mark == Mark::area ? &s.high : &s.y})
      for (const double v : *values)
        if (std::isfinite(v)) most = std::max(most, std::abs(v));
  return most;
}

std::vector<FigureSeries> all_series(const FigureContext& c) {
  std::vector<FigureSeries> list =
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
  std::vector<FigureSeries> list = all_series(c);  // again: laws name the multiple of the unit
  FigurePlot made{.plot = Plot{.title = "",
                               .x = Axis{key_axis(figure.against, c.x_unit)},
                               .y = Axis{.label = quantity_axis(figure.quantity, c.multiple),
                                         .range_least = range.least / c.multiple.factor,
                                         .range_most = range.most / c.multiple.factor},
                               .series = {},
                               .width = column_width,
                               .font = figure_font},
                  .csv = table(list, c)};
  for (auto& [s, name] : list) {
    for (std::vector<double>* values : {&s.y, &s.error, &s.low, &s.high})
      for (double& v : *values) v /= c.multiple.factor;
    made.plot.series.push_back(std::move(s));
  }
  // Areas are below all lines; notes end the legend.
  std::ranges::stable_sort(made.plot.series, {}, [](const Series& s) {
    return s.mark == Mark::area ? 0 : s.mark == Mark::note ? 2 : 1;
  });
  made.plot.height = height_of(made.plot);
  return made;
}

}  // namespace mahlwerk::report
