// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults/faults.hpp"
#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/setup/grid.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double touch_rounding = 1e-9;  // of a radius: balls may touch

/// A ball whose place the case gives.
struct Given {
  Vec3 place;
  double radius = 0;
  std::size_t set = 0, number = 0;  // both counted from 0
};

std::string name_of(const Given& ball) {
  return fmt::format("ball {} of balls.{}", ball.number + 1, ball.set + 1);
}

/// [m] from the wall, negative outside; half a period's way where there is none.
double room_at(const geometry::AnyShape& shape, const Given& ball) {
  const Vec3 half = 0.5 * geometry::periods(shape), p = ball.place;
  const bool home = std::abs(p.x) <= half.x && std::abs(p.y) <= half.y && std::abs(p.z) <= half.z;
  return home ? geometry::nearest_wall(shape, p, ball.radius) : -1.0;
}

class PlaceCheck {
 public:
  PlaceCheck(const Case& c, std::vector<Fault>& found) : c_(c), found_(found) {
    const double reach = geometry::reach(*c.jar.shape);
    room_ = {.half = {reach, reach, reach}, .periods = geometry::periods(*c.jar.shape)};
    room_.half = {std::min(reach, 0.5 * room_.periods.x), std::min(reach, 0.5 * room_.periods.y),
                  std::min(reach, 0.5 * room_.periods.z)};
    for (std::size_t set = 0; set < c.balls.size(); ++set)
      for (std::size_t i = 0; i < c.balls[set].positions.size(); ++i)
        balls_.push_back({c.balls[set].positions[i], 0.5 * c.balls[set].diameter, set, i});
  }

  void all() {
    if (balls_.empty()) return;
    Grid grid(room_, largest_ball(c_.balls), balls_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (!in_jar(balls_[i])) continue;
      beside_others(balls_[i], grid);
      grid.add(static_cast<int>(i), balls_[i].place);
    }
  }

 private:
  bool in_jar(const Given& ball) {
    const double room = room_at(*c_.jar.shape, ball);
    if (room >= ball.radius * (1 - touch_rounding)) return true;
    fault(ball, "outside-jar",
          room < 0 ? fmt::format("{} starts outside the jar", name_of(ball))
                   : fmt::format("{} reaches {} into the wall", name_of(ball),
                                 show_rounded(ball.radius - room, "m")),
          "places are of centres, in the jar's own axes about its centre");
    return false;
  }
  /// The first of those before it that it overlaps.
  void beside_others(const Given& ball, const Grid& grid) {
    grid.around(ball.place, [&](int i) {
      const Given& other = balls_[static_cast<std::size_t>(i)];
      const double gap =
          norm(room_.between(ball.place, other.place)) - (ball.radius + other.radius);
      if (gap >= -touch_rounding * ball.radius) return true;
      fault(ball, "overlapping-balls",
            fmt::format("{} and {} overlap by {}", name_of(other), name_of(ball),
                        show_rounded(-gap, "m")),
            "move one of them");
      return false;
    });
  }
  void fault(const Given& ball, std::string code, std::string what, std::string remedy) {
    found_.push_back({place_of(c_, fmt::format("balls.{}.positions", ball.set + 1)),
                      std::move(what), std::move(remedy), std::move(code)});
  }

  const Case& c_;
  std::vector<Fault>& found_;
  Room room_;
  std::vector<Given> balls_;
};

}  // namespace

void bad_places(const Case& c, std::vector<Fault>& found) {
  if (std::isnan(jar_volume(c.jar)) || !(largest_ball(c.balls) > 0)) return;  // reported elsewhere
  PlaceCheck(c, found).all();
}

}  // namespace mahlwerk::cases
