// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/wall_map.hpp"

#include <cmath>
#include <numbers>

namespace mahlwerk::observe {

WallGrid::Part WallGrid::part(int cell) {
  if (cell < side_cells) return Part::side;
  return cell < side_cells + disc_cells ? Part::bottom : Part::top;
}

WallGrid::Bounds WallGrid::bounds(int cell) const {
  const auto between = [](int at, int many, double from, double to) {
    const double step = (to - from) / many;
    return std::array{from + at * step, from + (at + 1) * step};
  };
  if (part(cell) == Part::side)
    return {between(cell % around, around, 0, 2 * std::numbers::pi),
            between(cell / around, along, bottom, top)};
  const int in_disc = (cell - side_cells) % disc_cells;
  const auto squares = between(in_disc / sectors, rings, 0, radius * radius);
  return {between(in_disc % sectors, sectors, 0, 2 * std::numbers::pi),
          {std::sqrt(squares[0]), std::sqrt(squares[1])}};
}

}  // namespace mahlwerk::observe
