// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mahlwerk::report {
namespace {

/// Viridis (CC0, van der Walt and Smith) at 0, 1/10, ... 1.
constexpr std::array<std::array<int, 3>, 11> steps{{{68, 1, 84},
                                                    {72, 36, 117},
                                                    {65, 68, 135},
                                                    {53, 95, 141},
                                                    {42, 120, 142},
                                                    {33, 145, 140},
                                                    {34, 168, 132},
                                                    {68, 191, 112},
                                                    {122, 209, 81},
                                                    {189, 223, 38},
                                                    {253, 231, 37}}};

constexpr std::array<std::string_view, 7> kinds{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                "#E69F00", "#56B4E9", "#666666"};

}  // namespace

std::string viridis(double share) {
  const double at = std::clamp(share, 0.0, 1.0) * (steps.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), steps.size() - 2);
  const double part = at - static_cast<double>(low);
  std::array<int, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k)
    mixed[k] = static_cast<int>(std::lround((1 - part) * steps[low][k] + part * steps[low + 1][k]));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

std::string_view ink_on_viridis(double share) {
  return share < 0.5 ? "#fff" : "#000";
}

std::string_view kind_colour(std::size_t kind) {
  return kinds[kind % kinds.size()];
}

std::string_view ink_on_kind(std::size_t kind) {
  const std::string_view colour = kind_colour(kind);  // pink, orange and light blue are light
  return colour == kinds[3] || colour == kinds[4] || colour == kinds[5] ? "#000" : "#fff";
}

}  // namespace mahlwerk::report
