// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/mixing.hpp"

#include <limits>

#include "mahlwerk/observe/cells.hpp"
#include "mahlwerk/observe/images.hpp"

namespace mahlwerk::observe {
namespace {

constexpr double no_index = std::numeric_limits<double>::quiet_NaN();

double marked_balls(std::span<const std::uint8_t> colours) {
  double marked = 0;
  for (const std::uint8_t colour : colours) marked += colour;
  return marked;
}

}  // namespace

double lacey_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                   double cell) {
  const auto all = static_cast<double>(balls.size());
  const double share = marked_balls(colours) / all, separated = share * (1 - share);
  if (!(separated > 0)) return no_index;
  const SortedByCell cells(balls, cell);
  double variance = 0, count = 0;
  cells.each_cell([&](std::size_t from, std::size_t to) {
    const auto n = static_cast<double>(to - from);
    double of = 0;
    for (std::size_t k = from; k < to; ++k) of += colours[cells.ball(k)];
    variance += n * (of / n - share) * (of / n - share);
    ++count;
  });
  variance /= all;
  const double mixed = separated * count / all;  // of n-weighted binomial cells
  return separated > mixed ? (separated - variance) / (separated - mixed) : no_index;
}

double neighbour_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                       double reach, const Vec3& periods) {
  const auto count = static_cast<double>(balls.size());
  const double marked = marked_balls(colours);
  if (marked == 0 || marked == count) return no_index;
  const Images all = images(balls, periods, reach);
  const SortedByCell near(all.balls, reach);
  double sum = 0, with = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3& p = all.balls[i].position;
    double neighbours = 0, others = 0;
    near.around(p, [&](std::size_t j) {
      // Its own image tells nothing of mixing.
      if (all.of[j] == i || !(squared(all.balls[j].position - p) < reach * reach)) return;
      ++neighbours;
      others += colours[all.of[j]] != colours[i] ? 1 : 0;
    });
    if (neighbours == 0) continue;
    const double expected = (colours[i] != 0 ? count - marked : marked) / (count - 1);
    sum += others / neighbours / expected;
    ++with;
  }
  return with > 0 ? sum / with : no_index;
}

}  // namespace mahlwerk::observe
