// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/sizes.hpp"

namespace mahlwerk::powder {

/// Counter-based random numbers (SplitMix64; Steele, Lea and Flood 2014): the n-th number depends
/// on the seed and n only. Takes a tenth of the time of Random; a hit draws three numbers.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
  double operator()() {  ///< in (0, 1)
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return (static_cast<double>((z ^ (z >> 31U)) >> 11U) + 0.5) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

/// Monte Carlo sample of the powder, advanced hit by hit. Each grain stands for the same mass, so
/// that mass is conserved exactly; a broken grain becomes one fragment drawn by mass. The mean of
/// many samples is the population balance (pbm.7).
class Sample {
 public:
  /// Draws `grains` sizes from the feed. `start`: seed of the random numbers. Captures are computed
  /// for each class of the grid and for energies an eighth of an octave apart.
  Sample(Process process, std::vector<Nip> nips, SizeGrid grid, const Feed& feed, int grains,
         std::uint64_t start);

  /// Index of the kind of a collision in this nip with this `energy` [J] > 0.
  int kind(int nip, double energy);
  /// Whether a collision of this kind can break, weaken or weld a grain of any class.
  bool has_effect(int kind) const { return !kinds_[static_cast<std::size_t>(kind)].no_effect; }
  /// Applies a collision of this kind and `energy` [J], which stands for `times` collisions.
  void hit(int kind, double energy, double times = 1);

  std::vector<double> shares() const;  ///< mass share of each size class
  std::int64_t grain_hits() const { return grain_hits_; }
  /// Whether the sample can no longer change: all grains are in the finest class, and none weld.
  bool finished() const { return finest_ == grains_ && !(process_.welding > 0); }
  std::vector<double> sizes() const;  ///< [m] sizes of all grains, unordered

 private:
  static constexpr int max_groups = 128;
  struct GrainState {
    double size = 0;
    float strength = 0;  // [J/kg] for models that track strength
    std::int32_t size_class = 0;
  };
  /// Hit of a collision on one class: the share of the class's mass that is hit, and the specific
  /// energy of a captured grain over the collision's energy [1/kg]. In single precision, as reading
  /// these numbers takes much of a hit's time.
  struct ClassHit {
    float share = 0, per_energy = 0;
  };
  /// Hits of one kind of collision on all classes.
  struct CollisionKind {
    std::array<double, max_groups> most{};  // largest hit share in each group of classes
    std::vector<ClassHit> class_hits;       // by class
    int nip = 0;
    double energy = 0;      // [J]
    bool no_effect = true;  // no grain breaks, is weakened or welds
  };
  void compute_class_hits(CollisionKind& kind) const;
  template <class Model>
  void hit_grain(const Model& model, int group, std::size_t which, double energy);
  void move(int group, std::size_t which, GrainState grain);
  void update_mixed_bed();
  int group_of(int at) const { return 2 * at / grid_.per_octave(); }

  Process process_;
  std::vector<Nip> nips_;
  SizeGrid grid_;
  /// Grains in groups of half an octave of size, whose classes have similar hit shares (for
  /// rejection sampling).
  std::vector<std::vector<GrainState>> groups_;
  std::array<double, max_groups> count_{};  // grains in each group
  std::vector<CollisionKind> kinds_;
  std::map<std::pair<int, int>, int> known_;  // kinds by nip and energy step
  std::vector<double> damage_;                // table by load, for models that track strength
  SplitMix64 draw_;
  std::int64_t grains_ = 0, grain_hits_ = 0, hits_at_update_ = 0;
  std::int64_t finest_ = 0;  // grains in the finest class
  double mean_size_ = 0;     // [m] mean size for which the mixed bed was computed
};

}  // namespace mahlwerk::powder
