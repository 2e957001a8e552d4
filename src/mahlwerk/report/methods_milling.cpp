// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/methods_milling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/wear.hpp"

namespace mahlwerk::report {
namespace {

using cases::Case;

std::string starred(const Case& c, std::string_view key, const std::string& value) {
  const auto origin = std::ranges::find(c.origins, key, &cases::Origin::key);
  const bool assumed = origin != c.origins.end() && origin->assumed;
  return value + (assumed ? "*" : "");
}

std::string dose_words(const Case& c) {
  const auto time = cases::milling_time(c);
  if (!time || !c.powder || !(c.powder->mass > 0)) return "";
  return fmt::format(
      "The dose is the dissipated energy of {:.4g} min of milling over the mass of the powder, an "
      "upper limit. ",
      *time / 60);
}

std::string wear_words(const Case& c) {
  const auto* wear = c.parts.find<cases::Wear>();
  if (wear == nullptr) return "";
  constexpr std::array models{"Archard", "Finnie", "the energy lost"};
  return fmt::format("Wear by {}, with a coefficient of {}. ",
                     models[static_cast<std::size_t>(wear->model)],
                     starred(c, "wear.coefficient", show_rounded(wear->coefficient, "")));
}

std::string heat_words(const Case& c) {
  const std::optional<cases::Heat>& heat = c.heat;
  if (!heat) return "";
  constexpr double ice_point = 273.15;
  return fmt::format(
      "Temperatures are those of balls and jar as two lumps, with heat transfer coefficients of {} "
      "from the jar to air of {} and of {} from the balls to the jar. ",
      starred(c, "heat.cooling", show_rounded(heat->cooling, "W/m2/K")),
      starred(c, "heat.ambient", fmt::format("{:.3g} °C", heat->ambient - ice_point)),
      starred(c, "heat.ball_exchange", show_rounded(heat->ball_exchange, "W/m2/K")));
}

}  // namespace

std::string milling_words(const Case& c) {
  return dose_words(c) + wear_words(c) + heat_words(c);
}

}  // namespace mahlwerk::report
