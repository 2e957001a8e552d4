// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/bed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/tumbling.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/quantities/mill_speed.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::PlaneField;

constexpr double degrees_of_bed = 180 / std::numbers::pi;

/// The motion of a drum that turns; else null.
const kinematics::Tumbling* turning_drum(const Case& c) {
  const kinematics::Tumbling* motion = cases::drum_motion(c);
  return motion != nullptr && motion->speed != 0 ? motion : nullptr;
}

double sense(const Case& c) {
  return cases::drum_motion(c)->speed < 0 ? -1 : 1;
}

double width(const PlaneField& field) {
  return 2 * field.half() / PlaneField::cells;
}
double middle(const PlaneField& field, int i) {
  return (i + 0.5) * width(field) - field.half();
}

/// Centre of mass in the plane, in the laboratory's axes [m]; NaN without a charge.
struct Centre {
  double x = undefined, y = undefined;
  double distance() const { return math::hypot(x, y); }
};
Centre centre(const PlaneField& field) {
  double mass = 0, x = 0, y = 0;
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i) {
      mass += field.density(i, j);
      x += field.density(i, j) * middle(field, i);
      y += field.density(i, j) * middle(field, j);
    }
  return {share(x, mass), share(y, mass)};
}

/// Density and momentum at a position, bilinear between the middles of cells.
BedPoint between_cells(const PlaneField& field, double x, double y, double tx, double ty) {
  const auto place = [&](double v) {
    return std::clamp((v + field.half()) / width(field) - 0.5, 0.0, PlaneField::cells - 1.0);
  };
  const double a = place(x), b = place(y);
  const int i = std::min(static_cast<int>(a), PlaneField::cells - 2),
            j = std::min(static_cast<int>(b), PlaneField::cells - 2);
  BedPoint point;
  double momentum = 0;
  for (const int di : {0, 1})
    for (const int dj : {0, 1}) {
      const double weight = (di == 0 ? 1 - (a - i) : a - i) * (dj == 0 ? 1 - (b - j) : b - j);
      const double density = weight * field.density(i + di, j + dj);
      point.density += density;
      momentum +=
          density * (tx * field.velocity_x(i + di, j + dj) + ty * field.velocity_y(i + di, j + dj));
    }
  point.velocity = share(momentum, point.density);
  return point;
}

/// The layer that flows down on top of the bed (obs.11).
struct SurfaceLayer {
  double top = undefined;         ///< [m] distance of the surface from the axis
  double bottom = undefined;      ///< [m] where the velocity vanishes
  double speed = undefined;       ///< [m/s] largest speed down the slope
  double shear_rate = undefined;  ///< [1/s] slope of a straight line through its profile
};

/// Slope of a least-squares line through the profile between two distances.
double slope(const std::vector<BedPoint>& line, double from, double to) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const BedPoint& p : line) {
    if (p.distance < from || p.distance > to || std::isnan(p.velocity)) continue;
    n += 1, x += p.distance, y += p.velocity;
    xx += p.distance * p.distance, xy += p.distance * p.velocity;
  }
  return n >= 3 ? (n * xy - x * y) / (n * xx - x * x) : undefined;
}

SurfaceLayer surface_layer(const std::vector<BedPoint>& line) {
  SurfaceLayer layer;
  if (line.empty()) return layer;
  // The bed is where the density exceeds half of its largest value.
  const double dense = 0.5 * std::ranges::max(line, {}, &BedPoint::density).density;
  const auto top = std::ranges::find_if(line, [&](const BedPoint& p) { return p.density > dense; });
  if (top == line.end() || top == line.begin()) return layer;
  const BedPoint& above = *(top - 1);
  const double part = (dense - above.density) / (top->density - above.density);
  layer.top = std::lerp(above.distance, top->distance, part);
  for (auto p = top; p + 1 != line.end(); ++p) {
    layer.speed = std::fmax(layer.speed, -p->velocity);
    const double now = p->velocity, next = (p + 1)->velocity;
    if (!(now < 0 && next >= 0)) continue;
    layer.bottom = std::lerp(p->distance, (p + 1)->distance, now / (now - next));
    // Cells at the surface are only partly in the bed: the line begins one cell below it.
    const double cell = 2 * (line[1].distance - line[0].distance);
    layer.shear_rate = slope(line, layer.top + cell, layer.bottom);
    break;
  }
  return layer;
}

double bed_angle(const Case& c, const Replicate& r) {
  const Centre at = centre(r.charge.in_carrier);
  return degrees_of_bed *
         std::remainder(sense(c) * (math::atan2(at.y, at.x) + 0.5 * std::numbers::pi),
                        2 * std::numbers::pi);
}
double centre_distance(const Case&, const Replicate& r) {
  return centre(r.charge.in_carrier).distance();
}
double centre_height(const Case&, const Replicate& r) {
  return centre(r.charge.in_carrier).y;
}

/// Height of the centre of mass above that of the charge at rest on the bottom (obs.12).
double charge_rise(const Case& c, const Replicate& r) {
  constexpr double packing = 0.6;  // random loose packing of spheres
  double solid = 0, least = 0;
  for (const cases::BallSet& set : c.balls) {
    solid += static_cast<double>(set.count) * cases::ball_volume(set);
    least = std::max(least, 0.5 * cases::largest_ball({set}));
  }
  const observe::WallGrid& wall = r.tally.wall_map.grid();
  const double area = cases::jar_volume(c.jar) / (wall.top - wall.bottom);
  return centre_height(c, r) - wall.bottom - std::max(least, 0.5 * solid / (packing * area));
}
SurfaceLayer layer_of(const Case& c, const Replicate& r) {
  return surface_layer(bed_profile(c, r));
}

bool is_turning_drum(const Case& c) {
  return turning_drum(c) != nullptr;
}
/// Whether it also turns in one sense.
bool has_one_bed(const Case& c) {
  return is_turning_drum(c) && has_one_sense(c);
}
constexpr std::string_view drums_in_one_sense = "drums that turn in one sense";
/// Whether the mill, which is no drum, moves in an upright plane.
bool moves_upright(const Case& c) {
  return !is_turning_drum(c) && std::abs(kinematics::plane_normal(*c.mill.motion).z) < 1e-9;
}
bool stands_upright(const Case& c) {
  return moves_upright(c) && std::abs(c.mill.jar_axis.z) > 1 - 1e-9;
}

}  // namespace

std::vector<BedPoint> bed_profile(const Case& mill_case, const Replicate& r) {
  if (r.read_before) return r.read_before->bed;
  const PlaneField& field = r.charge.in_carrier;
  const Centre at = centre(field);
  if (!has_one_bed(mill_case) || !(at.distance() > 0)) return {};
  const double ex = at.x / at.distance(), ey = at.y / at.distance();
  const double tx = -sense(mill_case) * ey, ty = sense(mill_case) * ex;
  std::vector<BedPoint> line;
  for (int k = -PlaneField::cells; k <= PlaneField::cells; ++k) {
    const double d = 0.5 * k * width(field);
    line.push_back(between_cells(field, d * ex, d * ey, tx, ty));
    line.back().distance = d;
  }
  return line;
}

Measures bed_measures() {
  return {
      {"charge_height",
       "m",
       "mean height of the balls' centre of mass above the jar's centre",
       centre_height,
       {.range = any_value,
        .applies = moves_upright,
        .only = "mills that move in an upright plane, no drums"}},
      {"charge_rise",
       "m",
       "mean height of the balls' centre of mass above that of the charge at rest on the bottom, "
       "at a packing of 0.6",
       charge_rise,
       {.range = any_value,
        .equation = "obs.12",
        .applies = stands_upright,
        .only = "the same mills with an upright jar"}},
      {"bed_angle",
       "deg",
       "angle of the charge's centre of mass from the lowest point in the sense of rotation: the "
       "slope of a flat bed",
       bed_angle,
       {.range = any_value,
        .equation = "obs.10",
        .applies = has_one_bed,
        .only = drums_in_one_sense}},
      {"charge_distance",
       "m",
       "distance of the charge's centre of mass from the drum's axis",
       centre_distance,
       {.applies = has_one_bed, .only = drums_in_one_sense}},
      {"charge_lever_arm",
       "m",
       "horizontal distance of the charge's centre of mass from the drum's axis: torque over "
       "weight",
       [](const Case& c, const Replicate& r) { return sense(c) * centre(r.charge.in_carrier).x; },
       {.range = any_value, .applies = has_one_bed, .only = drums_in_one_sense}},
      {"surface_distance",
       "m",
       "distance of the bed's surface from the axis, along the line through the centre of mass",
       [](const Case& c, const Replicate& r) { return layer_of(c, r).top; },
       {.range = any_value,
        .equation = "obs.11",
        .applies = has_one_bed,
        .only = drums_in_one_sense}},
      {"surface_layer_bottom",
       "m",
       "distance from the axis at which the velocity along the surface vanishes, on that line",
       [](const Case& c, const Replicate& r) { return layer_of(c, r).bottom; },
       {.range = any_value, .applies = has_one_bed, .only = drums_in_one_sense}},
      {"surface_speed",
       "m/s",
       "largest speed down the slope in the surface layer, on that line",
       [](const Case& c, const Replicate& r) { return layer_of(c, r).speed; },
       {.range = any_value, .applies = has_one_bed, .only = drums_in_one_sense}},
      {"surface_shear_rate",
       "1/s",
       "mean shear rate of the surface layer, on that line",
       [](const Case& c, const Replicate& r) { return layer_of(c, r).shear_rate; },
       {.range = any_value, .applies = has_one_bed, .only = drums_in_one_sense}},
  };
}

Table bed_table(const Outcome& outcome) {
  Table table{{{"distance", "m", "from the drum's axis, on the line through the centre of mass"},
               {"density", "kg/m2", "mass per area of the cross-section"},
               {"velocity", "m/s", "across the line, in the sense of rotation"},
               {"velocity_ci95", "m/s", "half-width of its 95 % interval over replicates"}},
              {}};
  std::vector<std::vector<BedPoint>> lines;
  for (const Replicate* r : averaged_replicates(outcome))
    if (std::vector<BedPoint> line = bed_profile(outcome.mill_case, *r); !line.empty())
      lines.push_back(std::move(line));
  for (std::size_t i = 0; !lines.empty() && i < lines.front().size(); ++i) {
    double density = 0;
    std::vector<double> velocities;
    for (const std::vector<BedPoint>& line : lines) {
      density += line[i].density / static_cast<double>(lines.size());
      velocities.push_back(line[i].velocity);
    }
    const observe::Estimate velocity = observe::estimate(velocities);
    table.rows.push_back({lines.front()[i].distance, density, velocity.mean, velocity.ci95});
  }
  return table;
}

}  // namespace mahlwerk::results
