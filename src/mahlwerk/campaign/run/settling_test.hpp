// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/energy_balance.hpp"

namespace mahlwerk::campaign {

/// Finds out whether a mill has settled, from its energy balance and its hits in blocks of equal
/// length (docs/theory/statistics.md, sta.9).
class SettlingTest {
 public:
  /// Adds the block that ended with the balance `now`; `hits` of it were above the threshold. The
  /// first call gives the state at the start.
  void add(const scene::EnergyBalance& now, std::int64_t hits);

  /// Blocks that have ended.
  int blocks() const { return static_cast<int>(ends_.size()) - 1; }

  /// Whether dissipated power, drawn power, rate of hits and stored energy have no trend in the
  /// second half of the blocks. False unless the number of blocks is one at which the test looks:
  /// 8, 10, 12, 15, ... (a test after each block would end early by chance).
  bool settled() const;

  void serialize(Archive& archive) { archive(ends_); }

 private:
  struct End {
    double time = 0, lost = 0, wall_work = 0, flow = 0, hits = 0;
  };
  std::vector<End> ends_;
};

}  // namespace mahlwerk::campaign
