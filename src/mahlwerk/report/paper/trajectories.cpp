// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/trajectories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/report/readable.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::array<std::string_view, 7> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#E69F00", "#56B4E9", "#666666"};

/// A position in the plane of motion, and the height above it [m].
struct PanelPoint {
  double x = 0, y = 0, height = 0;
};

/// The replay frames of an outcome in a reference frame.
class Film {
 public:
  Film(const results::Outcome& outcome, View view)
      : film_(outcome.replicates.front().replay),
        mill_(cases::chamber(outcome.mill_case)),
        charge_(mill_, outcome.replicates.front().tally.wall_map.grid().radius),
        view_(view) {
    const std::vector<scene::Ball> all = cases::starting_balls(outcome.mill_case, 0);
    for (std::size_t i = 0; i < all.size(); i += film_.ball_stride()) {
      radius.push_back(all[i].radius);
      grain.push_back(outcome.mill_case.balls[static_cast<std::size_t>(all[i].kind)].grains);
    }
  }

  std::size_t frames() const { return film_.times().size(); }
  double time(std::size_t frame) const { return film_.times()[frame]; }
  double half() const { return charge_.in_jar.half(); }
  double speed(std::size_t frame, std::size_t ball) const {
    return double{film_.speeds()[frame * film_.balls() + ball]};
  }
  /// Position of a ball in the reference frame.
  PanelPoint place(std::size_t frame, std::size_t ball) const {
    const auto& p = film_.positions()[frame * film_.balls() + ball];
    const Vec3 at = film_.position_unit() * Vec3{double(p[0]), double(p[1]), double(p[2])};
    const Rotation turn = view_ == View::jar
                              ? kinematics::rotation(*mill_.motion, time(frame))
                              : kinematics::carrier(*mill_.motion, time(frame)).rotation;
    const Vec3 e = turn * charge_.right(), f = turn * charge_.up();
    return {dot(at, e), dot(at, f), dot(at, cross(e, f))};
  }

  std::vector<double> radius;  ///< [m] of the recorded balls
  std::vector<bool> grain;

 private:
  const observe::Replay& film_;
  scene::Chamber mill_;
  observe::Charge charge_;
  View view_;
};

/// Panels with titles, in rows, on a drawing 720 px wide.
class PanelCanvas {
 public:
  /// Chooses the number of columns such that the longest title fits.
  explicit PanelCanvas(const std::vector<Panel>& panels)
      : columns_(std::min<std::size_t>(panels.size(), 4)) {
    constexpr double letter = 6.4, widest = 340;
    double longest = 0;
    for (const Panel& p : panels)
      longest = std::max(longest, letter * static_cast<double>(width(p.title)));
    const auto room = [&] { return 720.0 / static_cast<double>(columns_) - 10; };
    while (columns_ > 2 && room() < longest) --columns_;
    size_ = std::min(widest, room());
    rows_ = (panels.size() + columns_ - 1) / columns_;
  }

  /// Begins the next panel. `half`: half its width [m]; `round`: draw the jar's wall as a circle.
  void begin(const Panel& panel, double half, bool round) {
    x_ = static_cast<double>(at_ % columns_) * (size_ + 10) + 0.5 * size_;
    y_ = static_cast<double>(at_ / columns_) * (size_ + 28) + 22 + 0.5 * size_;
    scale_ = (0.5 * size_ - 2) / half;
    ++at_;
    text_ += fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\" "
        "fill=\"var(--ink,#222)\">{}</text>\n",
        x_, y_ - 0.5 * size_ - 7, escaped(panel.title));
    if (round)
      text_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"none\" "
          "stroke=\"var(--soft,#59636e)\" stroke-width=\"1.5\"/>\n",
          x_, y_, scale_ * half);
  }
  double across(const PanelPoint& p) const { return x_ + scale_ * p.x; }
  double down(const PanelPoint& p) const { return y_ - scale_ * p.y; }
  double length(double l) const { return scale_ * l; }
  void add(const std::string& text) { text_ += text; }

  std::string drawn(std::string_view title) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 720 {:.0f}\" role=\"img\" "
        "aria-label=\"{}\" font-size=\"12\" font-family=\"system-ui,sans-serif\">\n{}</svg>\n",
        static_cast<double>(rows_) * (size_ + 28), escaped(title), text_);
  }

 private:
  std::size_t columns_;
  double size_ = 0;
  std::size_t rows_ = 0, at_ = 0;
  double x_ = 0, y_ = 0, scale_ = 1;
  std::string text_;
};

bool has_film(const Panel& panel) {
  return panel.outcome != nullptr && !panel.outcome->replicates.empty() &&
         !panel.outcome->replicates.front().replay.empty();
}

/// Whether the jar's axis is normal to the plane of motion, so that its wall is a circle there.
bool is_round(const results::Outcome& outcome) {
  const Vec3 normal = kinematics::plane_normal(*outcome.mill_case.mill.motion);
  return norm(cross(normal, outcome.mill_case.mill.jar_axis)) < 1e-9;
}

std::string trajectory(const Film& film, const PanelCanvas& sheet, std::size_t ball,
                       std::size_t number) {
  std::string path;
  for (std::size_t f = 0; f < film.frames(); ++f) {
    const PanelPoint p = film.place(f, ball);
    path += fmt::format("{}{:.1f} {:.1f}", f == 0 ? 'M' : 'L', sheet.across(p), sheet.down(p));
  }
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\" stroke-opacity=\"0.8\"/>\n",
      path, colours[number % colours.size()]);
}

std::string circle(const PanelCanvas& sheet, const PanelPoint& p, double radius,
                   std::string_view colour) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                     sheet.across(p), sheet.down(p), sheet.length(radius), colour);
}

/// Root mean square speed of the grains [m/s].
double grain_speed(const Film& film, std::size_t frame) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < film.radius.size(); ++i)
    if (film.grain[i]) sum += film.speed(frame, i) * film.speed(frame, i), count += 1;
  return count > 0 ? std::sqrt(sum / count) : 0;
}

std::string balls(const Film& film, const PanelCanvas& sheet) {
  const std::size_t frame = film.frames() - 1;
  const double fast = grain_speed(film, frame);
  std::vector<std::size_t> order(film.radius.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return film.place(frame, i).height; });
  std::string text = "<g stroke=\"#000\" stroke-opacity=\"0.35\" stroke-width=\"0.5\">\n";
  for (const std::size_t i : order) {
    const bool quick = film.speed(frame, i) > fast;
    const std::string_view colour = !film.grain[i] ? "#C8102E" : quick ? "#F0C808" : "#2E8B57";
    text += circle(sheet, film.place(frame, i), film.radius[i], colour);
  }
  return text + "</g>\n";
}

template <class Draw>
std::string picture(const std::vector<Panel>& panels, View view, std::string_view title,
                    const Draw& draw) {
  if (std::ranges::none_of(panels, has_film)) return "";
  PanelCanvas sheet(panels);
  for (const Panel& panel : panels) {
    if (!has_film(panel)) continue;
    const Film film(*panel.outcome, view);
    sheet.begin(panel, film.half(), is_round(*panel.outcome));
    sheet.add(draw(film, sheet));
  }
  return sheet.drawn(title);
}

}  // namespace

std::string trajectories_picture(const std::vector<Panel>& panels, View view) {
  return picture(panels, view, "Trajectories of the balls",
                 [](const Film& film, const PanelCanvas& sheet) {
                   std::string text;
                   std::size_t number = 0;
                   for (std::size_t i = 0; i < film.radius.size(); ++i)
                     if (!film.grain[i]) text += trajectory(film, sheet, i, number++);
                   return text;
                 });
}

std::string snapshot_picture(const std::vector<Panel>& panels, View view) {
  return picture(panels, view, "Balls at one time", balls);
}

}  // namespace mahlwerk::report
