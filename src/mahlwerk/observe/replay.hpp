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
  static constexpr std::size_t most_balls = 20000, most_positions = 150000;

  Replay() = default;  ///< of nothing
  /// From `begin` [s], about three periods of the mill or a turn of a drum, but no longer than
  /// `most` [s].
  Replay(const scene::Chamber& mill, std::size_t balls, double begin, double most);

  double next_frame_time() const;  ///< [s] when the next frame is due; infinite after the last
  /// The balls in the jar frame at `time` [s].
  void add(double time, const std::vector<scene::Ball>& balls);
  bool empty() const { return times_.empty(); }

  const std::vector<double>& times() const { return times_; }
  std::size_t balls() const { return shown_balls_; }
  std::size_t ball_stride() const { return ball_stride_; }  ///< each so manieth ball is shown
  double position_unit() const { return position_unit_; }   ///< [m]
  /// Frame after frame, ball after ball: x, y, z in position_unit(), in the jar frame.
  const std::vector<std::array<std::int16_t, 3>>& positions() const { return positions_; }
  const std::vector<float>& speeds() const { return speeds_; }  ///< [m/s] in the jar frame

  void serialize(Archive& archive);

 private:
  double begin_ = 0, frame_interval_ = 0, position_unit_ = 1;
  std::size_t frames_ = 0, shown_balls_ = 0, ball_stride_ = 1;
  std::vector<double> times_;
  std::vector<std::array<std::int16_t, 3>> positions_;
  std::vector<float> speeds_;
};

}  // namespace mahlwerk::observe
