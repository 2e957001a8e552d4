// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

namespace mahlwerk::observe {

/// What balls do in a lying jar that is shaken, period by period (obs.20).
enum class MotionState : std::uint8_t {
  circling,    ///< they go round the jar's axis on its wall
  bouncing,    ///< they go from end to end
  pinned,      ///< they move with the jar
  stationary,  ///< they stay where they are while the jar moves under them
  irregular    ///< none of these, or no half of the balls does the same
};
constexpr std::array all_motion_states{MotionState::circling, MotionState::bouncing,
                                       MotionState::pinned, MotionState::stationary,
                                       MotionState::irregular};
std::string_view name_of(MotionState state);  ///< "circling"

/// Whether the balls of a jar along `axis` have such states: it lies, is round and closed, and its
/// mill shakes it.
bool has_motion_states(const kinematics::AnyMotion& motion, const geometry::AnyShape& shape,
                       const Vec3& axis);

/// Sums of a replicate, over all its time or over that of one state.
struct MotionTotals {
  double time = 0;    ///< [s]
  double lost = 0;    ///< [J] dissipated
  double hits = 0;    ///< collisions above the threshold
  double energy = 0;  ///< [J] normal energy of these
  double turned = 0;  ///< [s] turns round the jar's axis in a period, mean over balls, times time
  double axial_ratio = 0;  ///< [s] axial travel of the balls over that of the jar, likewise

  MotionTotals& operator+=(const MotionTotals& other);
};

/// The states of motion of a charge: which they are, how long they last, what happens in them. Each
/// period belongs to the state of more than half of the balls; a change counts once it has lasted
/// three periods.
class MotionStates {
 public:
  static constexpr int samples = 24;  ///< in a period

  MotionStates() = default;  ///< ignores samples
  explicit MotionStates(const scene::Chamber& mill);

  /// Adds a sample: the balls in the jar frame at `time` [s]; `so_far` are the totals of `lost`,
  /// `hits` and `energy` at that time. The first begins a period, and so does each `samples`-th one
  /// after it.
  void sample(double time, const std::vector<scene::Ball>& balls, const MotionTotals& so_far);

  /// What happened in the state, and its visits.
  const MotionTotals& in(MotionState state) const { return in_[index(state)]; }
  std::int64_t visits(MotionState state) const { return visits_[index(state)]; }
  /// [s] Time of the balls in the state, a period of a ball at a time, over their number.
  double time_of_balls(MotionState state) const { return of_balls_[index(state)]; }
  double time() const;           ///< [s] of the charge in all states
  double time_of_balls() const;  ///< [s] of the balls in all states, over their number
  std::int64_t taken() const { return taken_; }  ///< samples so far

  void serialize(Archive& archive);

 private:
  static constexpr std::size_t index(MotionState state) { return static_cast<std::size_t>(state); }
  /// The path of a ball in a period, in the axes of the jar.
  struct Path {
    double angle = 0, turned = 0;  // [rad] about the jar's axis: now; since the period began
    Vec3 least, most;              // [m]
    double least_axial = 0, most_axial = 0;  // [m] in the laboratory
    void begin(const Vec3& at, double in_laboratory);
    void go_on(const Vec3& at, double in_laboratory);
  };
  void begin_period(double time, const MotionTotals& so_far);
  void end_period(double time, const MotionTotals& so_far);
  MotionState state_of(const Path& path, double free_length) const;
  void add_period(MotionState state, const MotionTotals& period);

  scene::Chamber mill_;
  bool applies_ = false;
  std::int64_t taken_ = 0;               // samples
  double begun_ = 0;                     // [s] the present period
  MotionTotals at_begin_;                // of the present period
  double jar_least_ = 0, jar_most_ = 0;  // [m] position of the jar's centre along its axis
  std::vector<Path> paths_;
  std::vector<double> free_length_;  // [m] of each ball between the ends of the jar
  std::array<MotionTotals, all_motion_states.size()> in_{};
  std::array<std::int64_t, all_motion_states.size()> visits_{};
  std::array<double, all_motion_states.size()> of_balls_{};
  MotionState now_ = MotionState::irregular, next_ = MotionState::irregular;
  std::int64_t visited_ = 0;  // states so far
  std::int64_t since_ = 0;    // periods in `next_`, not yet added
  MotionTotals pending_;      // these periods
};

}  // namespace mahlwerk::observe
