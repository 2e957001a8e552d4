// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/hierarchical_grid.hpp"

#include <algorithm>
#include <set>

namespace mahlwerk::event {

HierarchicalGrid::HierarchicalGrid(const Vec3& low, const Vec3& size, bool periodic,
                                   std::span<const double> diameters, double slack,
                                   std::size_t balls) {
  const double most = 32.0 * static_cast<double>(balls) + 512;  // cells of one grid
  for (const double d : std::set<double, std::greater<>>(diameters.begin(), diameters.end())) {
    if (!levels_.empty() && d > 0.5 * levels_.back().widest) continue;
    const double slack_length = slack * d;
    levels_.push_back(
        {d, slack_length, Cells(low, size, periodic, d + 2 * slack_length, slack_length, most)});
    needs_all_images_ = needs_all_images_ || levels_.back().cells.needs_all_images();
  }
  for (const double d : diameters) {
    const auto level = std::ranges::find_if(
        levels_, [&](const Level& one) { return d <= one.widest && d > 0.5 * one.widest; });
    level_of_.push_back(static_cast<int>(level - levels_.begin()));
  }
}

void HierarchicalGrid::clear() {
  for (Level& level : levels_) level.cells.clear();
}

void HierarchicalGrid::serialize(Archive& archive) {
  for (Level& level : levels_) level.cells.serialize(archive);
}

std::int64_t HierarchicalGrid::ball_count() const {
  std::int64_t all = 0;
  for (const Level& level : levels_) all += level.cells.ball_count();
  return all;
}

std::span<const std::int32_t> HierarchicalGrid::near(int level, Cell cell, std::size_t buffer) {
  std::vector<std::int32_t>& found = found_[buffer];
  const auto max_count = static_cast<std::size_t>(cells(level).max_neighbours());
  if (found.size() < max_count) found.resize(max_count);
  return with_other_levels(level, cell, cells(level).near(cell, found.data()), found);
}

std::span<const std::int32_t> HierarchicalGrid::newly_near(int level, Cell cell, Cell before) {
  std::vector<std::int32_t>& found = found_[0];
  const auto max_count = static_cast<std::size_t>(cells(level).max_neighbours());
  if (found.size() < max_count) found.resize(max_count);
  return with_other_levels(level, cell, cells(level).newly_near(cell, before, found.data()), found);
}

/// Appends the balls of other levels that can touch a ball anywhere in the cell, slack included.
/// `count` balls of the same level are in `found` already.
std::span<const std::int32_t> HierarchicalGrid::with_other_levels(
    int level, Cell cell, int count, std::vector<std::int32_t>& found) const {
  const auto near = static_cast<std::size_t>(count);
  if (levels_.size() == 1) return {found.data(), near};
  found.resize(near);
  const Cells::Borders box = cells(level).borders(cell);
  const double mine = levels_[static_cast<std::size_t>(level)].widest;
  for (const Level& other : levels_) {
    if (&other.cells == &cells(level)) continue;
    const double reach = 0.5 * (mine + other.widest) + other.slack;
    other.cells.within(box.low - reach * Vec3{1, 1, 1}, box.high + reach * Vec3{1, 1, 1}, found);
  }
  return found;
}

}  // namespace mahlwerk::event
