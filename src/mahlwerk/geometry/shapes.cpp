// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/geometry/shapes.hpp"

#include <algorithm>

#include "mahlwerk/base/indirect_members.hpp"

template class mahlwerk::Indirect<mahlwerk::geometry::AnyShape>;

namespace mahlwerk::geometry {

std::string_view name_of(const AnyShape& shape) {
  return std::visit([](const auto& s) -> std::string_view { return s.name; }, shape);
}
bool exact_touches(const AnyShape& shape) {
  return std::visit([]<class S>(const S&) { return has_exact_touches<S>; }, shape);
}
int faces(const AnyShape& shape) {
  return std::visit([](const auto& s) { return static_cast<int>(s.faces); }, shape);
}
std::vector<std::string> face_names(const AnyShape& shape) {
  return std::visit(
      [](const auto& s) {
        std::vector<std::string> names;
        for (int face = 0; face < s.faces; ++face) names.emplace_back(s.face_name(face));
        return names;
      },
      shape);
}
bool axisymmetric(const AnyShape& shape) {
  return std::visit([](const auto& s) -> bool { return s.axisymmetric; }, shape);
}
double radius_about_axis(const AnyShape& shape) {
  return std::visit([](const auto& s) { return radius_about_axis_of(s); }, shape);
}
double inradius(const AnyShape& shape) {
  return std::visit([](const auto& s) { return s.inradius(); }, shape);
}
double reach(const AnyShape& shape) {
  return std::visit([](const auto& s) { return s.reach(); }, shape);
}
double volume(const AnyShape& shape) {
  return std::visit([](const auto& s) { return s.volume(); }, shape);
}
Vec3 periods(const AnyShape& shape) {
  return std::visit([](const auto& s) { return periods_of(s); }, shape);
}
double rotor_tip_speed(const AnyShape& shape) {
  return std::visit([](const auto& s) -> double { return rotor_tip_speed_of(s); }, shape);
}
std::string flaw(const AnyShape& shape) {
  return std::visit(
      [](const auto& s) -> std::string {
        if constexpr (requires { s.flaw(); })
          return s.flaw();
        else
          return "";
      },
      shape);
}
double nearest_wall(const AnyShape& shape, const Vec3& p, double radius) {
  double least = never;
  std::visit(
      [&](const auto& s) {
        for_each_near_face(s, p, radius, radius,
                           [&](int, const Gap& gap) { least = std::min(least, gap.distance); });
      },
      shape);
  return least;
}

const void* held(const AnyShape& shape, const std::type_info& type) {
  return std::visit([&](const auto& s) -> const void* { return typeid(s) == type ? &s : nullptr; },
                    shape);
}

}  // namespace mahlwerk::geometry
