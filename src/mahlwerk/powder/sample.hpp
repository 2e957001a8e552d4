// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/sizes.hpp"

namespace mahlwerk::powder {

/// Random numbers from a counter (SplitMix64; Steele, Lea and Flood 2014): the n-th hangs on the
/// start and n alone. A tenth of the time of Random, which a hit draws three of.
class Draws {
 public:
  explicit Draws(std::uint64_t start) : state_(start) {}
  double operator()() {  ///< in (0, 1)
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return (static_cast<double>((z ^ (z >> 31U)) >> 11U) + 0.5) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// A sample of the powder, hit by hit: each of its grains stands for the same mass, so that mass is
/// kept to the last bit and a piece of a grain is drawn by its mass. The mean of many samples is
/// the balance (pbm.7).
class Sample {
 public:
  /// `grains` sizes drawn from the feed. Capture is worked out class by class of the grid; the
  /// process must be of beds by size, or mixed.
  Sample(Process process, std::vector<Nip> nips, SizeGrid grid, const Feed& feed, int grains,
         std::uint64_t start);

  /// A collision in that nip, of `energy` [J], that stands for `times` of its like.
  void hit(int nip, double energy, double times = 1);

  std::vector<double> shares() const;  ///< of the mass, in each class of size
  std::int64_t grain_hits() const { return grain_hits_; }
  std::int64_t grains() const { return grains_; }
  /// [m] of all grains, in no order.
  std::vector<double> sizes() const;
  /// Whether a collision of that energy can do anything to any grain of the grid.
  bool matters(int nip, double energy);

 private:
  struct One {
    double size = 0;
    double strength = 1;  // over the median, of models that remember
  };
  /// Of a collision with each class: the share of the class's mass that it hits, and the energy
  /// that a caught grain gets over that of the collision [1/kg].
  struct Row {
    std::vector<double> share, per_energy;
    bool idle = true;  // nothing that is hit breaks, is weakened or welds
  };
  const Row& row(int nip, std::int64_t energy_step);
  template <class Model>
  void strike(const Model& model, int at, double energy);
  void move(int from, std::size_t which, One grain);
  void refresh();

  Process process_;
  std::vector<Nip> nips_;
  SizeGrid grid_;
  std::vector<std::vector<One>> classes_;
  std::vector<std::map<std::int64_t, Row>> rows_;  // of each nip
  std::vector<double> damage_;                     // by load, of models that remember
  Draws draw_;
  std::int64_t grains_ = 0, grain_hits_ = 0, since_refresh_ = 0;
  double mean_size_ = 0;  // [m] that the rows of a mixed bed were made for
};

}  // namespace mahlwerk::powder
