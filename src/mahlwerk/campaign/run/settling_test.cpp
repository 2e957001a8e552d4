// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/settling_test.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {
namespace {

/// Whether the test looks after so many blocks: each look has a fifth more than the last.
bool looks_at(int blocks) {
  int next = cases::SettlingBlocks::least;
  while (next < blocks) next += std::max(1, next / 5);
  return next == blocks;
}

/// Whether a change is certain and larger than `most`.
bool certain(const observe::Trend& t, double most) {
  return std::abs(t.change) > most && std::abs(t.change) > t.ci95;
}

}  // namespace

void SettlingTest::add(const scene::EnergyBalance& now, std::int64_t hits) {
  ends_.push_back({now.time, now.lost(), now.wall_work, now.flow, static_cast<double>(hits)});
}

bool SettlingTest::settled() const {
  if (blocks() < cases::SettlingBlocks::least || !looks_at(blocks())) return false;
  constexpr double most = 0.1;  // change of a rate over the half, relative to its mean
  const std::size_t half = static_cast<std::size_t>(blocks()) / 2, first = ends_.size() - half;
  std::vector<double> lost, drawn, hits, stored;
  for (std::size_t i = first; i < ends_.size(); ++i) {
    const End &a = ends_[i - 1], &b = ends_[i];
    lost.push_back(b.lost - a.lost);
    drawn.push_back(b.wall_work - a.wall_work);
    hits.push_back(b.hits - a.hits);
    stored.push_back(b.wall_work + b.flow - b.lost);
  }
  const observe::Trend of_lost = observe::trend(lost), of_drawn = observe::trend(drawn),
                       of_hits = observe::trend(hits);
  const double turned_over =
      static_cast<double>(half) * std::max(std::abs(of_lost.mean), std::abs(of_drawn.mean));
  return !certain(of_lost, most * std::abs(of_lost.mean)) &&
         !certain(of_drawn, most * std::abs(of_drawn.mean)) &&
         !certain(of_hits, most * of_hits.mean) &&
         !certain(observe::trend(stored), 0.5 * most * turned_over);
}

}  // namespace mahlwerk::campaign
