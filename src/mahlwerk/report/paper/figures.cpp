// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Draws the figures of a paper from its campaigns.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "mahlwerk/report/campaign/sheet.hpp"
#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "mahlwerk/report/paper/trajectories.hpp"
#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/report/readable.hpp"

namespace mahlwerk::report {
namespace {

using Drawn = PaperFigure::Drawn;

/// Curve of a law in the colour of its points; `factor` is the multiple of the y axis.
Series curve(const FittedLaw& law, const ClaimLine& line, std::size_t colour, double factor) {
  Series drawn{.name = "", .mark = Mark::line, .colour = colour};
  constexpr int steps = 60;
  const auto [least, most] = std::ranges::minmax(line.points, {}, &LinePoint::x);
  for (int i = 0; i <= steps; ++i) {
    drawn.x.push_back(std::lerp(least.x, most.x, static_cast<double>(i) / steps));
    drawn.y.push_back(law.at(drawn.x.back()) / factor);
  }
  return drawn;
}

std::string plot(const PaperFigure& figure, const Campaign& campaign) {
  const std::vector<ClaimLine> lines =
      lines_along(campaign, figure.at, figure.against, figure.quantity);
  double most = 0;
  for (const ClaimLine& line : lines)
    for (const LinePoint& s : line.points)
      if (std::isfinite(s.value)) most = std::max(most, std::abs(s.value));
  const Multiple m = multiple(most, unit_of(campaign, figure.quantity));
  const auto key = std::ranges::find(campaign.keys, figure.against, &CampaignKey::key);
  const std::string unit = key == campaign.keys.end() ? "" : key->unit;
  Plot made{.title = fmt::format("Figure {}: {}", figure.number, figure.title),
            .x = {key_words(figure.against) + (unit.empty() ? "" : " (" + unit + ")")},
            .y = {m.unit == "1"     ? label(figure.quantity)
                  : m.unit == "1/s" ? "per second"
                                    : m.unit},
            .series = {},
            .height = 320};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Series points{
        .name = lines[i].others, .mark = figure.law ? Mark::dots : Mark::points, .colour = i};
    for (const LinePoint& s : lines[i].points) {
      points.x.push_back(s.x);
      points.y.push_back(s.value / m.factor);
      points.error.push_back(s.ci95 / m.factor);
    }
    const std::optional<FittedLaw> law =
        figure.law ? law_along(*figure.law, lines[i]) : std::nullopt;
    if (law) made.series.push_back(curve(*law, lines[i], i, m.factor));
    made.series.push_back(std::move(points));
  }
  return svg(made);
}

std::vector<Panel> panels(const PaperFigure& figure, const RunCampaign& run) {
  std::vector<Panel> list;
  for (const ClaimLine& line : lines_along(run.numbers, figure.at, "", ""))
    for (const LinePoint& s : line.points) {
      const auto i = static_cast<std::size_t>(s.point - run.numbers.points.data());
      std::string title = line.others;
      if (!s.point->regime.empty()) title += (title.empty() ? "" : ": ") + s.point->regime;
      if (i < run.outcomes.size()) list.push_back({title, &run.outcomes[i]});
    }
  return list;
}

std::string drawing(const PaperFigure& figure, const RunCampaign& run) {
  const View view = figure.seen_from_jar ? View::jar : View::carrier;
  switch (figure.drawn) {
    case Drawn::quantity:
      return plot(figure, run.numbers);
    case Drawn::trajectories:
      return trajectories_picture(panels(figure, run), view);
    case Drawn::snapshots:
      return snapshot_picture(panels(figure, run), view);
  }
  return "";
}

std::string file_of(const PaperFigure& figure, std::set<std::string>& used) {
  constexpr const char* kinds[]{"", "trajectories", "snapshots"};
  std::string name =
      "figure-" + figure.number + "-" +
      (figure.drawn == Drawn::quantity ? figure.quantity : kinds[static_cast<int>(figure.drawn)]);
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_'; }, '-');
  std::string file = name + ".svg";
  for (int i = 2; !used.insert(file).second; ++i) file = fmt::format("{}-{}.svg", name, i);
  return file;
}

}  // namespace

PaperResult paper_result(const Paper& paper, const std::map<std::string, RunCampaign>& run) {
  PaperResult result;
  result.paper = &paper;
  std::set<std::string> used;
  for (const PaperFigure& figure : paper.figures)
    result.pictures.push_back(
        {file_of(figure, used), drawing(figure, run.at(figure.campaign)), &figure});
  for (const Claim& claim : paper.claims)
    result.verdicts.push_back(
        judge(claim, run.at(claim.campaign).numbers, paper.measurement(claim.measured)));
  for (const auto& [name, campaign] : run) {
    result.seconds[name] = campaign.seconds;
    for (const results::Outcome& outcome : campaign.outcomes) {
      results::count(result.notices, outcome.notices);
      ++result.points;
    }
  }
  results::sort(result.notices);
  return result;
}

}  // namespace mahlwerk::report
