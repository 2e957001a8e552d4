// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/observe/histogram.hpp"
#include "mahlwerk/observe/packed_array.hpp"

namespace mahlwerk::observe {

/// Joint histogram of two energies, E_n = m u_n^2/2 and E_t = m u_t^2/2, with one bin per octave.
class JointHistogram {
 public:
  static constexpr int lowest_octave = -56, octaves = 64;  ///< 1.4e-17 J to 256 J
  static constexpr int bins = octaves;

  JointHistogram() : counts_(std::size_t{bins} * bins) {}
  /// Adds a collision, by its bins of LogHistogram::bin_of(). Values beyond the ends go into the
  /// outermost bins.
  void add(std::int64_t normal, std::int64_t tangential) {
    ++counts_[index(octave(normal), octave(tangential))];
  }
  void merge(const JointHistogram& other);
  void pack() { counts_.pack(); }      ///< as of LogHistogram
  void let_go() { counts_.let_go(); }  ///< as of LogHistogram
  void serialize(Archive& archive) { counts_.serialize(archive); }
  std::int64_t count(int normal, int tangential) const {
    return counts_[index(normal, tangential)];
  }
  static double lower(int bin);  ///< [J] lower edge; 0 for the first bin

 private:
  static std::int64_t octave(std::int64_t bin) {
    constexpr std::int64_t down = LogHistogram::lowest_octave - lowest_octave;
    return std::clamp<std::int64_t>(bin / LogHistogram::per_octave + down, 0, bins - 1);
  }
  static std::size_t index(std::int64_t normal, std::int64_t tangential) {
    return static_cast<std::size_t>(normal) * bins + static_cast<std::size_t>(tangential);
  }
  PackedArray<std::int64_t> counts_;
};

constexpr int angle_bins = 90;  ///< of one degree, 0 head-on, 90 grazing
using Angles = std::array<std::int64_t, angle_bins>;

/// Distributions of the collisions of one kind of pair, in fixed memory of 0.1 MB.
struct Spectra {
  LogHistogram energy_normal, energy_contact_point, energy_centre;  ///< [J] (evt.9) to (evt.11)
  LogHistogram energy_lost, lost_normal, lost_tangential;           ///< [J]
  LogHistogram approach;                                            ///< [m/s]
  LogHistogram duration;                                            ///< [s]
  LogHistogram flash;                                               ///< [K] flash temperature rise
  JointHistogram normal_tangential;
  Angles angle_all{}, angle_above{};

  void merge(const Spectra& other);
  void pack();    ///< nothing is added from then on
  void let_go();  ///< the counts are forgotten
  void serialize(Archive& archive);
};

}  // namespace mahlwerk::observe
