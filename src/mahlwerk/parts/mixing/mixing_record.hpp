// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "mahlwerk/observe/recorder.hpp"
#include "mahlwerk/parts/mixing/instant.hpp"
#include "mahlwerk/parts/mixing/mixing.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::parts::mixing {

/// One sample of the charge.
struct MixingSample {
  double time = 0;                     ///< [s] since counting began
  double lacey = 0, neighbours = 0;    ///< [1]
  double radial = 0, vertical = 0;     ///< [1] segregation of the first colour (mix.4)
  double axial = 0;                    ///< [1] likewise; NaN in a jar that is periodic along it
  double axial_spread = 0;             ///< [m2] mean square axial displacement of the balls
  double packing = 0, bed_height = 0;  ///< [1] NaN without a bed, [m]
};

/// The packing at one height of one sample.
struct PackingAtHeight {
  std::uint32_t sample = 0;
  std::uint32_t layer = 0;  ///< from the lowest point of the balls, each of half a mean diameter
  double points = 0;        ///< [1]
  double sum = 0;           ///< [1] of the packing fractions around the points
};

/// What the recorder needs to know of a case.
struct MixingSetup {
  Mixing section;
  scene::Chamber mill;
  /// [rad/s] Speed without load of a mill that a motor turns, whose angle over it is its time; or 0
  double driven = 0;
  double interval = 0;  ///< [s]
  double cell = 0;      ///< [m] side of the cubes of Lacey's index
  double reach = 0;     ///< [m] of neighbours
  double diameter = 0;  ///< [m] of a ball of mean volume
  bool flows = false;   ///< balls leave the jar and enter it
};

/// Follows the mixing of the charge at equal intervals.
class MixingRecord final : public observe::Recorder {
 public:
  explicit MixingRecord(MixingSetup setup) : setup_(std::move(setup)) {}

  std::unique_ptr<observe::Recorder> copy() const override {
    return std::make_unique<MixingRecord>(*this);
  }
  void begin(double time) override { begin_ = time; }
  double next() const override {
    return begin_ + setup_.interval * static_cast<double>(samples_.size());
  }
  bool wants_balls() const override { return true; }
  void take_balls(const scene::EnergyBalance& now, double time_of_balls,
                  const std::vector<scene::Ball>& balls) override;
  void serialize(Archive& archive) override {
    archive(begin_)(samples_)(profile_)(colours_)(axial_)(moved_);
  }

  const std::vector<MixingSample>& samples() const { return samples_; }
  const std::vector<PackingAtHeight>& profile() const { return profile_; }
  double layer_height() const { return 0.5 * setup_.diameter; }  ///< [m]

 private:
  void colour(const std::vector<scene::Ball>& balls, const Instant& at);
  void follow(const std::vector<scene::Ball>& balls, const Instant& at);
  double packing(const std::vector<scene::Ball>& balls, const std::vector<scene::Ball>& own,
                 const Instant& at);
  MixingSample sample(const std::vector<scene::Ball>& balls, const Instant& at);
  void add_indices(MixingSample& s, const std::vector<scene::Ball>& balls,
                   const std::vector<std::uint8_t>& colours, const Instant& at) const;
  void add_indices_of_coloured(MixingSample& s, const std::vector<scene::Ball>& all,
                               const Instant& at) const;

  MixingSetup setup_;
  double begin_ = std::numeric_limits<double>::infinity();
  std::vector<MixingSample> samples_;
  std::vector<PackingAtHeight> profile_;
  static constexpr std::uint8_t uncoloured = 2;  // was outside when counting began
  std::vector<std::uint8_t> colours_;            // of the balls: 1 the first colour, 0 the other
  std::vector<double> axial_, moved_;  // [m] along the jar's axis: place, and way since the start
};

}  // namespace mahlwerk::parts::mixing
