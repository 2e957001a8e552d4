// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A comparison as text for the terminal and as page.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/report/compare.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

/// A row: both values in the same multiple of the unit, the ratio, and "≠" if they differ.
using CompareLine = std::array<std::string, 5>;
CompareLine line_of(std::string title, const EnginePair& b, std::string_view unit,
                    results::Range range = {}) {
  const double size = std::fmax(std::abs(b.event.mean), std::abs(b.soft.mean));
  const double ratio = b.ratio();
  return {std::move(title), readable_within(b.event.mean, b.event.ci95, unit, range, size).text(),
          readable_within(b.soft.mean, b.soft.ci95, unit, range, size).text(),
          std::isfinite(ratio) ? readable(ratio, b.ratio_ci95(), "").text() : "-",
          b.differs() ? "≠" : ""};
}

std::string bin_text(const ComparedBin& b, std::string_view unit) {
  const Multiple m = multiple(b.high, unit);
  if (b.low == 0) return fmt::format("below {:.3g} {}", b.high / m.factor, m.unit);
  return fmt::format("{:.3g} to {:.3g} {}", b.low / m.factor, b.high / m.factor, m.unit);
}

std::vector<CompareLine> lines_of(const std::vector<ComparedBin>& bins, std::string_view unit) {
  std::vector<CompareLine> lines;
  for (auto b = bins.rbegin(); b != bins.rend(); ++b)  // highest bin first
    lines.push_back(line_of(bin_text(*b, unit), b->rate, "1/s", results::not_negative));
  return lines;
}

/// Aligned text table; numbers are right-aligned.
std::string aligned_lines(std::vector<CompareLine> lines, const char* title) {
  lines.insert(lines.begin(), {title, "event", "soft", "soft/event", ""});
  std::array<std::size_t, 5> widths{};
  for (const CompareLine& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const CompareLine& line : lines) {
    std::string row = line[0] + std::string(widths[0] - width(line[0]), ' ');
    for (std::size_t i = 1; i < line.size(); ++i) {
      const std::string room(widths[i] - width(line[i]), ' ');
      row += "  " + (i == 4 ? line[i] : room + line[i]);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  return text + '\n';
}

std::string html_rows(const std::vector<CompareLine>& lines,
                      const std::vector<std::string>& abouts) {
  std::string rows;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const CompareLine& l = lines[i];
    const std::string about = i < abouts.size() && !abouts[i].empty()
                                  ? "<small>" + with_symbols(abouts[i]) + "</small>"
                                  : "";
    rows += fmt::format("<tr><th scope=\"row\">{}{}</th>", escaped(l[0]), about);
    for (std::size_t k = 1; k < l.size(); ++k)
      rows += fmt::format("<td class=\"n\">{}</td>", escaped(l[k]));
    rows += "</tr>\n";
  }
  return rows;
}

std::string html_table(std::string_view title, const std::vector<CompareLine>& lines,
                       const std::vector<std::string>& abouts = {}) {
  return fmt::format(
      "<h2>{}</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th><th class=\"n\">event</th><th "
      "class=\"n\">soft</th><th class=\"n\">soft / event</th><th></th></tr></thead>\n<tbody>\n{}"
      "</tbody>\n</table></div>\n",
      title, html_rows(lines, abouts));
}

/// Rates per bin of both engines over the bin edges.
Plot curves(const std::vector<ComparedBin>& bins, const char* title, const char* what,
            std::string_view unit) {
  const Multiple m = multiple(bins.empty() ? 1 : bins.back().high, unit);
  Series event{"event engine", {}, {}, {}, Mark::steps}, soft = event;
  soft.name = "soft engine";
  double most = 0;
  for (const ComparedBin& b : bins) {
    event.x.push_back(b.low / m.factor);
    event.y.push_back(b.rate.event.mean);
    soft.y.push_back(b.rate.soft.mean);
    most = std::fmax(most, std::fmax(b.rate.event.mean, b.rate.soft.mean));
  }
  if (!bins.empty()) event.x.push_back(bins.back().high / m.factor);
  soft.x = event.x;
  Plot plot{title,
            {fmt::format("{} ({})", what, m.unit), true},
            {"collisions per second and bin", true},
            {event, soft}};
  double rare = most;
  for (const Series* s : {&event, &soft})
    for (const double y : s->y)
      if (y > 0) rare = std::min(rare, y);
  if (most > 0) plot.y.least = std::max(0.7 * rare, most / 1e5);
  return plot;
}

Plot ratios(const std::vector<ComparedBin>& bins) {
  Series ratio{"soft / event", {}, {}, {}, Mark::points}, one{"equal", {}, {}, {}, Mark::line};
  for (const ComparedBin& b : bins) {
    const double r = b.rate.ratio();
    if (!(b.low > 0) || !std::isfinite(r) || !(r > 0)) continue;
    ratio.x.push_back(std::sqrt(b.low * b.high));
    ratio.y.push_back(r);
    ratio.error.push_back(b.rate.ratio_ci95());
  }
  if (!bins.empty()) one.x = {std::max(bins.front().low, bins.front().high / 2), bins.back().high};
  one.y = {1, 1};
  return {.title = "Rate of the soft engine over that of the event engine",
          .x = Axis{"normal speed of impact (m/s)", true},
          .y = Axis{"ratio", true},
          .series = {ratio, one},
          .shape = 0.39};
}

std::string boxes(const char* engine, const EngineDiagnostics& side) {
  std::string text;
  const auto box = [&](const std::string& words, const char* kind) {
    text += fmt::format("<section class=\"box{}\"><p><b>{} engine.</b> {}</p></section>\n", kind,
                        engine, escaped(words));
  };
  for (const Notice& one : side.notices) box(one.text, one.warns() ? " warn" : "");
  return text;
}

std::vector<CompareLine> quantity_lines(const Comparison& c) {
  std::vector<CompareLine> lines;
  for (const ComparedQuantity& q : c.quantities)
    lines.push_back(line_of(label(q.name), q.estimates, q.unit, results::range_of(q.name)));
  return lines;
}

}  // namespace

std::string compare_table(const Comparison& c) {
  std::string text = aligned_lines(quantity_lines(c), "");
  text += aligned_lines(lines_of(c.speeds, "m/s"), "collisions by normal speed");
  text += aligned_lines(lines_of(c.energies, "J"), "collisions by normal energy");
  for (const auto& [name, side] : {std::pair{"event", &c.event}, std::pair{"soft", &c.soft}})
    for (const Notice& one : side->notices)
      text += fmt::format("{} engine: {}\n\n", name, one.text);
  if (!c.caution.empty()) text += c.caution + "\n\n";
  return text + fmt::format("The threshold is a normal speed of {}.\n\n{}\n",
                            threshold_text(c.threshold), how_to_read(c));
}

std::string compare_page(const Comparison& c, std::string_view version) {
  std::vector<std::string> abouts;  // none for "_above_threshold": the row before has it
  for (const ComparedQuantity& q : c.quantities)
    abouts.push_back(q.name.ends_with("_above_threshold") ? "" : q.about);
  std::string body = fmt::format(
      "<p class=\"lead\">One case run with both engines: <a href=\"event/report.html\">event</a> "
      "and <a "
      "href=\"soft/report.html\">soft</a>. The threshold is a normal speed of {}.</p>\n"
      "<section class=\"box\"><p>{}</p></section>\n",
      escaped(threshold_text(c.threshold)), escaped(how_to_read(c)));
  if (!c.caution.empty())
    body += fmt::format("<section class=\"box warn\"><p>{}</p></section>\n", escaped(c.caution));
  body += boxes("Event", c.event) + boxes("Soft", c.soft);
  body += html_table("Side by side", quantity_lines(c), abouts);
  body +=
      "<p><small>± is the 95 % confidence half-width over independent replicates (Student's t); "
      "that of a ratio follows by error propagation. ≠: the intervals do not "
      "overlap.</small></p>\n";
  body +=
      figure(curves(c.speed_curve, "Spectrum of normal speeds", "normal speed of impact", "m/s"),
             "Collisions per second in each bin of speed, four bins per octave.");
  body += figure(ratios(c.speeds), "By octave of speed, with 95 % intervals.");
  body += html_table("Collisions per second by normal speed", lines_of(c.speeds, "m/s"));
  body +=
      figure(curves(c.energy_curve, "Spectrum of normal energies", "normal energy of impact", "J"),
             "Collisions per second in each bin of energy, four bins per octave.");
  body += html_table("Collisions per second by normal energy", lines_of(c.energies, "J"));
  return page(c.title.empty() ? "A ball mill" : c.title, body,
              fmt::format("Mahlwerk {}. The numbers are in compare.csv, the results of each engine "
                          "in event/ and soft/.",
                          escaped(version)));
}

}  // namespace mahlwerk::report
