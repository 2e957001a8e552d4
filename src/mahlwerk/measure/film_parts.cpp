// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/film_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::measure {

using observe::Estimate;

Oscillation oscillation_of(const MarkTracks& tracks, std::size_t marks) {
  std::vector<std::vector<double>> series;
  for (std::size_t i = 0; i < marks; ++i) {
    series.push_back(tracks.marks[i].x);
    series.push_back(tracks.marks[i].y);
  }
  return fit_oscillation(tracks.time, series);
}

Finding frequency_finding(const Oscillation& of) {
  return {"mill.frequency",
          "frequency",
          "Hz",
          {of.frequency, observe::student95(of.freedom) * of.frequency_deviation}};
}

Finding speed_finding(const TurningVector& vector, int freedom) {
  constexpr double two_pi = 2 * std::numbers::pi;
  return {"mill.speed",
          "speed",
          "rad/s",
          {two_pi * vector.frequency,
           two_pi * observe::student95(freedom) * vector.frequency_deviation}};
}

Estimate radius_times(const TurningVector& vector, int freedom, const Estimate& scale) {
  const Estimate radius{std::abs(vector.radius), observe::student95(freedom) * vector.deviation};
  return propagated({radius, scale},
                    [](const std::vector<double>& in) { return std::vector{in[0] * in[1]}; })
      .results[0];
}

std::vector<Estimate> phasor_inputs(const Oscillation& of, std::size_t mark) {
  const double t = observe::student95(of.freedom);
  std::vector<Estimate> made;
  for (const std::size_t i : {2 * mark, 2 * mark + 1}) {
    const SineFit& one = of.coordinates[i];
    made.push_back({one.cosine, t * one.deviation});
    made.push_back({one.sine, t * one.deviation});
  }
  return made;
}

std::array<double, 2> ellipse_of(double xc, double xs, double yc, double ys) {
  // Singular values of the matrix of both amplitudes.
  const double sum = math::hypot(xc + ys, xs - yc), difference = math::hypot(xc - ys, xs + yc);
  return {0.5 * (sum + difference), 0.5 * std::abs(sum - difference)};
}

RigidArc rigid_arc(Complex x1, Complex y1, Complex x2, Complex y2, double apart_x, double apart_y) {
  const double apart2 = apart_x * apart_x + apart_y * apart_y;
  const Complex dx = x1 - x2, dy = y1 - y2;
  const Complex turn = (dy * apart_x - dx * apart_y) / apart2,
                stretch = (dx * apart_x + dy * apart_y) / apart2;
  const double angle = std::abs(turn), swing = angle * (1 - angle * angle / 8);
  // The motion of the first mark in phase with the swing.
  const double along_x = (x1 * std::conj(turn)).real() / (angle * angle),
               along_y = (y1 * std::conj(turn)).real() / (angle * angle);
  const double arm = math::hypot(along_x, along_y) * (1 + swing * swing / 4);
  return {swing, arm, std::abs(stretch)};
}

void add_arm_and_swing(const Propagated& both, Findings& found) {
  const double arm = both.results[0].mean, swing = both.results[1].mean;
  const double variance = swing * swing * both.covariance[0] + arm * arm * both.covariance[3] +
                          2 * arm * swing * both.covariance[1];
  const std::size_t before = found.list.size();
  found.list.push_back({"mill.arm", "arm, from pivot to mark 1", "m", both.results[0]});
  found.list.push_back({"mill.swing", "swing to either side", "rad", both.results[1]});
  found.list.push_back({"",
                        "half the arc, arm times swing",
                        "m",
                        {arm * swing, std::sqrt(std::max(0.0, variance))}});
  const std::size_t n = found.list.size();
  found.covariance.assign(n * n, 0);
  for (std::size_t i = 0; i < n; ++i)
    found.covariance[i * n + i] = found.list[i].value.ci95 * found.list[i].value.ci95;
  found.covariance[before * n + before + 1] = found.covariance[(before + 1) * n + before] =
      both.covariance[1];
}

void remark_turning(const MarkTracks& tracks, const Turning& of, Findings& found) {
  const double fastest = std::abs(std::ranges::max(of.vectors, {}, [](const TurningVector& v) {
                                    return std::abs(v.frequency);
                                  }).frequency);
  if (fastest > 0.8 * of.highest)
    found.remarks.push_back(fmt::format(
        "A rotation is near half the rate of frames, {}: the motion may be faster than the frames "
        "show. Film with more frames per second.",
        show_rounded(of.highest, "Hz", 3)));
  const double turns = (tracks.time.back() - tracks.time.front()) * fastest;
  if (turns < 10)
    found.remarks.push_back(
        fmt::format("The film shows {:.1f} turns only; 20 and more give small errors.", turns));
}

}  // namespace mahlwerk::measure
