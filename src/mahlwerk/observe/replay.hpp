// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// A hit that a replay marks.
struct ReplayHit {
  double time = 0;                   ///< [s] of first touch, since the start of the run
  double energy = 0;                 ///< [J] of the normal motion (evt.9)
  Vec3 where;                        ///< [m] in the jar's own axes
  std::int32_t ball = 0, other = 0;  ///< as in scene::Collision
};

/// Frames of the balls for the report's replay: positions in 16-bit fixed point, to a 32 767th of
/// the jar's reach, of at most `max_balls` balls, in at most about 1.6 MB; and the strongest hits
/// between the frames.
class Replay {
 public:
  static constexpr std::size_t max_balls = 20000, max_positions = 150000, max_hits = 3000;

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
  /// Adds collisions: those before the first or after the last frame are left out, and of those
  /// between two frames the ones of largest energy are kept. Which ones does not depend on the
  /// order in which they come. Those from `threshold` [m/s] on count as hits of their balls.
  void add_hits(std::span<const scene::Collision> finished, double threshold);
  bool empty() const { return times_.empty(); }

  const std::vector<double>& times() const { return times_; }
  const std::vector<double>& mill_times() const { return mill_times_; }
  std::size_t balls() const { return shown_balls_; }
  std::size_t ball_stride() const { return ball_stride_; }  ///< every n-th ball is drawn
  double position_unit() const { return position_unit_; }   ///< [m]
  /// x, y, z in position_unit(), in the jar frame, by frame, then by ball.
  const std::vector<std::array<std::int16_t, 3>>& positions() const { return positions_; }
  const std::vector<float>& speeds() const { return speeds_; }  ///< [m/s] in the jar frame
  const std::vector<float>& spins() const { return spins_; }    ///< [rad/s]
  std::vector<ReplayHit> hits() const;                          ///< in the order of their times
  /// Hits of each ball shown, from the threshold on, between the first and the last frame.
  const std::vector<std::uint32_t>& hits_of_balls() const { return hits_of_balls_; }

  void serialize(Archive& archive);

 private:
  void keep(const scene::Collision& hit);
  void count(std::int32_t ball);
  std::size_t intervals() const { return frames_ - 1; }
  std::size_t hits_in_interval() const;
  bool hits_are_whole() const;

  double begin_ = 0, frame_interval_ = 0, position_unit_ = 1;
  std::size_t frames_ = 0, shown_balls_ = 0, ball_stride_ = 1;
  std::size_t due_ = 0;  // frames added or left out
  std::vector<double> times_, mill_times_;
  std::vector<std::array<std::int16_t, 3>> positions_;
  std::vector<float> speeds_, spins_;
  // For each interval between frames as many places as hits are kept, `kept_` of them in use, as a
  // heap with the weakest hit first.
  std::vector<ReplayHit> hits_;
  std::vector<std::uint32_t> kept_, hits_of_balls_;
};

}  // namespace mahlwerk::observe
