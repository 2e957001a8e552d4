// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/flow.hpp"

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/cases/pairs.hpp"

namespace mahlwerk::cases {

std::vector<bool> fresh_sets(const Case& c) {
  std::vector<bool> fresh(c.balls.size(), false);
  if (!c.flow) return fresh;
  for (const std::string& name : c.flow->fresh_feed)
    for (const int kind : pair_selector(name, c).kinds)
      fresh[static_cast<std::size_t>(kind)] = true;
  return fresh;
}

std::vector<BallSet> sets_at_start(const Case& c) {
  const std::vector<bool> fresh = fresh_sets(c);
  std::vector<BallSet> inside;
  for (std::size_t i = 0; i < fresh.size(); ++i)
    if (!fresh[i]) inside.push_back(c.balls[i]);
  return inside;
}

}  // namespace mahlwerk::cases
