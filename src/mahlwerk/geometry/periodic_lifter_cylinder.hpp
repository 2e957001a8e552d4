// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "mahlwerk/geometry/lifter_cylinder.hpp"

namespace mahlwerk::geometry {

/// A piece of an infinitely long drum with lifter bars, without ends: periodic along its axis
/// (geo.17). Its faces are the shell and the bars of a LifterCylinder. Soft engine only.
struct PeriodicLifterCylinder {
  double diameter = 0, length = 0;             // [m] of the shell; period along the axis
  double lifters = 0;                          // number of bars
  double lifter_height = 0, lifter_width = 0;  // [m] above the shell; at the foot
  double lifter_face_angle = 0;                // [rad] between its sides and its foot
  int faces = 1;
  LifterCylinder drum;  // with ends, which are left out

  static constexpr std::string_view name = "periodic-lifter-cylinder";
  static constexpr std::string_view about =
      "a cylinder with lifter bars and without ends, periodic along its axis: a slice of a mill";
  static constexpr bool axisymmetric = false;
  static std::string face_name(int face) { return LifterCylinder::face_name(of_drum(face)); }
  static constexpr auto fields() {
    using P = PeriodicLifterCylinder;
    constexpr auto of = LifterCylinder::fields();
    const auto field = [&](std::size_t k, double P::*member) {
      return Field<P>{of[k].key,    of[k].unit,         member,
                      of[k].range,  of[k].about,        of[k].standard,
                      of[k].source, of[k].presentation, of[k].plausible};
    };
    return std::array{field(0, &P::diameter),
                      Field<P>{"length", "m", &P::length, positive, "period along the axis"}.with(
                          {.start = "100 mm"}),
                      field(2, &P::lifters),
                      field(3, &P::lifter_height),
                      field(4, &P::lifter_width),
                      field(5, &P::lifter_face_angle)};
  }
  /// Computes the members that follow from the fields.
  void complete() {
    drum.diameter = diameter, drum.height = length, drum.lifters = lifters;
    drum.lifter_height = lifter_height, drum.lifter_width = lifter_width;
    drum.lifter_face_angle = lifter_face_angle;
    drum.complete();
    faces = drum.faces - 2;
  }
  std::string flaw() const { return drum.flaw(); }

  Vec3 periods() const { return {never, never, length}; }
  Gap gap(int face, const Vec3& p) const { return drum.gap(of_drum(face), p); }
  Gap gap(int face, const Vec3& p, double within) const {
    return drum.gap(of_drum(face), p, within);
  }
  template <class V>
  [[gnu::always_inline]] LaneGap<V> gaps(const V& face, const Vec<V>& p) const {
    const V zero{};
    return drum.gaps(select<V>(less(face, zero + 0.5), face, face + (zero + 2.0)), p);
  }
  Vec3 normal_rate(int face, const Vec3& p, const Vec3& v) const {
    return drum.normal_rate(of_drum(face), p, v);
  }
  double time_to_curvature_jump(int, const Vec3&, const Vec3&) const { return never; }
  SafeTime safe_time(int face, const SafeTimeQuery& c, double radius) const {
    return drum.safe_time(of_drum(face), c, radius);
  }
  bool can_touch(int, double) const { return true; }
  double volume() const { return drum.volume(); }
  double reach() const { return drum.reach(); }
  double inradius() const { return 0.5 * diameter - lifter_height; }
  Vec3 middle() const { return {}; }
  Extent extent() const { return drum.extent(); }
  bool operator==(const PeriodicLifterCylinder&) const = default;

 private:
  static constexpr int of_drum(int face) { return face == 0 ? 0 : face + 2; }
};

}  // namespace mahlwerk::geometry
