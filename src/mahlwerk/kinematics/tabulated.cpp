// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/kinematics/tabulated.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace mahlwerk::kinematics {
namespace {

using Column = std::vector<double>;

/// Second derivatives at the knots of the periodic cubic spline through `y` (the last value equals
/// the first except for a linear trend). Solves the cyclic tridiagonal system by the
/// Sherman-Morrison formula (kin.8).
Column periodic_curvature(const Column& step, const Column& y) {
  const std::size_t n = step.size();  // number of pieces and of unknowns
  Column low(n), mid(n), high(n), right(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    low[i] = step[before];
    high[i] = step[i];
    mid[i] = 2 * (step[before] + step[i]);
    right[i] = 6 * ((y[i + 1] - y[i]) / step[i] - (y[before + 1] - y[before]) / step[before]);
  }
  const double corner_top = low[0], corner_bottom = high[n - 1], gamma = -mid[0];
  mid[0] -= gamma;
  mid[n - 1] -= corner_top * corner_bottom / gamma;
  const auto solve = [&](Column b) {
    Column m = mid;
    for (std::size_t i = 1; i < n; ++i) {
      const double factor = low[i] / m[i - 1];
      m[i] -= factor * high[i - 1];
      b[i] -= factor * b[i - 1];
    }
    b[n - 1] /= m[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) b[i] = (b[i] - high[i] * b[i + 1]) / m[i];
    return b;
  };
  Column u(n, 0.0);
  u[0] = gamma;
  u[n - 1] = corner_bottom;
  const Column x = solve(right), z = solve(u);
  const double share = corner_top / gamma;
  const double scale = (x[0] + share * x[n - 1]) / (1 + z[0] + share * z[n - 1]);
  Column m(n + 1);
  for (std::size_t i = 0; i < n; ++i) m[i] = x[i] - scale * z[i];
  m[n] = m[0];
  return m;
}

void check(const std::vector<Sample>& samples) {
  if (samples.size() < 4)
    throw std::invalid_argument("a motion needs at least 4 samples, this one has " +
                                std::to_string(samples.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    const std::string which = "sample " + std::to_string(i + 1);
    if (!std::isfinite(s.time) || !finite(s.centre) || !std::isfinite(s.angle))
      throw std::invalid_argument(which + " is not a finite number throughout");
    if (i > 0 && s.time <= samples[i - 1].time)
      throw std::invalid_argument(which + " is not later than the one before it");
  }
  double reach = 0;
  for (const Sample& s : samples) reach = std::max(reach, norm(s.centre - samples[0].centre));
  if (norm(samples.back().centre - samples[0].centre) > 1e-9 * reach)
    throw std::invalid_argument(
        "the last sample must put the jar where the first does, to close the period");
}

}  // namespace

Tabulated::Tabulated(std::vector<Sample> samples, Vec3 axis)
    : samples_(std::move(samples)), axis_(axis) {
  check(samples_);
  samples_.back().centre = samples_.front().centre;
  const std::size_t n = samples_.size() - 1;
  period_ = samples_.back().time - samples_.front().time;
  angle_per_period_ = samples_.back().angle - samples_.front().angle;
  Column step(n);
  for (std::size_t i = 0; i < n; ++i) {
    step[i] = samples_[i + 1].time - samples_[i].time;
    knots_.push_back(samples_[i].time - samples_.front().time);
  }
  pieces_.resize(n);
  for (int c = 0; c < channels; ++c) {
    Column y;
    for (const Sample& s : samples_)
      y.push_back(
          std::array{s.centre.x, s.centre.y, s.centre.z, s.angle}[static_cast<std::size_t>(c)]);
    const Column m = periodic_curvature(step, y);
    const auto k = static_cast<std::size_t>(c);
    for (std::size_t i = 0; i < n; ++i) {
      pieces_[i].value[k] = y[i];
      pieces_[i].slope[k] = (y[i + 1] - y[i]) / step[i] - step[i] * (2 * m[i] + m[i + 1]) / 6;
      pieces_[i].second[k] = m[i];
      pieces_[i].third[k] = (m[i + 1] - m[i]) / step[i];
    }
  }
  turns_ = std::any_of(samples_.begin(), samples_.end(),
                       [&](const Sample& s) { return s.angle != samples_.front().angle; });
  compute_bounds();
}

/// Accelerations are linear between knots, so their extremes lie at the knots. A speed is bounded
/// by its value at a knot plus the largest acceleration up to the next knot times the time between.
void Tabulated::compute_bounds() {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece &p = pieces_[i], &next = pieces_[(i + 1) % pieces_.size()];
    const double step = (i + 1 < pieces_.size() ? knots_[i + 1] : period_) - knots_[i];
    const Vec3 a = componentwise_abs({p.second[0], p.second[1], p.second[2]});
    const Vec3 b = componentwise_abs({next.second[0], next.second[1], next.second[2]});
    Vec3& most = bounds_.acceleration;
    most = {std::max({most.x, a.x, b.x}), std::max({most.y, a.y, b.y}),
            std::max({most.z, a.z, b.z})};
    bounds_.jerk = std::max(bounds_.jerk, norm({p.third[0], p.third[1], p.third[2]}));
    bounds_.speed = std::max(bounds_.speed, norm({p.slope[0], p.slope[1], p.slope[2]}) +
                                                step * std::max(norm(a), norm(b)));
    const double gain = std::max(std::abs(p.second[3]), std::abs(next.second[3]));
    bounds_.angular_acceleration = std::max(bounds_.angular_acceleration, gain);
    bounds_.spin = std::max(bounds_.spin, std::abs(p.slope[3]) + step * gain);
  }
}

Tabulated::SplinePoint Tabulated::find(double t) const {
  const double round = std::floor(t / period_);
  const double local = std::clamp(t - round * period_, 0.0, period_);
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), local);
  const auto i = static_cast<std::size_t>(after - knots_.begin()) - 1;
  return {&pieces_[i], local - knots_[i], round};
}

double Tabulated::at(const SplinePoint& p, int channel, int order) const {
  const auto k = static_cast<std::size_t>(channel);
  const double s = p.since, a = p.piece->second[k], j = p.piece->third[k];
  if (order == 2) return a + s * j;
  if (order == 1) return p.piece->slope[k] + s * (a + s * j / 2);
  return p.piece->value[k] + s * (p.piece->slope[k] + s * (a / 2 + s * j / 6));
}

FrameMotion Tabulated::frame_motion(double t) const {
  if (pieces_.empty()) return {};
  const SplinePoint p = find(t);
  const auto vector = [&](int order) {
    return Vec3{at(p, 0, order), at(p, 1, order), at(p, 2, order)};
  };
  return {vector(0), vector(1), vector(2)};
}

Rotation Tabulated::rotation(double t) const {
  if (!turns_) return {};
  const SplinePoint p = find(t);
  return rotation_about(axis_, at(p, 3, 0) - samples_.front().angle + p.cycle * angle_per_period_);
}

Vec3 Tabulated::spin(double t) const {
  return turns_ ? at(find(t), 3, 1) * axis_ : Vec3{};
}
Vec3 Tabulated::angular_acceleration(double t) const {
  return turns_ ? at(find(t), 3, 2) * axis_ : Vec3{};
}

}  // namespace mahlwerk::kinematics
