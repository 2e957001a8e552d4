// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::observe {

/// A short film of the balls for the report: places to a 32 767th of the jar's reach, of at most
/// `most_balls` of them, in at most about 1.6 MB.
class Replay {
 public:
  static constexpr std::size_t most_balls = 20000, most_places = 150000;

  Replay() = default;  ///< of nothing
  /// From `begin` [s], about three periods of the mill or a turn of a drum, but no longer than
  /// `most` [s].
  Replay(const scene::Chamber& mill, std::size_t balls, double begin, double most);

  double next() const;  ///< [s] when the next frame is due; infinite after the last
  /// The balls in the jar frame at `time` [s].
  void add(double time, const std::vector<scene::Ball>& balls);
  bool empty() const { return times_.empty(); }

  const std::vector<double>& times() const { return times_; }
  std::size_t balls() const { return shown_; }
  std::size_t every() const { return every_; }       ///< each so manieth ball is shown
  double place_unit() const { return place_unit_; }  ///< [m]
  /// Frame after frame, ball after ball: x, y, z in place_unit(), in the jar frame.
  const std::vector<std::array<std::int16_t, 3>>& places() const { return places_; }
  const std::vector<float>& speeds() const { return speeds_; }  ///< [m/s] in the jar frame

  void carry(Archive& archive);

 private:
  double begin_ = 0, every_seconds_ = 0, place_unit_ = 1;
  std::size_t frames_ = 0, shown_ = 0, every_ = 1;
  std::vector<double> times_;
  std::vector<std::array<std::int16_t, 3>> places_;
  std::vector<float> speeds_;
};

}  // namespace mahlwerk::observe
