// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Parts in a periodic jar that do not fit together with their images. A ball touches the image of a
// part whose origin is nearest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/faults/inconsistencies.hpp"
#include "mahlwerk/cases/setup/obstacles.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {
namespace {

constexpr double parallel = 1e-9;  // [1] sine of the angle between directions that count as one

/// [m] How far a solid reaches from its origin along the direction `u` of its own axes, to either
/// side.
double reach_along(const geometry::Frustum& f, const Vec3& u) {
  const double across = math::hypot(u.x, u.y), up = 0.5 * f.length * u.z;
  return std::max({f.high_radius * across + up, f.low_radius * across - up,
                   f.high_radius * across - up, f.low_radius * across + up});
}
double reach_along(const geometry::AnySolid& any, const Vec3& u) {
  return std::visit(
      [&]<class S>(const S& solid) -> double {
        if constexpr (std::is_same_v<S, geometry::PlaneSolid>) {
          return std::abs(u.z) > parallel ? geometry::never : 0;
        } else if constexpr (std::is_same_v<S, geometry::BladeSolid>) {
          return 0.5 * (std::abs(u.x) * solid.length + std::abs(u.y) * solid.thickness +
                        std::abs(u.z) * solid.height);
        } else if constexpr (std::is_same_v<S, geometry::MeshSolid>) {
          double most = 0;
          for (const Vec3& p : solid.surface().points) most = std::max(most, std::abs(dot(p, u)));
          return most;
        } else if constexpr (std::is_same_v<S, geometry::RingSolid>) {
          return reach_along(
              geometry::Frustum{0.5 * solid.diameter, 0.5 * solid.diameter, solid.thickness}, u);
        } else {
          return reach_along(solid.frustum(), u);
        }
      },
      any);
}

/// Whether the section of a mesh across `u` is the same everywhere between -`half` and `half` [m]:
/// all its corners are beyond, and each corner on one side has one across from it on the other.
bool is_bar_along(const geometry::MeshSolid& mesh, const Vec3& u, double half) {
  std::vector<Vec3> low, high;  // corners, projected along u
  const double close = 1e-6 * mesh.reach();
  for (const Vec3& p : mesh.surface().points) {
    const double along = dot(p, u);
    if (std::abs(along) < half - close) return false;
    (along < 0 ? low : high).push_back(p - along * u);
  }
  const auto all_across = [&](const std::vector<Vec3>& from, std::vector<Vec3>& to) {
    std::ranges::sort(to, {}, &Vec3::x);
    return std::ranges::all_of(from, [&](const Vec3& p) {
      for (auto at = std::ranges::lower_bound(to, p.x - close, {}, &Vec3::x);
           at != to.end() && at->x <= p.x + close; ++at)
        if (norm(*at - p) <= close) return true;
      return false;
    });
  };
  return all_across(low, high) && all_across(high, low);
}

/// Whether a solid is a bar along `u` that spans -`half` to `half` [m]: it has no end there, and
/// with its images it is one bar.
bool spans(const geometry::AnySolid& any, const Vec3& u, double half) {
  const double close = 1e-9 * half;
  return std::visit(
      [&]<class S>(const S& solid) {
        const auto along = [&](double component, double length) {
          return 1 - std::abs(component) < parallel && 0.5 * length >= half - close;
        };
        if constexpr (std::is_same_v<S, geometry::PlaneSolid>) {
          return false;
        } else if constexpr (std::is_same_v<S, geometry::BladeSolid>) {
          return along(u.x, solid.length) || along(u.y, solid.thickness) ||
                 along(u.z, solid.height);
        } else if constexpr (std::is_same_v<S, geometry::MeshSolid>) {
          return is_bar_along(solid, u, half);
        } else if constexpr (std::is_same_v<S, geometry::RingSolid>) {
          return along(u.z, solid.thickness);
        } else {
          const geometry::Frustum f = solid.frustum();
          return f.low_radius == f.high_radius && along(u.z, f.length);
        }
      },
      any);
}

/// [m] Of the largest ball that touches the part.
double largest_touching(const Case& c, const MachinePart& part) {
  const double ball = largest_ball(c.balls);
  return ball >= part.body.opening ? ball : 0;
}

}  // namespace

void bad_part_images(const Case& c, std::vector<Fault>& found) {
  const Vec3 periods = geometry::periods(*c.jar.shape);
  const struct {
    const char* name;
    double period;
    Vec3 direction;
  } axes[] = {
      {"x", periods.x, {1, 0, 0}}, {"y", periods.y, {0, 1, 0}}, {"z", periods.z, {0, 0, 1}}};
  const Obstacles obstacles(c);
  for (std::size_t i = 0; i < obstacles.parts().size(); ++i)
    for (const auto& axis : axes) {
      if (!std::isfinite(axis.period)) continue;
      const Obstacles::Placed& placed = obstacles.parts()[i];
      const geometry::AnySolid& solid = *placed.part->body.solid;
      const Vec3 u = placed.axes.apply_inverse(axis.direction);
      const double reach = reach_along(solid, u), half = 0.5 * axis.period,
                   ball = largest_touching(c, *placed.part);
      if (!(reach + 0.5 * ball > half * (1 + parallel)) || spans(solid, u, half)) continue;
      const std::string where = location_of(c, fmt::format("parts.{}.kind", i + 1));
      if (!std::isfinite(reach)) {
        found.push_back(
            {where,
             fmt::format("the plane {} lies across the axis {} along which the jar is periodic",
                         placed.part->name, axis.name),
             "lay the plane along that axis, or take a jar with ends", "bad-part"});
        continue;
      }
      found.push_back(
          {where,
           fmt::format("the part {} reaches {} from its position along the axis {} of a period of "
                       "{}: a ball of {} would touch it and its periodic image at once",
                       placed.part->name, show_rounded(reach, "m"), axis.name,
                       show_rounded(axis.period, "m"), show_rounded(ball, "m")),
           fmt::format(
               "let it reach at most {}, or be a bar along that axis that spans the period; "
               "or give the jar a longer period",
               show_rounded(std::max(0.0, half - 0.5 * ball), "m")),
           "bad-part"});
    }
}

}  // namespace mahlwerk::cases
