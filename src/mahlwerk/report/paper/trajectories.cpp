// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/trajectories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/report/plot/colours.hpp"
#include "mahlwerk/report/plot/svg_element.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/csv.hpp"

namespace mahlwerk::report {
namespace {

/// A position in the plane of motion, and the height above it [m].
struct PanelPoint {
  double x = 0, y = 0, height = 0;
};

/// The replay frames of an outcome in a reference frame.
class Film {
 public:
  Film(const results::Outcome& outcome, std::size_t replicate, View view)
      : film_(outcome.replicates[replicate].replay),
        mill_(cases::chamber(outcome.mill_case)),
        charge_(mill_, outcome.replicates[replicate].tally.wall_map.grid().radius),
        view_(view) {
    const std::vector<scene::Ball> all =
        cases::starting_balls(outcome.mill_case, static_cast<int>(replicate));
    for (std::size_t i = 0; i < all.size(); i += film_.ball_stride()) {
      radius.push_back(all[i].radius);
      grain.push_back(outcome.mill_case.balls[static_cast<std::size_t>(all[i].kind)].grains);
    }
  }

  std::size_t frames() const { return film_.times().size(); }
  double time(std::size_t frame) const { return film_.times()[frame]; }
  std::size_t number(std::size_t ball) const { return ball * film_.ball_stride() + 1; }
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

/// A square drawing with the jar's centre in its middle.
class PanelCanvas {
 public:
  /// `half`: half its width [m]; `round`: draw the jar's wall as a circle.
  PanelCanvas(double size, double half, bool round)
      : middle_(0.5 * size), scale_((0.5 * size - 2) / half), size_(size) {
    if (round)
      text_ = fmt::format(
          "<circle cx=\"{0:.1f}\" cy=\"{0:.1f}\" r=\"{1:.1f}\" fill=\"none\" stroke=\"{2}\" "
          "stroke-width=\"1.5\"/>\n",
          middle_, scale_ * half, soft_colour);
  }
  double across(const PanelPoint& p) const { return middle_ + scale_ * p.x; }
  double down(const PanelPoint& p) const { return middle_ - scale_ * p.y; }
  double length(double l) const { return scale_ * l; }
  void add(const std::string& text) { text_ += text; }

  std::string drawn(std::string_view title) const {
    return svg_head(size_, size_ + scale_bar_height, title, 11) + text_ + scale_bar() + "</svg>\n";
  }

 private:
  /// A round length below the drawing.
  std::string scale_bar() const {
    const double most = 0.3 * size_ / scale_, decade = std::pow(10, std::floor(std::log10(most)));
    double bar = decade;
    for (const double m : {2.0, 5.0})
      if (m * decade <= most) bar = m * decade;
    const double x = middle_ - 0.5 * scale_ * bar, y = size_ + 8;
    const Multiple m = multiple(bar, "m");
    return fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}v6m0 -3h{2:.1f}m0 -3v6\" fill=\"none\" stroke=\"{3}\"/>\n"
        "<text x=\"{4:.1f}\" y=\"{5:.1f}\">{6}</text>\n",
        x, y - 3, scale_ * bar, ink_colour, x + scale_ * bar + 6, y + 4,
        fmt::format("{:.6g} {}", bar / m.factor, m.unit));
  }

  double middle_, scale_, size_;
  std::string text_;
};

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
      path, kind_colour(number));
}

std::string circle(const PanelCanvas& sheet, const PanelPoint& p, double radius,
                   std::string_view colour) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\"/>\n",
                     sheet.across(p), sheet.down(p), sheet.length(radius), colour);
}

/// The ball at the end of the film, so that a ball at rest is seen, too.
std::string last_place(const Film& film, const PanelCanvas& sheet, std::size_t ball,
                       std::size_t number) {
  const PanelPoint p = film.place(film.frames() - 1, ball);
  return fmt::format(
      "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"{}\" fill-opacity=\"0.1\" "
      "stroke=\"{}\" stroke-width=\"0.6\" stroke-opacity=\"0.6\"/>\n",
      sheet.across(p), sheet.down(p), sheet.length(film.radius[ball]), kind_colour(number),
      kind_colour(number));
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
std::string picture(const results::Outcome& outcome, std::size_t replicate, View view, double size,
                    std::string_view title, const Draw& draw) {
  if (!has_frames(outcome, replicate)) return "";
  const Film film(outcome, replicate, view);
  PanelCanvas sheet(size, film.half(), is_round(outcome));
  sheet.add(draw(film, sheet));
  return sheet.drawn(title);
}

std::string number_cell(double value) {
  return fmt::format("{:.6g}", value);
}

}  // namespace

bool has_frames(const results::Outcome& outcome, std::size_t replicate) {
  return replicate < outcome.replicates.size() && !outcome.replicates[replicate].replay.empty();
}

std::string trajectories_picture(const results::Outcome& outcome, std::size_t replicate, View view,
                                 double size) {
  return picture(outcome, replicate, view, size, "Trajectories of the balls",
                 [](const Film& film, const PanelCanvas& sheet) {
                   std::string discs, paths;
                   std::size_t number = 0;
                   for (std::size_t i = 0; i < film.radius.size(); ++i) {
                     if (film.grain[i]) continue;
                     discs += last_place(film, sheet, i, number);
                     paths += trajectory(film, sheet, i, number++);
                   }
                   return discs + paths;
                 });
}

std::string snapshot_picture(const results::Outcome& outcome, std::size_t replicate, View view,
                             double size) {
  return picture(outcome, replicate, view, size, "Balls at one time", balls);
}

std::string trajectories_csv(const results::Outcome& outcome, std::size_t replicate, View view) {
  std::string text = "replicate,ball,time_s,x_m,y_m\n";
  if (!has_frames(outcome, replicate)) return text;
  const Film film(outcome, replicate, view);
  for (std::size_t i = 0; i < film.radius.size(); ++i)
    for (std::size_t f = 0; f < film.frames() && !film.grain[i]; ++f) {
      const PanelPoint p = film.place(f, i);
      text += results::csv_line({std::to_string(replicate + 1), std::to_string(film.number(i)),
                                 number_cell(film.time(f)), number_cell(p.x), number_cell(p.y)});
    }
  return text;
}

std::string snapshot_csv(const results::Outcome& outcome, std::size_t replicate, View view) {
  std::string text = "replicate,ball,kind,time_s,radius_m,x_m,y_m,height_m,speed_m_per_s\n";
  if (!has_frames(outcome, replicate)) return text;
  const Film film(outcome, replicate, view);
  const std::size_t frame = film.frames() - 1;
  for (std::size_t i = 0; i < film.radius.size(); ++i) {
    const PanelPoint p = film.place(frame, i);
    text += results::csv_line({std::to_string(replicate + 1), std::to_string(film.number(i)),
                               film.grain[i] ? "grain" : "ball", number_cell(film.time(frame)),
                               number_cell(film.radius[i]), number_cell(p.x), number_cell(p.y),
                               number_cell(p.height), number_cell(film.speed(frame, i))});
  }
  return text;
}

}  // namespace mahlwerk::report
