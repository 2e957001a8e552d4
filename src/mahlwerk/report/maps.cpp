// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::report {
namespace {

using observe::PlaneField;
using observe::WallGrid;

constexpr int levels = 32;

/// Cells grouped by colour: each colour is one SVG path.
class Cells {
 public:
  /// `share`: position on the colour scale, 0 to 1.
  void add(double share, const std::string& outline) {
    paths_[static_cast<int>(std::clamp(share, 0.0, 1.0) * (levels - 1) + 0.5)] += outline;
  }
  std::string text() const {
    std::string all;
    for (const auto& [level, path] : paths_)
      all += fmt::format("<path fill=\"{0}\" stroke=\"{0}\" stroke-width=\"0.3\" d=\"{1}\"/>\n",
                         viridis(static_cast<double>(level) / (levels - 1)), path);
    return all;
  }

 private:
  std::map<int, std::string> paths_;
};

std::string box(double x, double y, double w, double h) {
  return fmt::format("M{:.1f} {:.1f}h{:.2f}v{:.2f}h{:.2f}z", x, y, w, h, -w);
}

std::string label_at(double x, double y, std::string_view words,
                     std::string_view anchor = "start") {
  return fmt::format(
      "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"{}\" fill=\"var(--soft,#59636e)\">{}</text>\n",
      x, y, anchor, escaped(words));
}

/// A colour bar labelled `low`, `high` and `about`.
std::string colour_bar(double x, double y, double width, std::string_view low,
                       std::string_view high, std::string_view about) {
  std::string text;
  for (int i = 0; i < levels; ++i)
    text += fmt::format("<path fill=\"{}\" d=\"{}\"/>", viridis((i + 0.5) / levels),
                        box(x + width * i / levels, y, width / levels + 0.5, 10));
  return text + "\n" + label_at(x, y + 24, low) + label_at(x + width, y + 24, high, "end") +
         label_at(x + 0.5 * width, y + 24, about, "middle");
}

std::string drawing(double height, std::string_view title, const std::string& inside) {
  return fmt::format(
      "<svg viewBox=\"0 0 720 {:.0f}\" role=\"img\" aria-label=\"{}\" font-size=\"12\" "
      "font-family=\"system-ui,sans-serif\">\n{}</svg>\n",
      height, escaped(title), inside);
}

/// A value with two digits and a suitable multiple of its unit.
std::string brief(double value, std::string_view unit) {
  const Multiple m = multiple(value, unit);
  const double v = value / m.factor;
  return fmt::format("{:.{}f} {}", v, v >= 10 ? 0 : v >= 1 ? 1 : 2, m.unit);
}

/// Ring sector about (x, y), from radius a to b [px] and from angle `from` to `to` [rad], y
/// upwards.
std::string ring_piece(double x, double y, double a, double b, double from, double to) {
  const auto at = [&](double r, double angle) {
    return fmt::format("{:.1f} {:.1f}", x + r * std::cos(angle), y - r * std::sin(angle));
  };
  return fmt::format("M{}A{:.1f} {:.1f} 0 0 0 {}L{}A{:.1f} {:.1f} 0 0 1 {}z", at(b, from), b, b,
                     at(b, to), at(a, to), a, a, at(a, from));
}

}  // namespace

std::string wall_picture(const results::Outcome& outcome) {
  const results::WallRates rates = results::wall_rates(outcome);
  std::vector<double> per_area(rates.area.size());
  for (std::size_t i = 0; i < per_area.size(); ++i)
    // Cells without area have no density.
    if (rates.area[i] > 0) per_area[i] = rates.lost[i] / rates.area[i];
  std::vector<double> sorted = per_area;
  std::ranges::sort(sorted);
  // The highest 0.5 % of the cells share the last colour, so that the rest stay distinguishable.
  const double most = sorted[sorted.size() - 1 - sorted.size() / 200];
  if (!(most > 0)) return "";
  constexpr double wide = 470, left = 20, top = 24, tallest = 300;
  const double round = 2 * std::numbers::pi, radius = rates.grid.radius;
  const double tall =
      std::clamp(wide * (rates.grid.top - rates.grid.bottom) / (round * radius), 60.0, tallest);
  const double disc = std::min(0.5 * wide / round * 2, 90.0), gap = 14;
  const double discs_x = left + wide + 40 + disc, top_y = top + disc,
               bottom_y = top_y + 2 * disc + gap + 18;
  Cells cells;
  for (int cell = 0; cell < WallGrid::cells; ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    if (rates.area[i] == 0) continue;
    const double share = per_area[i] / most;
    const WallGrid::Bounds b = rates.grid.bounds(cell);
    if (WallGrid::part(cell) == WallGrid::Part::side) {
      const double h = tall / WallGrid::along;
      const double y = top + tall - h * (cell / WallGrid::around + 1);
      cells.add(share, box(left + wide * b.angle[0] / round, y,
                           wide * (b.angle[1] - b.angle[0]) / round, h));
    } else {
      const double px = disc / radius;
      const double y = WallGrid::part(cell) == WallGrid::Part::top ? top_y : bottom_y;
      cells.add(share,
                ring_piece(discs_x, y, px * b.across[0], px * b.across[1], b.angle[0], b.angle[1]));
    }
  }
  const double height = std::max(top + tall + 70, bottom_y + disc + 24);
  std::string text =
      cells.text() + label_at(left, top - 8, "side, unrolled: 0° to 360° about the axis") +
      label_at(discs_x - disc, top - 8, "upper end") +
      label_at(discs_x - disc, top_y + disc + gap + 8, "lower end") +
      colour_bar(left, top + tall + 16, 300, "0", brief(most, "W/m²"), "power lost per area");
  return drawing(height, "Impacts on the wall", text);
}

namespace {

/// One field in a square of `size` px: mass density as colour, velocity as arrows.
std::string field(const PlaneField& f, double x0, double y0, double size, double densest,
                  double fastest, bool ring, double radius) {
  const double px = size / PlaneField::cells;
  Cells cells;
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i)
      if (const double d = f.density(i, j); d > 0)
        cells.add(d / densest, box(x0 + i * px, y0 + size - (j + 1) * px, px, px));
  std::string arrows;
  constexpr int apart = 3;
  for (int j = apart / 2; j < PlaneField::cells; j += apart)
    for (int i = apart / 2; i < PlaneField::cells; i += apart) {
      if (f.density(i, j) < 0.02 * densest) continue;
      const double u = f.velocity_x(i, j) / fastest, v = f.velocity_y(i, j) / fastest;
      const double length = apart * px * 1.3, x = x0 + (i + 0.5) * px,
                   y = y0 + size - (j + 0.5) * px;
      const double dx = length * u, dy = -length * v;
      arrows +=
          fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}m{:.1f} {:.1f}l{:.1f} {:.1f}l{:.1f} {:.1f}", x,
                      y, dx, dy, -0.35 * dx - 0.2 * dy, -0.35 * dy + 0.2 * dx, 0.35 * dx + 0.2 * dy,
                      0.35 * dy - 0.2 * dx, -0.35 * dx + 0.2 * dy, -0.35 * dy - 0.2 * dx);
    }
  std::string text = cells.text() + fmt::format(
                                        "<path fill=\"none\" stroke=\"#fff\" stroke-width=\"2.2\" "
                                        "stroke-opacity=\"0.55\" d=\"{0}\"/><path fill=\"none\" "
                                        "stroke=\"#000\" stroke-width=\"0.9\" d=\"{0}\"/>\n",
                                        arrows);
  if (ring)
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" "
        "stroke=\"var(--soft,#59636e)\" stroke-width=\"1.5\"/>\n",
        x0 + 0.5 * size, y0 + 0.5 * size, 0.5 * size * radius / f.half());
  return text;
}

}  // namespace

std::string field_picture(const results::Outcome& outcome) {
  const observe::Charge charge = results::charge_of(outcome);
  if (!(charge.mass_total > 0)) return "";
  std::vector<double> found;
  double fastest = 0;
  for (const PlaneField* f : {&charge.in_carrier, &charge.in_jar})
    for (int j = 0; j < PlaneField::cells; ++j)
      for (int i = 0; i < PlaneField::cells; ++i)
        if (const double d = f->density(i, j); d > 0) {
          found.push_back(d);
          fastest = std::max(fastest, std::hypot(f->velocity_x(i, j), f->velocity_y(i, j)));
        }
  std::ranges::sort(found);
  const double densest = found[found.size() - 1 - found.size() / 100];
  const kinematics::AnyMotion& motion = *outcome.mill_case.mill.motion;
  const Vec3 normal = kinematics::plane_normal(motion);
  const bool ring = norm(cross(normal, outcome.mill_case.mill.jar_axis)) < 1e-9;
  const bool disc = kinematics::as<kinematics::Planetary>(motion) != nullptr;
  const double radius = outcome.replicates.front().tally.wall_map.grid().radius;
  constexpr double size = 330, top = 24;
  const std::string text =
      label_at(10, 14,
               disc ? "in the frame of the disc, outwards to the right"
                    : "in a non-rotating frame at the jar's centre") +
      field(charge.in_carrier, 10, top, size, densest, fastest, ring, radius) +
      label_at(380, 14, "in the frame of the rotating jar") +
      field(charge.in_jar, 380, top, size, densest, fastest, ring, radius) +
      colour_bar(10, top + size + 12, 300, "0", brief(densest, "kg/m²"), "mass per area") +
      label_at(380, top + size + 22, fmt::format("the longest arrow is {}", brief(fastest, "m/s")));
  return drawing(top + size + 46, "Mass and velocity of the charge", text);
}

std::string normal_tangential_picture(const results::Outcome& outcome) {
  const results::Table table = results::normal_tangential(outcome);
  if (table.rows.empty()) return "";
  const auto octave = [](double low) {
    return low > 0 ? static_cast<int>(std::lround(std::log2(low)))
                   : observe::JointHistogram::lowest_octave;
  };
  double most = 0;
  int highest = observe::JointHistogram::lowest_octave;
  for (const auto& row : table.rows) {
    most = std::max(most, row[4]);
    highest = std::max({highest, octave(row[0]), octave(row[2])});
  }
  constexpr int shown = 24;  // octaves: seven decades
  const int first = highest - shown + 1;
  constexpr double size = 336, left = 90, top = 16, px = size / shown;
  Cells cells;
  for (const auto& row : table.rows) {
    const int n = octave(row[0]) - first, t = octave(row[2]) - first;
    if (n < 0 || t < 0) continue;
    cells.add(1 + std::log10(row[4] / most) / 4,  // four decades of rates
              box(left + n * px, top + size - (t + 1) * px, px, px));
  }
  std::string text = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" "
      "stroke=\"var(--grid,#e3e6ea)\"/>\n",
      left, top, size, size);
  text += cells.text();
  text += fmt::format(
      "<path stroke=\"var(--soft,#59636e)\" stroke-dasharray=\"4 4\" d=\"M{} {}L{} {}\"/>\n", left,
      top + size, left + size, top);
  for (int k = 0; k <= shown; k += 6) {
    const std::string energy = brief(std::ldexp(1.0, first + k), "J");
    text += label_at(left + k * px, top + size + 16, energy, "middle");
    text += label_at(left - 6, top + size - k * px + 4, energy, "end");
  }
  text += label_at(left + 0.5 * size, top + size + 34, "normal energy m u_n²/2", "middle");
  text += fmt::format(
      "<text transform=\"translate(18,{:.0f}) rotate(-90)\" text-anchor=\"middle\" "
      "fill=\"var(--soft,#59636e)\">tangential energy m u_t²/2</text>\n",
      top + 0.5 * size);
  text += label_at(left + size + 24, top + 20, "above the dashed line: more tangential");
  text += label_at(left + size + 24, top + 38, "than normal energy");
  text += colour_bar(left + size + 24, top + size - 40, 230, brief(most * 1e-4, "/s"),
                     brief(most, "/s"), "per bin");
  return drawing(top + size + 44, "Normal and tangential energy of collisions", text);
}

}  // namespace mahlwerk::report
