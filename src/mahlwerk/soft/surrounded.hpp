// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <variant>

#include "mahlwerk/soft/surroundings.hpp"

namespace mahlwerk::soft {

template <class S, class M>
class Surrounded final : public Surroundings {
 public:
  explicit Surrounded(const scene::Jar<S, M>& jar) : jar_(jar) {
    gravity_ = jar.gravity();
    periods_ = geometry::periods_of(jar.shape());
    faces_ = jar.shape().faces;
    sweep_ = jar.sweep();
    reach_ = jar.shape().reach();
  }

  void beats(double start, double step, std::int64_t first, std::span<Beat> out) const override {
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double t = start + static_cast<double>(first + static_cast<std::int64_t>(k)) * step;
      const kinematics::Ride ride = jar_.motion().ride(t);
      out[k] = {jar_.gravity() - ride.acceleration, ride.velocity, jar_.motion().spin(t)};
    }
  }
  kinematics::Ride ride(double t) const override { return jar_.motion().ride(t); }
  Vec3 spin(double t) const override { return jar_.motion().spin(t); }

  geometry::Gap gap(int face, const Vec3& position, double t, double within) const override {
    const Rotation q = jar_.axes(t);
    geometry::Gap found = geometry::gap_near(jar_.shape(), face, q.back(position), within);
    found.inward = q * found.inward;
    return found;
  }
  void distances(const Vec3& position, double t, double within,
                 std::span<double> out) const override {
    const Vec3 p = jar_.plain() ? position : jar_.axes(t).back(position);
    geometry::distances(jar_.shape(), p, within, out);
  }
  double distance(int face, const Vec3& position, double t, double within) const override {
    const Rotation q = jar_.axes(t);
    return geometry::distance(jar_.shape(), face, q.back(position), within);
  }
  void feet(std::span<const Near> near, double t, const Vec3& spin,
            const Places& p) const override {
    const bool plain = jar_.plain();
    const Rotation q = plain ? Rotation{} : jar_.axes(t);
    for (std::size_t k = 0; k < near.size(); ++k) {
      const auto b = static_cast<std::size_t>(near[k].ball);
      const double slack = near[k].slack;
      if (p.moved != nullptr && slack > 0 && p.moved[b] < slack * slack) continue;
      const Vec3 place{p.x[b], p.y[b], p.z[b]};
      geometry::Gap gap = geometry::gap_near(jar_.shape(), near[k].face,
                                             plain ? place : q.back(place), near[k].within);
      if (!plain) gap.inward = q * gap.inward;
      const Vec3 foot = place - gap.distance * gap.inward, velocity = cross(spin, foot);
      p.fx[k] = foot.x, p.fy[k] = foot.y, p.fz[k] = foot.z;
      p.fu[k] = velocity.x, p.fv[k] = velocity.y, p.fw[k] = velocity.z;
      p.sx[k] = spin.x, p.sy[k] = spin.y, p.sz[k] = spin.z;
    }
  }
  void feet(const Row* rows, const std::array<std::int32_t, lanes>& balls,
            const std::array<std::int32_t, lanes>& faces, const LaneMask& touching, double t,
            double beyond, Eight (&feet)[3]) const override {
    const bool plain = jar_.plain();
    const Rotation q = plain ? Rotation{} : jar_.axes(t);
    for (int l = 0; l < lanes; ++l) {
      const auto k = static_cast<std::size_t>(l);
      const Row& ball = rows[balls[k]];
      const Vec3 place = ball.place();
      const double within = touching[l] != 0 ? ball.radius + beyond : 0;
      geometry::Gap gap =
          geometry::gap_near(jar_.shape(), faces[k], plain ? place : q.back(place), within);
      if (!plain) gap.inward = q * gap.inward;
      const Vec3 foot = place - gap.distance * gap.inward;
      feet[0].is[l] = foot.x, feet[1].is[l] = foot.y, feet[2].is[l] = foot.z;
    }
  }
  double clear(const scene::Passing& ball, double t, double radius) const override {
    double least = geometry::never;
    const int asked = requires {
      S::one_outlook;
    }
    ? 1 : jar_.shape().faces;
    for (int face = 0; face < asked; ++face)
      if (jar_.shape().meets(face, radius))
        least = std::min(least, jar_.outlook(face, ball, t, radius).time);
    return least;
  }
  /// From how the normal turns along the parallel surface through the ball's centre.
  std::pair<double, double> curvatures(int face, const Vec3& position, double t) const override {
    const Rotation q = jar_.axes(t);
    const Vec3 p = q.back(position);
    const geometry::Gap gap = jar_.shape().gap(face, p);
    const Vec3 n = gap.inward;
    const Vec3 side = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 a0 = cross(n, side), a = a0 / norm(a0), b = cross(n, a);
    const Vec3 along = jar_.shape().normal_rate(face, p, a);
    const Vec3 across = jar_.shape().normal_rate(face, p, b);
    const double aa = -dot(a, along), bb = -dot(b, across), ab = -dot(a, across);
    const double middle = 0.5 * (aa + bb), half = std::hypot(0.5 * (aa - bb), ab);
    const auto at_wall = [&](double k) { return k / (1 + k * gap.distance); };
    return {at_wall(middle + half), at_wall(middle - half)};
  }
  Vec3 own(const Vec3& a, double t) const override { return jar_.own(a, t); }
  bool meets(int face, double radius) const override { return jar_.shape().meets(face, radius); }

 private:
  scene::Jar<S, M> jar_;
};

template <class S>
std::unique_ptr<const Surroundings> surroundings_of(const S& shape, const scene::Chamber& chamber) {
  return std::visit(
      [&]<class M>(const M& motion) -> std::unique_ptr<const Surroundings> {
        return std::make_unique<Surrounded<S, M>>(scene::Jar<S, M>(shape, motion, chamber));
      },
      chamber.motion);
}

}  // namespace mahlwerk::soft
