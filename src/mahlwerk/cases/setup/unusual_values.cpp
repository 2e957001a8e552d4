// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Warnings about valid values that are probably a mistake.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::cases {
namespace {

/// The densities of grinding media lie between light plastics and tungsten.
Notices densities(const Case& c) {
  constexpr double least = 500, most = 20000;  // [kg/m3]
  Notices found;
  for (std::size_t i = 0; i < c.balls.size(); ++i) {
    const double density = c.balls[i].density;
    if (density >= least && density <= most) continue;
    found.push_back(warning("unusual-density",
                            fmt::format("Balls of {} ({}) are {} than any solid medium: {}.",
                                        show_rounded(density, "kg/m3"), set_name(c, i),
                                        density < least ? "lighter" : "heavier",
                                        density < 50 ? "was g/cm3 meant? density = \"7.85 g/cm3\""
                                                     : "check the unit and the number")));
  }
  return found;
}

Notices ratios(const Case& c) {
  const auto* planetary = kinematics::as<kinematics::Planetary>(*c.mill.motion);
  if (planetary == nullptr || planetary->ratio <= 0) return {};
  return {warning(
      "unusual-ratio",
      fmt::format("The jar turns the same way as the disc, {} times as fast. Planetary "
                  "mills counter-rotate: was ratio = {} meant?",
                  show_rounded(planetary->ratio, ""), show_rounded(-planetary->ratio, "")))};
}

/// The motion with every assumed number of the mill at one end of its range.
kinematics::AnyMotion motion_at(const Case& c, std::size_t end) {
  kinematics::AnyMotion motion = *c.mill.motion;
  const auto set = [&]<class M>(M& one) {
    if constexpr (requires { M::fields(); })
      for (const auto& field : M::fields())
        for (const Origin& o : c.origins)
          if (o.key == fmt::format("mill.{}", field.key) && !o.range[end].empty())
            one.*field.value = parse_in(o.range[end], field.unit);
  };
  std::visit(set, motion);
  return motion;
}

/// Numbers of the mill that the catalogue assumes, and their effect on the speed of its jar.
Notices assumed_numbers(const Case& c) {
  std::string list;
  for (const Origin& o : c.origins)
    if (o.key.starts_with("mill.") && !o.range[0].empty())
      list += fmt::format("{}{} = {} ({} to {})", list.empty() ? "" : ", ", o.key, o.value,
                          o.range[0], o.range[1]);
  if (list.empty()) return {};
  const double now = kinematics::bounds(*c.mill.motion).speed;
  const auto change = [&](std::size_t end) {
    const double other = kinematics::bounds(motion_at(c, end)).speed / now;
    return fmt::format("{:+.0f}", 100 * (other * other - 1));
  };
  return {warning("assumed-mill",
                  fmt::format("Assumed, because they are not known of this mill: {}. Energies of "
                              "hits grow with the square of the speed of the jar, which these "
                              "ranges change by {} to {} %. Measure your mill, and give the "
                              "numbers in [mill].",
                              list, change(0), change(1)))};
}

}  // namespace

Notices unusual_values(const Case& c) {
  Notices found = densities(c);
  append(found, ratios(c));
  append(found, assumed_numbers(c));
  append(found, c.remarks);
  return found;
}

}  // namespace mahlwerk::cases
