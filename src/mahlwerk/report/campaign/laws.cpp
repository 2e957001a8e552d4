// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/report/campaign/plots.hpp"

namespace mahlwerk::report {
namespace {

/// Unit of a coefficient: "µm/rpm²" from "µm", "rpm" and power 2.
std::string per(const std::string& unit, const std::string& x_unit, int power) {
  if (power == 0 || x_unit.empty()) return unit;
  const bool composed = x_unit.find_first_of("/ ") != std::string::npos;
  return fmt::format("{}/{}{}", unit, composed ? "(" + x_unit + ")" : x_unit,
                     power == 2 ? "²" : "");
}

/// A value with half-width and unit; scientific notation below 1e-3 and from 1e6 on.
std::string number(double value, double ci95, const std::string& unit) {
  const double size = std::max(std::abs(value), std::isfinite(ci95) ? ci95 : 0.0);
  const bool plain = size == 0 || (size >= 1e-3 && size < 1e6);
  const double scale = plain ? 1 : std::pow(10, std::floor(std::log10(size)));
  std::string text = readable(value / scale, ci95 / scale, "").number;
  if (!plain)
    text = fmt::format("{} × {}", std::isfinite(ci95) ? "(" + text + ")" : text,
                       tick_text(scale, true));
  return unit.empty() ? text : text + " " + unit;
}

std::string four_digits(double value) {
  return fmt::format("{:.4g}", value);
}

struct Units {
  std::string x, y;
};

std::string formula(const FittedLaw& law, const Units& units) {
  switch (law.form) {
    case LawForm::power:
      return fmt::format("c (x / {}{})<sup>p</sup>", four_digits(law.reference),
                         units.x.empty() ? "" : fmt::format(" {}", escaped(units.x)));
    case LawForm::parabola:
      return "a + b x + c x²";
    case LawForm::line:
      break;
  }
  return "a + b x";
}

std::string coefficients(const FittedLaw& law, const Units& units) {
  std::string text;
  for (std::size_t i = 0; i < law.coefficients.size(); ++i) {
    const bool exponent = law.form == LawForm::power && i == 1;
    const std::string unit =
        exponent ? "" : per(units.y, units.x, law.form == LawForm::power ? 0 : static_cast<int>(i));
    const char name = law.form == LawForm::power ? "cp"[i] : "abc"[i];
    text += fmt::format("{}{} = {}", i == 0 ? "" : "<br/>", name,
                        escaped(number(law.coefficients[i], law.ci95[i], unit)));
  }
  return text;
}

std::string row(const std::string& line, const std::string& name, const FittedLaw& law,
                const Units& units) {
  return fmt::format(
      "{}<td>{}<br/><small>{}</small></td><td>{}</td><td class=\"n\">{:.4f}</td></tr>\n",
      line.empty() ? "" : "<td>" + escaped(line) + "</td>", name, formula(law, units),
      coefficients(law, units), law.r_squared);
}

/// "a power law or a straight line".
std::string named(const std::vector<FittedLaw>& laws, const std::vector<std::size_t>& which,
                  std::string_view with) {
  std::string text;
  for (const std::size_t i : which)
    text += fmt::format("{}a {}", text.empty() ? "" : with, name_of(laws[i].form));
  return text;
}

/// The result of the model selection: "A power law fits best."
std::string verdict(const std::vector<FittedLaw>& laws, const LawSelection& choice,
                    const Units& units) {
  const FittedLaw& best = laws[choice.best];
  std::string text;
  if (!choice.by_aicc)
    text = fmt::format("Too few points to distinguish the laws; a {} fits best (adjusted R²).",
                       name_of(best.form));
  else if (choice.equivalent.empty())
    text = fmt::format("A {} fits best.", name_of(best.form));
  else
    text = fmt::format(
        "A {} fits best, but {} cannot be distinguished from it (AICc differs by less than 2).",
        name_of(best.form), named(laws, choice.equivalent, " and "));
  constexpr double poor = 0.5;
  if (best.r_squared < poor) text += " No law fits well.";
  std::vector<std::size_t> good = choice.equivalent;
  good.push_back(choice.best);
  for (const std::size_t i : good)
    if (through_origin(laws[i]) && std::abs(laws[i].coefficients[1]) > laws[i].ci95[1])
      text += fmt::format(
          " The line's intercept, {}, does not differ from 0: it may pass through the origin.",
          number(laws[i].coefficients[0], laws[i].ci95[0], units.y));
  return text;
}

/// Rows of the laws of a single line: the best one, or all others.
std::string rows_of(const std::vector<FittedLaw>& laws, const LawSelection& choice,
                    const Units& units, bool best) {
  std::string rows;
  for (std::size_t k = 0; k < laws.size(); ++k)
    if ((k == choice.best) == best)
      rows += (best ? "<tr class=\"best\">" : "<tr>") +
              row("", std::string(name_of(laws[k].form)), laws[k], units);
  return rows;
}

/// The table of the rows with its head; empty without rows.
std::string table_of(const std::string& rows, bool several) {
  if (rows.empty()) return "";
  return fmt::format(
      "<table class=\"laws\"><thead><tr>{}<th>coefficients</th><th "
      "class=\"n\">R²</th></tr></thead>\n"
      "<tbody>\n{}</tbody></table>\n",
      several ? "<th>line</th><th>best law</th>" : "<th>law</th>", rows);
}

/// A collapsed section (HTML <details>), so that no table is longer than its plot.
std::string unfolding(std::string_view head, const std::string& table) {
  if (table.empty()) return "";
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", head, table);
}

/// The row of one line among several: its best law and equivalent laws.
std::string row_of(const std::string& line, const std::vector<FittedLaw>& laws,
                   const LawSelection& choice, const Units& units) {
  std::string name(name_of(laws[choice.best].form));
  if (!choice.by_aicc) name += ", too few points";
  if (!choice.equivalent.empty()) name += " (or " + named(laws, choice.equivalent, ", ") + ")";
  return "<tr>" + row(line.empty() ? "-" : line, name, laws[choice.best], units);
}

/// The law over the range of the line's points, dashed, in the line's colour.
Series curve_of(const FittedLaw& law, const Series& line, std::size_t number, bool logarithmic) {
  constexpr int pieces = 60;
  constexpr std::size_t dashed = 7;  // index offset of the dashed version of a colour
  const auto [least, most] = std::ranges::minmax_element(line.x);
  Series curve{.name = "", .mark = Mark::line, .colour = number % dashed + dashed};
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    curve.x.push_back(logarithmic ? *least * std::pow(*most / *least, share)
                                  : *least + share * (*most - *least));
    curve.y.push_back(law.at(curve.x.back()));
  }
  return curve;
}

}  // namespace

FittedLines laws_of_lines(const Sheet& sheet, std::size_t axis, std::size_t column,
                          const std::vector<Series>& lines) {
  constexpr std::size_t most = 5;  // lines; the table of more would be too long
  FittedLines made;
  if (lines.size() > most) return made;
  const Multiple& m = sheet.multiples[column];
  const Units units{sheet.campaign.keys[axis].unit, m.unit == "1"     ? ""
                                                    : m.unit == "1/s" ? "/s"
                                                                      : m.unit};
  const bool several = lines.size() > 1;
  std::string rows, others, words;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<FittedLaw> laws = fitted_laws(lines[i].x, lines[i].y, lines[i].error);
    if (laws.empty()) continue;
    const LawSelection choice = select_law(laws);
    made.curves.push_back(curve_of(laws[choice.best], lines[i], i, over_decades(lines[i].x)));
    rows +=
        several ? row_of(lines[i].name, laws, choice, units) : rows_of(laws, choice, units, true);
    if (!several) others = rows_of(laws, choice, units, false);
    if (!several) words = escaped(verdict(laws, choice, units)) + " ";
    if (several && !choice.by_aicc)
      words = "Too few points to distinguish the laws: the best by adjusted R² is given. ";
  }
  if (rows.empty()) return made;
  const std::string table = table_of(rows, several);
  made.table = fmt::format(
      "<p>{}<small>Dashed: the best law; x is {}, ± is the 95 % half-width.</small></p>\n{}{}",
      words, escaped(axis_label(sheet.campaign.keys[axis])),
      several ? unfolding("The law of each line", table) : table,
      unfolding("The other laws", table_of(others, several)));
  return made;
}

}  // namespace mahlwerk::report
