// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/by_pair.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace mahlwerk::observe {

PairSums PairTally::all() const {
  return {spectra.energy_normal.total(), spectra.energy_normal.sum(),
          spectra.energy_contact_point.sum(), spectra.lost_normal.sum(),
          spectra.lost_tangential.sum()};
}

void PairTally::add(const Columns& c, std::size_t i, bool is_above, const PairFactors& factors) {
  constexpr double degrees = 180 / std::numbers::pi;
  const auto degree =
      static_cast<std::size_t>(std::min(static_cast<int>(c.angle[i] * degrees), angle_bins - 1));
  Spectra& s = spectra;
  s.energy_normal.add(c.energy_normal[i], c.bin_normal[i]);
  s.energy_contact_point.add(c.energy_contact_point[i], c.bin_contact_point[i]);
  s.energy_centre.add(c.energy_centre[i], c.bin_centre[i]);
  s.energy_lost.add(c.lost[i], c.bin_lost[i]);
  s.lost_normal.add(c.lost_normal[i], c.bin_lost_normal[i]);
  s.lost_tangential.add(c.lost_tangential[i], c.bin_lost_tangential[i]);
  s.approach.add(c.approach[i], c.bin_approach[i]);
  s.normal_tangential.add(c.bin_normal[i], c.bin_tangential[i]);
  ++s.angle_all[degree];
  slid += factors.slid_per_loss * c.lost_tangential[i];
  erosion += c.erosion[i];
  if (!factors.flash_per_loss.empty()) {
    // What a contact loses that outlasts its collision is spread over its own time (hea.7).
    const auto bin = static_cast<std::size_t>(c.bin_normal[i]);
    const double longer = std::max(1.0, c.duration[i] / factors.hertz_time[bin]);
    const double rise = factors.flash_per_loss[bin] * c.lost[i] / std::sqrt(longer);
    s.flash.add(rise);
    flash += rise * c.lost[i];
  }
  if (c.duration[i] > 0) s.duration.add(c.duration[i]);
  if (!is_above) return;
  above.add(
      {1, c.energy_normal[i], c.energy_contact_point[i], c.lost_normal[i], c.lost_tangential[i]});
  ++s.angle_above[degree];
}

void PairTally::merge(const PairTally& other) {
  above.add(other.above);
  spectra.merge(other.spectra);
  slid += other.slid;
  erosion += other.erosion;
  flash += other.flash;
}

void PairTally::carry(Archive& archive) {
  archive(above)(slid)(erosion)(flash);
  spectra.carry(archive);
}

ByPair::ByPair(BallKinds kinds) : kinds_(std::move(kinds)) {
  const auto n = static_cast<std::size_t>(kinds_.kinds());
  const std::size_t row = n + static_cast<std::size_t>(kinds_.faces());
  number_.resize(n * row);
  std::int32_t next = 0;
  for (std::size_t one = 0; one < n; ++one)
    for (std::size_t other = one; other < row; ++other, ++next) {
      number_[one * row + other] = next;
      if (other < n) number_[other * row + one] = next;
    }
  tallies_.resize(static_cast<std::size_t>(next));
  factors_.resize(tallies_.size());
}

PairTally& ByPair::at(int pair) {
  std::vector<PairTally>& one = tallies_[static_cast<std::size_t>(pair)];
  if (one.empty()) one.resize(1);
  return one.front();
}

const PairTally& ByPair::operator[](int pair) const {
  static const PairTally none;
  const std::vector<PairTally>& one = tallies_[static_cast<std::size_t>(pair)];
  return one.empty() ? none : one.front();
}

void ByPair::merge(const ByPair& other) {
  for (int pair = 0; pair < pairs(); ++pair)
    if (!other.tallies_[static_cast<std::size_t>(pair)].empty()) at(pair).merge(other[pair]);
}

void ByPair::carry(Archive& archive) {
  for (int pair = 0; pair < pairs(); ++pair) {
    bool there = !tallies_[static_cast<std::size_t>(pair)].empty();
    archive(there);
    if (there) at(pair).carry(archive);
  }
}

ByPair::Kinds ByPair::kinds_of(int pair) const {
  int left = pair;
  for (int one = 0; one < kinds(); ++one) {
    const int sets = kinds() - one, many = sets + faces();
    if (left < sets) return {one, one + left};
    if (left < many) return {one, ~(left - sets)};
    left -= many;
  }
  return {};
}

}  // namespace mahlwerk::observe
