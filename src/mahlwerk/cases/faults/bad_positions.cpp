// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/setup/grid.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double touch_rounding = 1e-9;  // of a radius: balls may touch

/// A ball with a given position.
struct GivenBall {
  Vec3 position;
  double radius = 0;
  std::size_t set = 0, number = 0;  // both counted from 0
};

std::string name_of(const GivenBall& ball) {
  return fmt::format("ball {} of balls.{}", ball.number + 1, ball.set + 1);
}

/// [m] Distance from the wall, negative outside the jar or the periodic box.
double wall_distance(const geometry::AnyShape& shape, const GivenBall& ball) {
  const Vec3 half = 0.5 * geometry::periods(shape), p = ball.position;
  const bool inside = std::abs(p.x) <= half.x && std::abs(p.y) <= half.y && std::abs(p.z) <= half.z;
  return inside ? geometry::nearest_wall(shape, p, ball.radius) : -1.0;
}

class PositionCheck {
 public:
  PositionCheck(const Case& c, std::vector<Fault>& found) : c_(c), found_(found) {
    const double reach = geometry::reach(*c.jar.shape);
    domain_ = {.half = {reach, reach, reach}, .periods = geometry::periods(*c.jar.shape)};
    domain_.half = {std::min(reach, 0.5 * domain_.periods.x),
                    std::min(reach, 0.5 * domain_.periods.y),
                    std::min(reach, 0.5 * domain_.periods.z)};
    for (std::size_t set = 0; set < c.balls.size(); ++set)
      for (std::size_t i = 0; i < c.balls[set].positions.size(); ++i)
        balls_.push_back({c.balls[set].positions[i], 0.5 * c.balls[set].diameter, set, i});
  }

  /// Balls in parts of the mill, at the start of the run.
  void in_parts() {
    if (balls_.empty()) return;
    const Obstacles obstacles(c_);
    for (const GivenBall& ball : balls_) {
      const Obstacles::Nearest near = obstacles.nearest(ball.position, ball.radius);
      if (near.distance >= ball.radius * (1 - touch_rounding)) continue;
      fault(ball, "ball-in-part",
            near.distance < 0
                ? fmt::format("{} starts inside the part {}", name_of(ball), near.part->name)
                : fmt::format("{} reaches {} into the part {}", name_of(ball),
                              show_rounded(ball.radius - near.distance, "m"), near.part->name),
            "move the ball or the part; both are where they are at time 0");
    }
  }

  void all() {
    if (balls_.empty()) return;
    Grid grid(domain_, largest_ball(c_.balls), balls_.size());
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      if (!in_jar(balls_[i])) continue;
      check_overlaps(balls_[i], grid);
      grid.add(static_cast<int>(i), balls_[i].position);
    }
  }

 private:
  bool in_jar(const GivenBall& ball) {
    const double distance = wall_distance(*c_.jar.shape, ball);
    if (distance >= ball.radius * (1 - touch_rounding)) return true;
    fault(ball, "outside-jar",
          distance < 0 ? fmt::format("{} starts outside the jar", name_of(ball))
                       : fmt::format("{} reaches {} into the wall", name_of(ball),
                                     show_rounded(ball.radius - distance, "m")),
          "positions are of ball centres, in the jar's own axes from its centre");
    return false;
  }
  /// Reports the first overlap with a ball that is already in the grid.
  void check_overlaps(const GivenBall& ball, const Grid& grid) {
    grid.for_each_near(ball.position, [&](int i) {
      const GivenBall& other = balls_[static_cast<std::size_t>(i)];
      const double gap =
          norm(domain_.minimum_image(ball.position, other.position)) - (ball.radius + other.radius);
      if (gap >= -touch_rounding * ball.radius) return true;
      fault(ball, "overlapping-balls",
            fmt::format("{} and {} overlap by {}", name_of(other), name_of(ball),
                        show_rounded(-gap, "m")),
            "move one of them");
      return false;
    });
  }
  void fault(const GivenBall& ball, std::string code, std::string what, std::string remedy) {
    found_.push_back({location_of(c_, fmt::format("balls.{}.positions", ball.set + 1)),
                      std::move(what), std::move(remedy), std::move(code)});
  }

  const Case& c_;
  std::vector<Fault>& found_;
  Domain domain_;
  std::vector<GivenBall> balls_;
};

}  // namespace

void bad_positions(const Case& c, std::vector<Fault>& found) {
  if (std::isnan(jar_volume(c.jar)) || !(largest_ball(c.balls) > 0)) return;  // reported elsewhere
  PositionCheck(c, found).all();
}

void balls_in_parts(const Case& c, std::vector<Fault>& found) {
  const auto unknown = [](const MachinePart& part) {  // its file has a fault
    const kinematics::PartMotion& m = part.body.motion;
    return m.kind == kinematics::PartMotion::Kind::tabulated && m.path.samples().empty();
  };
  if (std::isnan(jar_volume(c.jar)) || !(largest_ball(c.balls) > 0)) return;  // reported elsewhere
  if (std::ranges::any_of(c.machine_parts, unknown)) return;
  PositionCheck(c, found).in_parts();
}

}  // namespace mahlwerk::cases
