// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/notices.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

using MatchRow = std::array<std::string, 4>;  // label, A, B, B/A

/// "1.02 (0.97 to 1.07)"
std::string ratio_text(const observe::IntervalEstimate& ratio) {
  if (!std::isfinite(ratio.value)) return "-";
  if (!std::isfinite(ratio.low)) return fmt::format("{:.3g}", ratio.value);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", ratio.value, ratio.low, ratio.high);
}

std::vector<MatchRow> match_rows(const MatchResult& found) {
  const auto text = [](const observe::Estimate& t, const char* unit, double size) {
    return readable(t.mean, t.ci95, unit, size).text();
  };
  const campaign::Difference& d = found.difference;
  const double dose = std::fmax(d.dose_a.mean, d.dose_b.mean);
  const double energy = std::fmax(d.energy_a.mean, d.energy_b.mean);
  const char* unit = found.by_powder ? "W/kg" : "W";
  return {{found.by_powder ? "dose rate" : "dissipated power", text(d.dose_a, unit, dose),
           text(d.dose_b, unit, dose), ratio_text(d.dose)},
          {"mean energy lost per collision", text(d.energy_a, "J", energy),
           text(d.energy_b, "J", energy), fmt::format("{:.3g}", d.energy_b.mean / d.energy_a.mean)},
          {"energy below which half of the power lies", "", "", ratio_text(d.half_power)},
          {"overlap of the power spectra", "", "", fmt::format("{:.0f} %", 100 * d.overlap)},
          {"distance of the means", "", "", fmt::format("{:.3g}", d.distance)}};
}

/// Explains the two distances of the report, which differ.
std::string about_distances(const MatchResult& found) {
  const Trial& best = found.search.trials[*found.search.best];
  return fmt::format(
      "A distance is the root of the sum of squares of the difference in the logarithm of {0} and "
      "the difference of the spectra: 0 for equal mills, 0.1 for 10 % of {0}. The distance of the "
      "means is that of all replicates of B, run again, from all of A. The search compares single "
      "replicates of B with the mean of A; their scatter increases their distance, to {1} at the "
      "best setting",
      found.by_powder ? "dose" : "power",
      readable(best.model.mean, best.model.ci95, found.search.outcome.unit).text());
}

bool about_one(double ratio) {
  constexpr double alike = 0.1;
  return std::abs(ratio - 1) < alike;
}

/// "0.6 times as much as", or "about as much as".
std::string times(double ratio, std::string_view word) {
  return about_one(ratio) ? fmt::format("about as {} as", word)
                          : fmt::format("{:.2g} times as {} as", ratio, word);
}

/// What a user changes on mill B, and what the hits do then.
std::vector<std::string> in_words(const MatchResult& found) {
  const campaign::Difference& d = found.difference;
  std::string settings;
  for (const KeyOptimum& k : found.search.keys)
    settings += fmt::format("{}{} = {}", settings.empty() ? "" : ", ", k.key, k.text.best);
  std::vector<std::string> all{fmt::format(
      "Set B to {}: {} is then {} in A", settings,
      found.by_powder ? "the energy per time and mass of powder" : "the dissipated power",
      times(d.dose.value, "large"))};
  const double energy = d.energy_b.mean / d.energy_a.mean;
  if (!std::isfinite(energy) || !(energy > 0)) return all;
  const double count = d.dose_b.mean / d.dose_a.mean / energy;  // by mass of powder, or in all
  all.push_back(fmt::format(
      "A collision of B loses {} one of A on average, and B has {} A{}", times(energy, "much"),
      about_one(count) ? "about as many collisions as"
                       : fmt::format("{:.2g} times as many collisions as", count),
      found.by_powder ? ", by mass of powder" : ""));
  return all;
}

/// What these keys cannot match; nothing where the spectra are alike.
std::vector<std::string> not_matched(const MatchResult& found) {
  constexpr double alike = 0.9;
  const campaign::Difference& d = found.difference;
  std::vector<std::string> all;
  if (d.within_scatter()) return all;
  if (!about_one(d.dose.value) && !(d.dose.low < 1 && d.dose.high > 1))
    all.push_back(fmt::format("The {} cannot be matched with these keys in their ranges",
                              found.by_powder ? "dose rate" : "power"));
  if (!(d.overlap < alike)) return all;
  const bool harder = d.half_power.value > 1;
  all.push_back(fmt::format(
      "What these keys do not match in their ranges: {:.0f} % of the power of B lies in hits of "
      "energies "
      "that "
      "A has less of. B's hits are {}: half of its power lies below {:.2g} times the energy that "
      "halves the power of A. {} balls would change that",
      100 * (1 - d.overlap),
      about_one(d.half_power.value) ? "spread otherwise"
      : harder                      ? "harder"
                                    : "softer",
      d.half_power.value, harder ? "Smaller or lighter" : "Larger or heavier"));
  return all;
}

}  // namespace

std::vector<std::string> sentences(const MatchResult& found) {
  std::vector<std::string> all;
  if (!found.search.best) return sentences(found.search);
  for (std::string& one : in_words(found)) all.push_back(std::move(one));
  for (std::string& one : not_matched(found)) all.push_back(std::move(one));
  if (!std::isfinite(found.difference.p_value))
    all.emplace_back("With fewer than two replicates of each mill their scatter is unknown");
  else if (found.difference.within_scatter())
    all.push_back(
        fmt::format("The two mills cannot be distinguished: with randomly permuted labels their "
                    "replicates differ as much in {:.0f} of 100 permutations",
                    100 * found.difference.p_value));
  else
    all.push_back(
        fmt::format("The two mills still differ by more than their scatter: with randomly permuted "
                    "labels their replicates differ as much in {:.1f} of 100 permutations",
                    100 * found.difference.p_value));
  for (std::string& sentence : validity_sentences(found.search)) all.push_back(std::move(sentence));
  for (const KeyOptimum& k : found.search.keys)
    if (k.at_low_end || k.at_high_end)
      all.push_back(fmt::format(
          "{} could not be matched within its range: the best value lies at its {} end, {}", k.key,
          k.at_low_end ? "lower" : "upper", k.at_low_end ? k.text.from : k.text.to));
  for (const KeyOptimum& k : found.search.keys)
    if (k.flat)
      all.push_back(fmt::format("{} hardly matters: any value from {} to {} is equally good", k.key,
                                k.text.good_low, k.text.good_high));
  if (found.search.failed > 0)
    all.push_back(fmt::format("{} of {} settings could not be run", found.search.failed,
                              found.search.trials.size()));
  return all;
}

std::string match_table(const MatchResult& found) {
  std::string text;
  if (found.search.best) {
    for (const KeyOptimum& k : found.search.keys)
      text += fmt::format("{} = {}   ({})\n", k.key, k.text.best, k.range_text());
    text += '\n';
    std::vector<MatchRow> lines = match_rows(found);
    lines.insert(lines.begin(), MatchRow{"", "A", "B as found", "B/A"});
    text += aligned(lines);
    text += '\n';
  }
  for (const std::string& sentence : sentences(found)) text += sentence + ".\n";
  if (found.search.best) text += chance_sentence(found.search) + ".\n";
  const std::string warned = notice_lines(found.notices, 2, "mill");
  return text + fmt::format("{} settings tried, {} runs.\n{}{}", found.search.trials.size(),
                            found.search.runs(), warned.empty() ? "" : "\n", warned);
}

Plot match_plot(const MatchResult& found) {
  const std::vector<double>&shares_a = found.a.mean.shares, &shares_b = found.b.mean.shares;
  const auto edge = [](std::size_t bin) {
    return observe::LogHistogram::lower(static_cast<int>(bin));
  };
  std::size_t first = shares_a.size(), last = 0;
  for (std::size_t i = 0; i < shares_a.size(); ++i)
    if (shares_a[i] > 1e-4 || shares_b[i] > 1e-4) {
      first = std::min(first, i);
      last = i + 1;
    }
  Series a{.name = "A", .mark = Mark::steps}, b{.name = "B as found", .mark = Mark::steps};
  const Multiple across = multiple(last > first ? edge(last) : 1, "J");
  for (std::size_t i = first; i < last; ++i) {
    a.y.push_back(100 * shares_a[i]);
    b.y.push_back(100 * shares_b[i]);
  }
  for (std::size_t i = first; i <= last && last > first; ++i) {
    a.x.push_back(edge(i) / across.factor);
    b.x.push_back(edge(i) / across.factor);
  }
  return {.title = "Power by energy lost per collision",
          .x = Axis{fmt::format("energy lost per collision ({})", across.unit), true},
          .y = Axis{"share of the power per bin (%)"},
          .series = {a, b}};
}

std::string match_page(const MatchResult& found, std::string_view version) {
  std::string extra;
  if (found.search.best) {
    std::string lines;
    for (const MatchRow& r : match_rows(found))
      lines += fmt::format(
          "<tr><th scope=\"row\">{}</th><td class=\"n\" data-head=\"A\">{}</td><td class=\"n\" "
          "data-head=\"B as found\">{}</td><td class=\"n\" data-head=\"B / A\">{}</td></tr>\n",
          escaped(r[0]), escaped(r[1]), escaped(r[2]), escaped(r[3]));
    extra = fmt::format(
        "<h2>The two mills</h2>\n<div class=\"wide\"><table class=\"stacked\">\n"
        "<thead><tr><th></th><th class=\"n\">A</th><th class=\"n\">B as found</th><th "
        "class=\"n\">B / "
        "A</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n"
        "<p><small>A: {} ({}). B: {} ({}), run again at the best setting. {}.</small></p>"
        "\n",
        lines, escaped(found.title_a), escaped(found.file_a), escaped(found.title_b),
        escaped(found.file_b), escaped(about_distances(found)));
    std::string points;
    for (const std::string& sentence : sentences(found))
      points += fmt::format("<p>{}.</p>\n", escaped(sentence));
    extra +=
        fmt::format("<section class=\"box\"><h2>Do the mills agree?</h2>\n{}</section>\n", points);
    extra += notice_boxes(found.notices, 2, "mill");
    extra += figure(match_plot(found),
                    "Power of collisions by energy. The similarity of the two spectra matters as "
                    "much as the total power.");
  }
  return optimum_page(found.search, version, extra);
}

}  // namespace mahlwerk::report
