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

/// Frames of the balls for the report's replay: positions in 16-bit fixed point, to a 32 767th of
/// the jar's reach, of at most `max_balls` balls, in at most about 1.6 MB.
class Replay {
 public:
  static constexpr std::size_t max_balls = 20000, max_positions = 150000;

  /// The position of a ball that is not in the jar: no rounded one has these coordinates.
  static constexpr std::array<std::int16_t, 3> outside{-32768, -32768, -32768};

  Replay() = default;  ///< records no frames
  /// Records from `begin` [s] about three periods of the mill or one turn of a drum, but at most
  /// `most` [s]; longer if frames are `shortest` [s] or more apart.
  Replay(const scene::Chamber& mill, std::size_t balls, double begin, double most,
         double shortest = 0);

  double next_frame_time() const;  ///< [s] time of the next frame; infinite after the last
  /// Adds a frame: the balls in the jar frame at `time` [s], which is `mill_time` [s] of the mill
  /// at full speed. An engine that gives its balls at fewer times than there are frames gives the
  /// same time again: that frame is left out.
  void add(double time, double mill_time, const std::vector<scene::Ball>& balls);
  bool empty() const { return times_.empty(); }

  const std::vector<double>& times() const { return times_; }
  const std::vector<double>& mill_times() const { return mill_times_; }
  std::size_t balls() const { return shown_balls_; }
  std::size_t ball_stride() const { return ball_stride_; }  ///< every n-th ball is drawn
  double position_unit() const { return position_unit_; }   ///< [m]
  /// x, y, z in position_unit(), in the jar frame, by frame, then by ball.
  const std::vector<std::array<std::int16_t, 3>>& positions() const { return positions_; }
  const std::vector<float>& speeds() const { return speeds_; }  ///< [m/s] in the jar frame

  void serialize(Archive& archive);

 private:
  double begin_ = 0, frame_interval_ = 0, position_unit_ = 1;
  std::size_t frames_ = 0, shown_balls_ = 0, ball_stride_ = 1;
  std::size_t due_ = 0;  // frames added or left out
  std::vector<double> times_, mill_times_;
  std::vector<std::array<std::int16_t, 3>> positions_;
  std::vector<float> speeds_;
};

}  // namespace mahlwerk::observe
