// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/film.hpp"

#include <cmath>
#include <vector>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/report/representatives.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;

/// Six digits are enough for a picture, and files of thousands of positions stay small.
Json six_digits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10, 5 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
  return std::isfinite(scale) ? std::round(value * scale) / scale : value;
}

enum class FilmView { carrier, jar };

/// Positions of one ball over time: in the plane of motion, and the height above it [m].
struct FilmPath {
  Json x = Json::array(), y = Json::array(), height = Json::array();
};

/// The frames of one replicate.
class FilmReplicate {
 public:
  FilmReplicate(const results::Outcome& outcome, std::size_t replicate)
      : film_(outcome.replicates[replicate].replay),
        mill_(cases::chamber(outcome.mill_case)),
        // NOLINTNEXTLINE: the constructor of Charge, in another file, sets its fields
        charge_(mill_, outcome.replicates[replicate].tally.wall_map.grid().radius) {}

  double half() const { return charge_.in_jar.half(); }

  Json times() const {
    Json list = Json::array();
    for (const double time : film_.times()) list.push_back(six_digits(time));
    return list;
  }
  /// The recorded balls. `all` are the balls of the replicate at its start.
  Json balls(const results::Outcome& outcome, const std::vector<scene::Ball>& all) const {
    Json list = Json::array();
    for (std::size_t ball = 0; ball < film_.balls(); ++ball) {
      const scene::Ball& own = all[ball * film_.ball_stride()];
      const bool grain = outcome.mill_case.balls[static_cast<std::size_t>(own.kind)].grains;
      const std::size_t last = film_.times().size() - 1, first = grain ? last : 0;
      list.push_back(Json::object({{"number", ball * film_.ball_stride() + 1},
                                   {"grain", grain},
                                   {"radius_m", six_digits(own.radius)},
                                   {"speed_m_per_s", six_digits(double{speed(last, ball)})},
                                   {"carrier", path(FilmView::carrier, ball, first)},
                                   {"jar", path(FilmView::jar, ball, first)}}));
    }
    return list;
  }

 private:
  float speed(std::size_t frame, std::size_t ball) const {
    return film_.speeds()[frame * film_.balls() + ball];
  }
  Json path(FilmView view, std::size_t ball, std::size_t first) const {
    FilmPath path;
    for (std::size_t frame = first; frame < film_.times().size(); ++frame)
      add(path, view, frame, ball);
    return Json::array({std::move(path.x), std::move(path.y), std::move(path.height)});
  }
  void add(FilmPath& path, FilmView view, std::size_t frame, std::size_t ball) const {
    const double time = film_.mill_times()[frame];
    const auto& p = film_.positions()[frame * film_.balls() + ball];
    if (p == observe::Replay::outside) {
      for (Json* list : {&path.x, &path.y, &path.height}) list->push_back(Json(nullptr));
      return;
    }
    const Vec3 at = film_.position_unit() * Vec3{double(p[0]), double(p[1]), double(p[2])};
    const Rotation turn = view == FilmView::jar ? kinematics::rotation(*mill_.motion, time)
                                                : kinematics::carrier(*mill_.motion, time).rotation;
    const Vec3 e = turn * charge_.right(), f = turn * charge_.up();
    path.x.push_back(six_digits(dot(at, e)));
    path.y.push_back(six_digits(dot(at, f)));
    path.height.push_back(six_digits(dot(at, cross(e, f))));
  }

  const observe::Replay& film_;
  scene::Chamber mill_;
  observe::Charge charge_;
};

/// Whether the jar's axis is normal to the plane of motion, so that its wall is a circle there.
bool is_round(const results::Outcome& outcome) {
  const Vec3 normal = kinematics::plane_normal(*outcome.mill_case.mill.motion);
  return norm(cross(normal, outcome.mill_case.mill.jar_axis)) < 1e-9;
}

std::vector<scene::Ball> drawn_at_start(const cases::Case& c, int replicate) {
  return cases::drawn_spheres(c, cases::starting_balls(c, replicate));
}

}  // namespace

std::string film_json(const results::Outcome& outcome) {
  Json replicates = Json::array();
  double half = NAN;
  for (const Representative& one : representatives(outcome)) {
    const bool filmed = !outcome.replicates[one.replicate].replay.empty();
    const FilmReplicate film(outcome, one.replicate);
    half = film.half();
    const auto number = static_cast<int>(one.replicate);
    replicates.push_back(Json::object(
        {{"replicate", one.replicate + 1},
         {"words", one.words},
         {"times_s", film.times()},
         {"balls", filmed ? film.balls(outcome, drawn_at_start(outcome.mill_case, number))
                          : Json::array()}}));
  }
  return Json::object({{"half_m", six_digits(half)},
                       {"round", is_round(outcome)},
                       {"replicates", std::move(replicates)}})
             .text() +
         '\n';
}

}  // namespace mahlwerk::report
