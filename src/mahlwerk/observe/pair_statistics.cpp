// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/pair_statistics.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "mahlwerk/powder/flash.hpp"

namespace mahlwerk::observe {

PairSums PairStatistics::all() const {
  if (all_) return *all_;
  return {spectra.energy_normal.total(), spectra.energy_normal.sum(),
          spectra.energy_contact_point.sum(), spectra.lost_normal.sum(),
          spectra.lost_tangential.sum()};
}

void PairStatistics::add(const CollisionBatch& c, std::size_t i, bool is_above,
                         const PairFactors& factors) {
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
  load_distance += factors.load_distance_per_loss * c.lost_tangential[i];
  erosion += c.erosion[i];
  if (!factors.flash_per_loss.empty()) {
    // The loss of a contact longer than Hertz's contact time is spread over its duration (hea.7),
    // as it is with the given moduli (hea.11).
    const auto bin = static_cast<std::size_t>(c.bin_normal[i]);
    const double longer = powder::unsoftened_duration(c.duration[i] / factors.hertz_time[bin],
                                                      factors.softened_duration);
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

void PairStatistics::merge(const PairStatistics& other) {
  above.add(other.above);
  spectra.merge(other.spectra);
  load_distance += other.load_distance;
  erosion += other.erosion;
  flash += other.flash;
}

void PairStatistics::let_go() {
  all_ = all();
  spectra.let_go();
}

void PairStatistics::serialize(Archive& archive) {
  archive(above)(load_distance)(erosion)(flash);
  spectra.serialize(archive);
}

StatisticsByPair::StatisticsByPair(BallKinds kinds) : kinds_(std::move(kinds)) {
  const auto n = static_cast<std::size_t>(kinds_.kinds());
  const std::size_t row = n + static_cast<std::size_t>(kinds_.faces());
  number_.resize(n * row);
  std::int32_t next = 0;
  for (std::size_t one = 0; one < n; ++one)
    for (std::size_t other = one; other < row; ++other, ++next) {
      number_[one * row + other] = next;
      if (other < n) number_[other * row + one] = next;
    }
  statistics_.resize(static_cast<std::size_t>(next));
  factors_.resize(statistics_.size());
}

PairStatistics& StatisticsByPair::at(int pair) {
  std::vector<PairStatistics>& one = statistics_[static_cast<std::size_t>(pair)];
  if (one.empty()) one.resize(1);
  return one.front();
}

const PairStatistics& StatisticsByPair::operator[](int pair) const {
  static const PairStatistics none;
  const std::vector<PairStatistics>& one = statistics_[static_cast<std::size_t>(pair)];
  return one.empty() ? none : one.front();
}

void StatisticsByPair::merge(const StatisticsByPair& other) {
  for (int pair = 0; pair < pairs(); ++pair)
    if (!other.statistics_[static_cast<std::size_t>(pair)].empty()) at(pair).merge(other[pair]);
}

void StatisticsByPair::pack() {
  for (std::vector<PairStatistics>& one : statistics_)
    for (PairStatistics& statistics : one) statistics.spectra.pack();
  factors_ = std::vector<PairFactors>();
}

void StatisticsByPair::let_go() {
  for (std::vector<PairStatistics>& one : statistics_)
    for (PairStatistics& statistics : one) statistics.let_go();
}

void StatisticsByPair::serialize(Archive& archive) {
  for (int pair = 0; pair < pairs(); ++pair) {
    bool there = !statistics_[static_cast<std::size_t>(pair)].empty();
    archive(there);
    if (there) at(pair).serialize(archive);
  }
}

StatisticsByPair::Kinds StatisticsByPair::kinds_of(int pair) const {
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
