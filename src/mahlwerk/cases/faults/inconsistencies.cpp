// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/faults/inconsistencies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/spelling.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/periodic_box.hpp"
#include "mahlwerk/geometry/periodic_cylinder.hpp"
#include "mahlwerk/geometry/rounded_cylinder.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/still.hpp"

namespace mahlwerk::cases {
namespace {

/// The key that determines the largest ball of a set.
std::string size_key(const Case& c, std::size_t set) {
  using Law = Distribution::Law;
  const Law law = c.balls[set].distribution.law;
  return fmt::format("balls.{}.{}", set + 1,
                     law == Law::uniform  ? "largest"
                     : law == Law::sieves ? "passing"
                                          : "diameter");
}

void balls_too_large(const Case& c, std::vector<Fault>& found) {
  constexpr double room = 1e-6;  // of the jar: less leaves no room for an initial position
  const double jar = 2 * geometry::inradius(*c.jar.shape);
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    if (c.balls[i].count < 1) continue;  // reported elsewhere
    const double ball = largest_ball({c.balls[i]});
    if (!(ball >= jar * (1 - room))) continue;
    found.push_back({location_of(c, c.balls[i].grains ? "powder.grain_size" : size_key(c, i)),
                     fmt::format("the ball ({}) is not smaller than the jar ({}): it cannot move",
                                 show(ball, "m"), show_rounded(jar, "m")),
                     "give a smaller ball or a larger jar", "ball-too-large"});
  }
}

/// Layers of a ball that are thicker than its radius, and half a coating.
void impossible_layers(const Case& c, std::vector<Fault>& found) {
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    const BallSet& set = c.balls[i];
    const std::string section = fmt::format("balls.{}.", i + 1);
    if (set.coating_thickness.has_value() != set.coating_density.has_value())
      found.push_back(
          {location_of(c,
                       section + (set.coating_density ? "coating_density" : "coating_thickness")),
           "a coating needs thickness and density",
           "give coating_thickness and coating_density, or neither", "impossible-ball"});
    const double thickness = set.wall_thickness.value_or(0) + set.coating_thickness.value_or(0);
    if (!set.layers().layered() || !(thickness >= 0.5 * set.diameter)) continue;
    found.push_back(
        {location_of(c, section + (set.wall_thickness ? "wall_thickness" : "coating_thickness")),
         fmt::format("the layers of a ball ({}) are not thinner than its radius ({})",
                     show(thickness, "m"), show_rounded(0.5 * set.diameter, "m")),
         "give thinner layers; a solid ball has no wall_thickness", "impossible-ball"});
  }
}

void fillet_too_large(const Case& c, std::vector<Fault>& found) {
  const auto* jar = geometry::as<geometry::RoundedCylinder>(*c.jar.shape);
  if (jar == nullptr) return;
  const double most = 0.5 * std::min(jar->diameter, jar->height);
  if (!(jar->fillet > most)) return;
  found.push_back(
      {location_of(c, "jar.fillet"),
       fmt::format("the fillet ({}) is larger than half the jar's diameter or height ({})",
                   show(jar->fillet, "m"), show_rounded(most, "m")),
       "give a smaller fillet; a jar that is all fillet is a capsule or a sphere",
       "fillet-too-large"});
}

/// A film that the asperities of touching bodies pierce.
void thin_film(const Case& c, std::vector<Fault>& found) {
  if (!c.liquid || c.liquid->model.flooded) return;
  const contact::Liquid& liquid = c.liquid->model;
  if (!(liquid.film > 0) || 2 * liquid.film > liquid.roughness) return;  // 0: reported elsewhere
  found.push_back({location_of(c, "liquid.film"),
                   fmt::format("twice the film ({}) is not more than the roughness ({}): bodies "
                               "touch before the liquid acts",
                               show(liquid.film, "m"), show(liquid.roughness, "m")),
                   "give a thicker film or a smaller roughness, or leave [liquid] out",
                   "thin-film"});
}

/// Whether all sizes of the jar are numbers: a size with a fault, which is reported elsewhere, is
/// none. The volume may be none because parts do not fit together.
bool has_sizes(const geometry::AnyShape& any) {
  return std::visit(
      []<class S>(const S& shape) {
        return std::ranges::none_of(
            S::fields(), [&](const auto& field) { return std::isnan(shape.*field.value); });
      },
      any);
}

/// Parts of a jar that do not fit together.
void impossible_jar(const Case& c, std::vector<Fault>& found) {
  if (!has_sizes(*c.jar.shape)) return;
  const std::string flaw = geometry::flaw(*c.jar.shape);
  if (flaw.empty()) return;
  found.push_back({location_of(c, "jar.kind"),
                   fmt::format("there is no such {}: {}", geometry::name_of(*c.jar.shape), flaw),
                   "see docs/theory/geometry.md for what the sizes mean", "impossible-jar"});
}

/// A periodic box has no walls that could move or carry the balls.
void periodic_box_in_a_mill(const Case& c, std::vector<Fault>& found) {
  const auto* box = geometry::as<geometry::PeriodicBox>(*c.jar.shape);
  if (box == nullptr) return;
  const auto fault = [&](const char* key, const char* what, const char* remedy) {
    found.push_back({location_of(c, key), what, remedy, "periodic-box"});
  };
  if (kinematics::as<kinematics::Still>(*c.mill.motion) == nullptr)
    fault("mill.kind", "a periodic box has no walls that a mill could move",
          "write kind = \"still\", or take a jar with walls");
  if (c.gravity != 0)
    fault("gravity", "in a periodic box balls would fall without end",
          "write gravity = \"0 m/s2\", or take a jar with walls");
  if (c.heat)
    fault("heat.milling", "a periodic box has no wall for heat to pass through", "remove [heat]");
  const double widest = largest_ball(c.balls);
  const double period = 2 * box->inradius();
  if (period <= 2 * widest && widest < period)
    fault("balls.1.diameter",
          "a ball of half the box's width touches another ball and its periodic image at once",
          "give smaller balls or a larger box");
}

/// Whether the direction of `axis` is one of symmetry: the jar neither accelerates along it nor
/// turns about another axis. By samples over a period of the motion.
bool is_symmetric_along(const kinematics::AnyMotion& motion, const Vec3& axis) {
  constexpr int samples = 128;
  constexpr double rounding = 1e-9;
  const double period = kinematics::period(motion), span = std::isfinite(period) ? period : 1.0;
  const kinematics::Bounds bounds = kinematics::bounds(motion);
  for (int i = 0; i < samples; ++i) {
    const double t = span * i / samples;
    const double along = dot(kinematics::frame_motion(motion, t).acceleration, axis);
    const Vec3 across = cross(kinematics::spin(motion, t), axis);
    if (std::abs(along) > rounding * norm(bounds.acceleration) ||
        norm(across) > rounding * bounds.spin)
      return false;
  }
  return true;
}

/// Balls move freely along the axis of a periodic cylinder: nothing may pull them along it.
void periodic_cylinder_in_a_mill(const Case& c, std::vector<Fault>& found) {
  const Vec3 periods = geometry::periods(*c.jar.shape);
  if (std::isfinite(periods.x) || !std::isfinite(periods.z)) return;
  const auto fault = [&](const std::string& key, std::string what, const char* remedy) {
    found.push_back({location_of(c, key), std::move(what), remedy, "periodic-cylinder"});
  };
  const Vec3 axis = c.mill.jar_axis;
  if (std::abs(dot(c.gravity_vector(), axis)) > 1e-9 * c.gravity)
    fault("jar.kind",
          "gravity pulls along the axis of a periodic cylinder, in which balls would fall without "
          "end",
          "lay the jar's axis across gravity (a tumbling drum, or mill.jar_axis), write "
          "gravity = \"0 m/s2\", or take a jar with ends");
  if (!is_symmetric_along(*c.mill.motion, axis))
    fault("mill.kind",
          "the mill moves a periodic cylinder along its axis or turns this axis, so the images of "
          "a ball would move differently",
          "take a mill that turns the jar about its own axis or moves it across, such as tumbling "
          "or planetary, or a jar with ends");
  const double widest = largest_ball(c.balls);
  if (periods.z <= 2 * widest)
    fault("jar.length",
          fmt::format("the period ({}) is not more than two diameters of the largest ball ({}): it "
                      "would touch another ball and its periodic image at once",
                      show(periods.z, "m"), show(widest, "m")),
          "give a longer period, or smaller balls");
}

/// A mill that is shorter than the slice of it.
void mill_shorter_than_slice(const Case& c, std::vector<Fault>& found) {
  const double slice = geometry::periods(*c.jar.shape).z;
  if (!c.jar.mill_length || !(*c.jar.mill_length < slice * (1 - 1e-9))) return;
  found.push_back({location_of(c, "jar.mill_length"),
                   fmt::format("the whole mill ({}) is shorter than the slice of it ({})",
                               show(*c.jar.mill_length, "m"), show(slice, "m")),
                   "give the length of the whole mill, or a shorter slice", "mill-length"});
}

void too_many_balls(const Case& c, std::vector<Fault>& found) {
  const std::vector<BallSet> balls = sets_at_start(c);
  double volume = 0;
  for (const BallSet& set : balls) volume += static_cast<double>(set.count) * ball_volume(set);
  const double jar = jar_volume(c.jar);
  std::set<double> sizes;
  for (const BallSet& set : balls) {
    double last = 0;  // of a distribution, only sizes small enough to fill gaps count
    for (const SizeClass& size : set.sizes())
      if (size.diameter >= 2 * last) sizes.insert(last = size.diameter);
  }
  const double most =
      1 - math::pow(1 - densest, static_cast<double>(sizes.size()));  // smaller balls fill the gaps
  if (!(volume > most * jar)) return;
  found.push_back(
      {location_of(c, "balls.1.count"),
       fmt::format("the balls ({}) fill more than {} % of the jar ({}), the densest packing",
                   show_rounded(volume, "m3"), show_rounded(100 * most, ""),
                   show_rounded(jar, "m3")),
       "give fewer or smaller balls or a larger jar", "too-many-balls"});
}

/// A wall faster than any material bears: probably a wrong unit.
void wall_too_fast(const Case& c, std::vector<Fault>& found) {
  constexpr double most = 1000;  // [m/s]
  const kinematics::Bounds bounds = kinematics::bounds(*c.mill.motion);
  const double reach = geometry::reach(*c.jar.shape);
  const double speed = bounds.speed + bounds.spin * reach;
  if (!(speed > most)) return;
  found.push_back({location_of(c, "mill.kind"),
                   fmt::format("the jar's wall would move at up to {}, more than {} m/s",
                               show_rounded(speed, "m/s"), most),
                   "check the units of the mill's numbers", "absurd-speed"});
}

/// The number of sets is limited, because each pair of sets has its own rules and statistics.
void too_many_sets(const Case& c, std::vector<Fault>& found) {
  if (c.balls.size() <= max_sets) return;
  found.push_back({location_of(c, "balls"),
                   fmt::format("there are {} ball sets, more than {}", c.balls.size(), max_sets),
                   "let sets differ by material or rules only: one set may have a distribution of "
                   "sizes",
                   "too-many-sets"});
}

/// Too many frames or too large files, probably because of a wrong unit.
void too_many_frames(const Case& c, std::vector<Fault>& found) {
  if (!c.observe.frames || !(*c.observe.frames > 0)) return;
  const double count = c.run.time / *c.observe.frames;
  const double each = frame_bytes(c), size = count * each;
  if (!(count > max_frames) && !(size > largest_frames)) return;
  const double enough = std::max(c.run.time / max_frames, c.run.time * each / largest_frames);
  found.push_back({location_of(c, "observe.frames"),
                   fmt::format("a frame every {} makes {:.2g} frames and about {:.2g} GB for each "
                               "replicate, more than {:.0g} frames or {:.0f} GB",
                               show_rounded(*c.observe.frames, "s"), count, size / 1e9, max_frames,
                               largest_frames / 1e9),
                   fmt::format("write frames = \"{}\" or more, or leave it out",
                               show_rounded(1.05 * enough, "s")),
                   "too-many-frames"});
}

/// Unknown names in [[contact.pairs]], and pairs of the jar with itself. Ignored if the jar or its
/// balls could not be read.
void unmatched_pairs(const Case& c, std::vector<Fault>& found) {
  if (c.balls.empty() || std::isnan(jar_volume(c.jar))) return;
  const std::vector<std::string> known = pair_selector_names(c);
  for (std::size_t i = 0; i < c.contact.pairs.size(); ++i) {
    const auto& [one, other] = c.contact.pairs[i].between;
    if (one.empty() && other.empty()) continue;  // reported where it was read
    const std::string place = location_of(c, fmt::format("contact.pairs.{}.between", i + 1));
    const PairSelector a = pair_selector(one, c), b = pair_selector(other, c);
    for (const auto& [name, who] : {std::pair{&one, &a}, std::pair{&other, &b}}) {
      if (!who->empty()) continue;
      const std::string near = nearest_word(*name, known);
      found.push_back({place, fmt::format("nothing in the case is called \"{}\"", *name),
                       (near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near)) +
                           fmt::format("known: {}", quoted_list(known)),
                       "unknown-name"});
    }
    if (!a.empty() && !b.empty() && a.kinds.empty() && b.kinds.empty())
      found.push_back({place, fmt::format("\"{}\" and \"{}\" are both the jar", one, other),
                       "name balls as one of the two", "no-such-pair"});
  }
}

}  // namespace

std::string location_of(const Case& c, const std::string& key) {
  const auto origin = std::ranges::find(c.origins, key, &Origin::key);
  if (origin == c.origins.end() || origin->source.starts_with("default: ")) return key;
  const std::string place = origin->source.substr(0, origin->source.find(": "));
  const std::string name = std::filesystem::path(c.file).filename().string();
  return !name.empty() && place.starts_with(name + ":") ? c.file + place.substr(name.size())
                                                        : place;
}

std::vector<Fault> inconsistencies(const Case& c) {
  std::vector<Fault> found;
  unmatched_pairs(c, found);
  const std::size_t so_far = found.size();
  balls_too_large(c, found);
  impossible_layers(c, found);
  fillet_too_large(c, found);
  impossible_jar(c, found);
  thin_film(c, found);
  periodic_box_in_a_mill(c, found);
  periodic_cylinder_in_a_mill(c, found);
  mill_shorter_than_slice(c, found);
  if (found.size() == so_far) too_many_balls(c, found);
  if (found.size() == so_far) bad_powder(c, found);
  if (found.size() == so_far) bad_positions(c, found);
  if (found.size() == so_far) bad_start_state(c, found);
  bad_ramp(c, found);
  bad_speed_over_time(c, found);
  if (found.size() == so_far) bad_parts(c, found);
  if (found.size() == so_far && !c.machine_parts.empty()) bad_part_images(c, found);
  if (found.size() == so_far && !c.machine_parts.empty()) balls_in_parts(c, found);
  if (found.size() == so_far) wall_too_fast(c, found);
  too_many_sets(c, found);
  too_many_frames(c, found);
  bad_reversal(c, found);
  for (const Part* part : parts_of(c))
    if (part->check != nullptr) part->check(c, found);
  return found;
}

std::vector<Fault> faults(const Case& c) {
  std::vector<Fault> found = bad_values(c);
  std::ranges::move(inconsistencies(c), std::back_inserter(found));
  return found;
}

}  // namespace mahlwerk::cases
