// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/by_pair.hpp"

#include <utility>

namespace mahlwerk::observe {

ByPair::ByPair(BallKinds kinds) : kinds_(std::move(kinds)) {
  const int n = kinds_.kinds();
  const auto row = static_cast<std::size_t>(n) + 1;
  number_.resize(static_cast<std::size_t>(n) * row);
  std::int32_t next = 0;
  for (std::size_t one = 0; one + 1 < row; ++one)
    for (std::size_t other = one; other < row; ++other, ++next) {
      number_[one * row + other] = next;
      if (other + 1 < row) number_[other * row + one] = next;
    }
  tallies_.resize(static_cast<std::size_t>(next));
}

void ByPair::add(const scene::Collision& c, bool above, int bin) {
  if (tallies_.empty()) return;
  const std::int32_t row = kinds_.kinds() + 1;
  const std::int32_t other = c.other < 0 ? kinds_.kinds() : kinds_.of(c.other);
  const std::int32_t pair = number_[static_cast<std::size_t>(kinds_.of(c.ball) * row + other)];
  PairTally& tally = tallies_[static_cast<std::size_t>(pair)];
  const PairSums one{1, c.energy_normal(), c.energy_contact_point(), c.lost_normal,
                     c.lost_tangential};
  tally.all.add(one);
  tally.energy_normal.add(one.energy_normal, bin);
  if (above) tally.above.add(one);
}

void ByPair::merge(const ByPair& other) {
  for (std::size_t i = 0; i < tallies_.size(); ++i) {
    tallies_[i].all.add(other.tallies_[i].all);
    tallies_[i].above.add(other.tallies_[i].above);
    tallies_[i].energy_normal.merge(other.tallies_[i].energy_normal);
  }
}

void ByPair::carry(Archive& archive) {
  for (PairTally& tally : tallies_) {
    archive(tally.all)(tally.above);
    tally.energy_normal.carry(archive);
  }
}

ByPair::Kinds ByPair::kinds_of(int pair) const {
  int left = pair;
  for (int one = 0; one < kinds(); ++one) {
    const int many = kinds() - one + 1;  // with itself, those after it, and the jar
    if (left < many) return {one, left == many - 1 ? jar : one + left};
    left -= many;
  }
  return {};
}

}  // namespace mahlwerk::observe
