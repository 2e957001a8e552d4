// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Draws the figures of a paper from its campaigns. Sections of paper.toml with the same number are
// panels of one figure.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "mahlwerk/report/paper/claim_lines.hpp"
#include "mahlwerk/report/paper/figure_plot.hpp"
#include "mahlwerk/report/paper/measurements.hpp"
#include "mahlwerk/report/paper/page.hpp"
#include "mahlwerk/report/paper/representatives.hpp"
#include "mahlwerk/report/paper/tables.hpp"
#include "mahlwerk/report/paper/trajectories.hpp"
#include "mahlwerk/report/plot/figure_sheet.hpp"

namespace mahlwerk::report {
namespace {

using Drawn = PaperFigure::Drawn;

/// A number of the paper, "7b, c": its stem "7" and its letters.
struct FigureNumber {
  std::string stem;
  std::vector<std::string> letters;
};

FigureNumber parsed(const std::string& number) {
  const std::size_t digit = number.find_last_of("0123456789");
  FigureNumber made{number, {}};
  if (digit == std::string::npos) return made;
  for (std::size_t i = digit + 1; i < number.size(); ++i) {
    if (std::isalpha(static_cast<unsigned char>(number[i])) == 0) continue;
    const bool word =
        i + 1 < number.size() && std::isalpha(static_cast<unsigned char>(number[i + 1])) != 0;
    if (word) return {number, {}};
    made.letters.emplace_back(1, number[i]);
  }
  made.stem = number.substr(0, digit + 1);
  return made;
}

/// A drawing of a panel and its numbers.
struct DrawnPanel {
  FigurePanel panel;
  std::string csv;
};

/// What one section draws: a panel for each point, or several if its replicates are in several
/// states of motion.
struct DrawnSection {
  const PaperFigure* figure = nullptr;
  std::vector<std::string> letters;  // that the paper's number gives
  std::vector<std::vector<DrawnPanel>> points;
  Plot plot = {};  // of a quantity
};

FigurePanel picture_of(const PaperFigure& figure, const results::Outcome& outcome,
                       const Representative& shown, double size) {
  constexpr double margin = 8;
  const View view = figure.seen_from_jar ? View::jar : View::carrier;
  FigurePanel panel{.letter = "",
                    .title = "",
                    .svg = "",
                    .width = size,
                    .height = size - margin + scale_bar_height};
  panel.svg = figure.drawn == Drawn::trajectories
                  ? trajectories_picture(outcome, shown.replicate, view, size - margin)
                  : snapshot_picture(outcome, shown.replicate, view, size - margin);
  return panel;
}

std::string numbers_of(const PaperFigure& figure, const results::Outcome& outcome,
                       std::size_t replicate) {
  const View view = figure.seen_from_jar ? View::jar : View::carrier;
  return figure.drawn == Drawn::trajectories ? trajectories_csv(outcome, replicate, view)
                                             : snapshot_csv(outcome, replicate, view);
}

/// Width of each of several square panels [px]: up to four in a row.
double size_of(std::size_t panels) {
  return panels <= 3 ? page_width / 3 : page_width / 4;
}

DrawnSection pictures(const PaperFigure& figure, const RunCampaign& run) {
  struct Shown {
    std::string title;
    const results::Outcome* outcome;
    std::vector<Representative> replicates;
  };
  std::vector<Shown> all;
  std::size_t panels = 0;
  for (const ClaimLine& line : lines_along(run.numbers, figure.at, "", ""))
    for (const LinePoint& s : line.points) {
      const auto i = static_cast<std::size_t>(s.point - run.numbers.points.data());
      if (i >= run.outcomes.size()) continue;
      const std::vector<results::Replicate>& replicates = run.outcomes[i].replicates;
      if (std::ranges::all_of(replicates, [](const auto& r) { return r.replay.empty(); })) continue;
      all.push_back({line.others, &run.outcomes[i], representatives(run.outcomes[i])});
      panels += all.back().replicates.size();
    }
  DrawnSection section{.figure = &figure, .letters = {}, .points = {}};
  for (const Shown& shown : all) {
    std::vector<DrawnPanel>& point = section.points.emplace_back();
    for (const Representative& one : shown.replicates) {
      FigurePanel panel = picture_of(figure, *shown.outcome, one, size_of(panels));
      const std::string words = panel.svg.empty() ? one.words + " (it has no frames)" : one.words;
      panel.title = shown.title + (shown.title.empty() || words.empty() ? "" : ": ") + words;
      point.push_back({std::move(panel), numbers_of(figure, *shown.outcome, one.replicate)});
    }
  }
  return section;
}

DrawnSection drawn(const PaperFigure& figure, const Paper& paper, const RunCampaign& run) {
  if (figure.drawn != Drawn::quantity) return pictures(figure, run);
  FigurePlot made = figure_plot(with_measured(figure, paper, run.numbers), run.numbers);
  DrawnSection section{.figure = &figure, .letters = {}, .points = {}};
  FigurePanel panel{.letter = "",
                    .title = figure.title,
                    .svg = "",
                    .width = made.plot.width,
                    .height = made.plot.height};
  section.plot = std::move(made.plot);
  section.points.push_back({{std::move(panel), std::move(made.csv)}});
  return section;
}

/// The i-th letter of the alphabet; after z: aa, ab.
std::string letter(std::size_t i) {
  constexpr std::size_t letters = 26;
  const std::string last(1, static_cast<char>('a' + i % letters));
  return i < letters ? last : letter(i / letters - 1) + last;
}

/// Gives the panels letters: those of the paper's number, else the next ones in alphabetical order.
/// Panels of one point have its letter and a number. A single panel without a letter of the paper
/// has none.
void give_letters(std::vector<DrawnSection>& sections) {
  std::set<std::string> used;
  std::size_t panels = 0, next = 0;
  for (const DrawnSection& section : sections) {
    used.insert(section.letters.begin(), section.letters.end());
    for (const auto& point : section.points) panels += point.size();
  }
  if (panels == 1 && used.empty()) return;
  for (DrawnSection& section : sections)
    for (std::size_t i = 0; i < section.points.size(); ++i) {
      std::string own;
      if (section.letters.size() == section.points.size())
        own = section.letters[i];
      else if (!section.letters.empty())
        own = section.letters.front() + std::to_string(i + 1);
      while (own.empty() && used.contains(letter(next))) ++next;
      if (own.empty()) own = letter(next++);
      std::vector<DrawnPanel>& point = section.points[i];
      for (std::size_t k = 0; k < point.size(); ++k)
        point[k].panel.letter =
            point.size() == 1 ? own : fmt::format("{}{}{}", own, own.size() > 1 ? "-" : "", k + 1);
    }
}

std::string ending_in_stop(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

/// "a: title of its section. b, c: ..." with the texts below the figure, each once.
std::string caption_of(const std::vector<DrawnSection>& sections) {
  std::string caption;
  std::set<std::string> said;
  for (const DrawnSection& section : sections) {
    std::string letters;
    for (const auto& point : section.points)
      for (const DrawnPanel& one : point)
        letters += (letters.empty() ? "" : ", ") + one.panel.letter;
    caption += fmt::format("{}{}{}{}", caption.empty() ? "" : " ", letters,
                           letters.empty() ? "" : ": ", ending_in_stop(section.figure->title));
  }
  if (std::ranges::any_of(sections, [](const DrawnSection& s) {
        return s.figure->drawn == Drawn::trajectories && !s.points.empty();
      }))
    caption +=
        " Trajectories are those of the centres of the balls, each in its colour; discs are the "
        "balls "
        "at the end, the circle is the wall of the jar.";
  for (const DrawnSection& section : sections)
    if (const std::string about = ending_in_stop(section.figure->about);
        !about.empty() && said.insert(about).second)
      caption += " " + about;
  return caption;
}

/// Draws the plots of a figure with the same height, so that the axes of a row are aligned.
void draw_plots(std::vector<DrawnSection>& sections) {
  double height = 0;
  const auto is_plot = [](const DrawnSection& s) { return s.figure->drawn == Drawn::quantity; };
  for (const DrawnSection& section : sections)
    if (is_plot(section)) height = std::max(height, section.plot.height);
  for (DrawnSection& section : sections)
    if (is_plot(section)) {
      FigurePanel& panel = section.points.front().front().panel;
      panel.height = section.plot.height = height;
      panel.svg = svg(section.plot);
    }
}

std::string file_of(const std::string& stem, std::set<std::string>& used) {
  std::string name = "figure-" + stem;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_'; }, '-');
  std::string file = name;
  for (int i = 2; !used.insert(file).second; ++i) file = fmt::format("{}-{}", name, i);
  return file;
}

PaperPicture picture(const std::string& stem, std::vector<DrawnSection> sections,
                     std::set<std::string>& used) {
  draw_plots(sections);
  give_letters(sections);
  PaperPicture made{.file = file_of(stem, used),
                    .number = stem,
                    .svg = "",
                    .caption = caption_of(sections),
                    .tables = {}};
  std::vector<FigureBlock> blocks;
  for (DrawnSection& section : sections) {
    FigureBlock block;
    if (section.figure->drawn != Drawn::quantity && !section.points.empty())
      block.title = section.figure->title;
    for (auto& point : section.points)
      for (DrawnPanel& one : point) {
        made.tables[fmt::format("{}{}.csv", made.file, one.panel.letter)] = std::move(one.csv);
        block.panels.push_back(std::move(one.panel));
      }
    if (!block.panels.empty()) blocks.push_back(std::move(block));
  }
  if (!blocks.empty()) made.svg = figure_svg(fmt::format("Figure {}", stem), blocks);
  return made;
}

}  // namespace

PaperResult paper_result(const Paper& paper, const std::map<std::string, RunCampaign>& run) {
  PaperResult result;
  result.paper = &paper;
  std::vector<std::pair<std::string, std::vector<DrawnSection>>> figures;
  for (const PaperFigure& figure : paper.figures) {
    const FigureNumber number = parsed(figure.number);
    auto at = std::ranges::find_if(figures, [&](const auto& f) { return f.first == number.stem; });
    if (at == figures.end()) at = figures.insert(figures.end(), {number.stem, {}});
    at->second.push_back(drawn(figure, paper, run.at(figure.campaign)));
    at->second.back().letters = number.letters;
  }
  std::set<std::string> used;
  for (auto& [stem, sections] : figures)
    result.pictures.push_back(picture(stem, std::move(sections), used));
  for (const PaperTable& table : paper.tables)
    result.tables.push_back(made_table(table, run.at(table.campaign)));
  for (const Claim& claim : paper.claims) {
    const RunCampaign& campaign = run.at(claim.campaign);
    result.verdicts.push_back(
        claim.kind == Claim::Kind::capture_bounds
            ? judge_capture_bounds(claim, campaign)
            : judge(claim, campaign.numbers, paper.measurement(claim.measured)));
  }
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
