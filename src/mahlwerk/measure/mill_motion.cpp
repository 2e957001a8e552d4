// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/mill_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/measure/film_parts.hpp"
#include "mahlwerk/measure/oscillation.hpp"
#include "mahlwerk/measure/propagation.hpp"

namespace mahlwerk::measure {
namespace {

using observe::Estimate;

InputError film_fault(std::string what, std::string remedy) {
  return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
}

/// Length of a unit of the tracks.
Estimate scale_of(const MarkTracks& tracks, const FilmSetup& setup) {
  if (setup.scale) return *setup.scale;
  if (!setup.distance || tracks.marks.size() < 2)
    throw film_fault("the tracks are in pixels, and the length of a pixel is not known",
                     "give --scale \"0.21 mm\", or --distance \"80 mm\" between two tracked marks");
  const auto mean = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  const MarkTracks::Mark &a = tracks.marks[0], &b = tracks.marks[1];
  const double units = math::hypot(mean(a.x) - mean(b.x), mean(a.y) - mean(b.y));
  if (!(units > 0)) throw film_fault("both marks are at the same place", "track two marks");
  return {setup.distance->mean / units, setup.distance->ci95 / units};
}

/// A remark where the frames hardly follow the motion, or the film is short.
void remark_film(double frequency, double highest, double periods, Findings& found) {
  if (frequency > 0.8 * highest)
    found.remarks.push_back(fmt::format(
        "The frequency is near half the rate of frames, {}: the motion may be faster than the "
        "frames show. Film with more frames per second.",
        show_rounded(highest, "Hz", 3)));
  if (periods < 10)
    found.remarks.push_back(
        fmt::format("The film shows {:.1f} periods only; 20 and more give small errors.", periods));
}

/// Half the path's length along its longer direction, in m, and its half-width.
Estimate half_stroke(const Oscillation& of, std::size_t mark, const Estimate& scale) {
  std::vector<Estimate> inputs = phasor_inputs(of, mark);
  inputs.push_back(scale);
  return propagated(inputs,
                    [](const std::vector<double>& in) {
                      return std::vector{ellipse_of(in[0], in[1], in[2], in[3])[0] * in[4]};
                    })
      .results[0];
}

void remark_ellipse(const Oscillation& of, std::size_t mark, Findings& found) {
  const SineFit &x = of.coordinates[2 * mark], &y = of.coordinates[2 * mark + 1];
  const auto axes = ellipse_of(x.cosine, x.sine, y.cosine, y.sine);
  if (axes[1] > 0.1 * axes[0])
    found.remarks.push_back(
        fmt::format("The path of mark {} is an ellipse, {:.0f} % as wide as long: the mill does "
                    "not move along a line, or the camera shakes.",
                    mark + 1, 100 * axes[1] / axes[0]));
}

Findings vibration(const MarkTracks& tracks, const FilmSetup& setup) {
  const Oscillation of = oscillation_of(tracks, 1);
  const Estimate scale = scale_of(tracks, setup);
  Findings found{{frequency_finding(of),
                  {"mill.amplitude", "half the stroke", "m", half_stroke(of, 0, scale)}},
                 {},
                 {}};
  remark_film(of.frequency, of.highest, of.periods, found);
  remark_ellipse(of, 0, found);
  return found;
}

/// One mark: half the stroke, and the swing of a known arm.
Findings stroke_of_arc(const MarkTracks& tracks, const FilmSetup& setup) {
  const Oscillation of = oscillation_of(tracks, 1);
  const Estimate chord = half_stroke(of, 0, scale_of(tracks, setup));
  Findings found{{frequency_finding(of)}, {}, {}};
  remark_film(of.frequency, of.highest, of.periods, found);
  remark_ellipse(of, 0, found);
  if (!setup.arm) {
    found.list.push_back({"", "half the stroke of the mark", "m", chord});
    found.remarks.emplace_back(
        "One mark gives the stroke alone. For arm and swing track a second mark on the arm, or "
        "measure the arm from pivot to middle of the jar and give --arm.");
    return found;
  }
  const Propagated both = propagated({chord, *setup.arm}, [](const std::vector<double>& in) {
    const double angle = in[0] / in[1];
    return std::vector{in[1], angle * (1 + angle * angle / 8)};  // (mea.7)
  });
  add_arm_and_swing(both, found);
  return found;
}

Findings arc_shaker(const MarkTracks& tracks, const FilmSetup& setup) {
  if (tracks.marks.size() < 2) return stroke_of_arc(tracks, setup);
  const Oscillation of = oscillation_of(tracks, 2);
  const Estimate scale = scale_of(tracks, setup);
  std::vector<Estimate> inputs = phasor_inputs(of, 0);
  for (const Estimate& one : phasor_inputs(of, 1)) inputs.push_back(one);
  inputs.push_back(scale);
  const double apart_x = of.coordinates[0].centre - of.coordinates[2].centre,
               apart_y = of.coordinates[1].centre - of.coordinates[3].centre;
  const auto arc = [&](const std::vector<double>& in) {
    return rigid_arc({in[0], -in[1]}, {in[2], -in[3]}, {in[4], -in[5]}, {in[6], -in[7]}, apart_x,
                     apart_y);
  };
  const RigidArc at = arc([&] {
    std::vector<double> values;
    for (const Estimate& one : inputs) values.push_back(one.mean);
    return values;
  }());
  if (!(at.swing > 0 && at.swing < 1.5))
    throw film_fault("both marks move alike: they show no swing",
                     "track two marks at different distances from the pivot");
  Findings found{{frequency_finding(of)}, {}, {}};
  remark_film(of.frequency, of.highest, of.periods, found);
  add_arm_and_swing(propagated(inputs,
                               [&](const std::vector<double>& in) {
                                 const RigidArc one = arc(in);
                                 return std::vector{one.arm * in[8], one.swing};
                               }),
                    found);
  if (at.strain > 0.1 * at.swing)
    found.remarks.push_back(fmt::format(
        "The distance of the marks changes by {:.0f} % of what their swing moves them: they are "
        "not on one rigid part, or the camera looks at an angle.",
        100 * at.strain / at.swing));
  return found;
}

/// Throws if the path of mark 1 is a line, which no rotation is; a remark if it is an ellipse.
void check_circle(const MarkTracks& tracks, Findings& found) {
  const Oscillation of = oscillation_of(tracks, 1);
  const SineFit &x = of.coordinates[0], &y = of.coordinates[1];
  const auto axes = ellipse_of(x.cosine, x.sine, y.cosine, y.sine);
  if (axes[1] < 0.3 * axes[0])
    throw film_fault("the mark moves along a line, not around",
                     "film along the axis of rotation, or choose another --kind");
  if (axes[1] < 0.95 * axes[0])
    found.remarks.push_back(fmt::format(
        "The circle of mark 1 is seen as an ellipse, {:.0f} % as wide as long: film along the axis "
        "of rotation. The radius is the mean of both half axes.",
        100 * axes[1] / axes[0]));
}

Findings one_rotation(std::string_view kind, const MarkTracks& tracks, const FilmSetup& setup) {
  const Turning of = fit_turning(tracks.time, tracks.marks[0].x, tracks.marks[0].y, 1);
  Findings found{{speed_finding(of.vectors[0], of.freedom)}, {}, {}};
  found.list[0].value.mean = std::abs(found.list[0].value.mean);
  remark_turning(tracks, of, found);
  check_circle(tracks, found);
  if (kind == "tumbling") return found;
  found.list.push_back({"mill.radius", "radius of the circle", "m",
                        radius_times(of.vectors[0], of.freedom, scale_of(tracks, setup))});
  return found;
}

Findings planetary(const MarkTracks& tracks, const FilmSetup& setup) {
  const Estimate scale = scale_of(tracks, setup);
  Turning of = fit_turning(tracks.time, tracks.marks[0].x, tracks.marks[0].y, 2);
  std::vector<std::string> remarks;
  if (tracks.marks.size() > 1) {
    const Turning disc = fit_turning(tracks.time, tracks.marks[1].x, tracks.marks[1].y, 1);
    const auto off = [&](const TurningVector& v) {
      return std::abs(v.frequency - disc.vectors[0].frequency);
    };
    if (off(of.vectors[1]) < off(of.vectors[0])) std::swap(of.vectors[0], of.vectors[1]);
    if (off(of.vectors[0]) > 0.02 * std::abs(disc.vectors[0].frequency))
      throw film_fault("the mark on the jar does not turn with the mark on the disc",
                       "give the mark on the jar first, that on the disc second");
  } else {
    remarks.emplace_back(
        "The larger circle is taken as that of the disc: this holds if the mark is nearer to the "
        "middle of the jar than the jar to that of the disc. A second mark on the disc decides "
        "it.");
  }
  const TurningVector &orbit = of.vectors[0], &jar = of.vectors[1];
  if (std::abs(orbit.frequency + jar.frequency) < 0.01 * std::abs(orbit.frequency) &&
      std::abs(std::abs(orbit.radius) - std::abs(jar.radius)) < 0.05 * std::abs(orbit.radius))
    throw film_fault("the mark moves along a line, not around",
                     "film along the axes; track a mark at another place on the jar");
  const double t = observe::student95(of.freedom);
  const Propagated ratio = propagated({{orbit.frequency, t * orbit.frequency_deviation},
                                       {jar.frequency, t * jar.frequency_deviation}},
                                      [](const std::vector<double>& in) {
                                        return std::vector{in[1] / in[0] - 1};  // (mea.8)
                                      });
  Findings found{
      {speed_finding(orbit, of.freedom),
       {"mill.orbit_radius", "radius of the orbit", "m", radius_times(orbit, of.freedom, scale)},
       {"mill.ratio", "jar speed over disc speed, relative to the disc", "", ratio.results[0]}},
      {},
      std::move(remarks)};
  found.list[0].value.mean = std::abs(found.list[0].value.mean);
  remark_turning(tracks, of, found);
  return found;
}

}  // namespace

Findings mill_motion(std::string_view kind, const MarkTracks& tracks, const FilmSetup& setup) {
  if (tracks.marks.empty()) throw film_fault("there is no mark", "track a mark");
  if (kind == "arc-shaker") return arc_shaker(tracks, setup);
  if (kind == "vibration") return vibration(tracks, setup);
  if (kind == "planetary") return planetary(tracks, setup);
  if (kind == "circular" || kind == "tumbling") return one_rotation(kind, tracks, setup);
  throw film_fault(fmt::format("a film cannot give the motion of a mill of the kind \"{}\"", kind),
                   "measure arc-shaker, vibration, planetary, circular or tumbling; other motions "
                   "can be given as a table (kind = \"tabulated\")");
}

}  // namespace mahlwerk::measure
