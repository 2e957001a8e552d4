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

/// Random numbers from a counter (SplitMix64; Steele, Lea and Flood 2014): the n-th hangs on the
/// start and n alone. A tenth of the time of Random, which a hit draws three of.
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

/// A sample of the powder, hit by hit: each of its grains stands for the same mass, so that mass is
/// kept to the last bit and a piece of a grain is drawn by its mass. The mean of many samples is
/// the balance (pbm.7).
class Sample {
 public:
  /// `grains` sizes drawn from the feed; `start` of the random numbers. What a collision catches is
  /// worked out for each class of the grid, and for energies an eighth of an octave apart.
  Sample(Process process, std::vector<Nip> nips, SizeGrid grid, const Feed& feed, int grains,
         std::uint64_t start);

  /// Which kind of collision one in that nip and of that `energy` [J] > 0 is.
  int kind(int nip, double energy);
  /// Whether such a collision can do anything to any grain of the grid.
  bool has_effect(int kind) const { return !kinds_[static_cast<std::size_t>(kind)].no_effect; }
  /// A collision of that kind and `energy` [J], which stands for `times` of its like.
  void hit(int kind, double energy, double times = 1);

  std::vector<double> shares() const;  ///< of the mass, in each class of size
  std::int64_t grain_hits() const { return grain_hits_; }
  /// Whether nothing can change any more: all grains are of the finest class, and none weld.
  bool finished() const { return finest_ == grains_ && !(process_.welding > 0); }
  std::vector<double> sizes() const;  ///< [m] of all grains, in no order

 private:
  static constexpr int most_groups = 128;
  struct GrainState {
    double size = 0;
    float strength = 0;  // [J/kg] of models that remember
    std::int32_t size_class = 0;
  };
  /// Of a class: the share of its mass that a collision hits, and the energy that a caught grain
  /// gets over that of the collision [1/kg]. In few bytes: reading them is much of a hit's time.
  struct ClassHit {
    float share = 0, per_energy = 0;
  };
  /// What a kind of collision does to the classes.
  struct CollisionKind {
    std::array<double, most_groups> most{};  // largest share of each group of classes
    std::vector<ClassHit> class_hits;        // of each class
    int nip = 0;
    double energy = 0;      // [J]
    bool no_effect = true;  // nothing that is hit breaks, is weakened or welds
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
  /// Grains by octaves of size, of which a collision hits about the same share each.
  std::vector<std::vector<GrainState>> groups_;
  std::array<double, most_groups> count_{};  // in each
  std::vector<CollisionKind> kinds_;
  std::map<std::pair<int, int>, int> known_;  // kinds by nip and step of energy
  std::vector<double> damage_;                // by load, of models that remember
  SplitMix64 draw_;
  std::int64_t grains_ = 0, grain_hits_ = 0, hits_at_update_ = 0;
  std::int64_t finest_ = 0;  // grains of the finest class
  double mean_size_ = 0;     // [m] that a mixed bed was worked out for
};

}  // namespace mahlwerk::powder
