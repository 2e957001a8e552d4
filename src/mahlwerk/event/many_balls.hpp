// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mahlwerk/base/huge_page_allocator.hpp"
#include "mahlwerk/contact/bounce_table.hpp"
#include "mahlwerk/event/calendar_queue.hpp"
#include "mahlwerk/event/collision_prediction.hpp"
#include "mahlwerk/event/contact_records.hpp"
#include "mahlwerk/event/hierarchical_grid.hpp"
#include "mahlwerk/event/moving_wall.hpp"
#include "mahlwerk/event/neighbour_lists.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/event/tc_rule.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The event engine for many balls (event-driven molecular dynamics). Every ball keeps its own
/// earliest event; a calendar queue orders these events. Balls move on straight lines in the
/// falling frame, which falls freely from the jar frame's position and velocity at clock 0 (man.1).
/// There collision times have a closed form. Walls and cells are tested in the jar frame.
class ManyBalls final : public scene::Engine {
 public:
  ManyBalls(std::unique_ptr<const MovingWall> jar, const std::vector<scene::Ball>& balls,
            const Rules& rules, const contact::BounceTable& bounces, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::EnergyBalance energy_balance() const override;
  void begin_counting() override { contacts_.begin_counting(); }
  std::vector<scene::Ball> balls() const override;
  void serialize(Archive& archive) override;

 private:
  /// Position and velocity of the jar frame's origin in the falling frame.
  struct JarOffset {
    double time = -never;
    Vec3 position, velocity;
  };
  /// Relative motion of two touching bodies; the second may be the wall.
  struct CollisionKinematics {
    Vec3 normal;  ///< from the ball to the contact
    Vec3 tangential_velocity,
        slip_velocity;  ///< [m/s] tangential velocity of the centres and of the surfaces
    double mass, slip_factor, approach, slip;
    double pressing_acceleration;  ///< [m/s2] largest acceleration that presses the two together

    /// `slip_factor` [1] is that of the two bodies (hol.4), `relative_velocity` [m/s] that of the
    /// centres, `rolling` [m/s] the sum of the spins times their radii.
    CollisionKinematics(const Vec3& n, double mass_, double slip_factor_,
                        const Vec3& relative_velocity, const Vec3& rolling,
                        double pressing_acceleration_)
        : normal(n),
          tangential_velocity(tangential_part(relative_velocity, n)),
          slip_velocity(tangential_velocity + cross(rolling, n)),
          mass(mass_),
          slip_factor(slip_factor_),
          approach(dot(relative_velocity, n)),
          slip(norm(slip_velocity)),
          pressing_acceleration(pressing_acceleration_) {}

    Vec3 impulse(const contact::Impulse& j) const {  ///< [N s] on the ball
      return -j.normal * normal - (slip > 0 ? j.tangential / slip : 0.0) * slip_velocity;
    }
  };

  // many_balls.cpp: event loop
  void process_event(std::int32_t ball);
  void prefetch_next_events();
  void prefetch_ball(std::int32_t ball) const;
  void prefetch_candidates(std::int32_t ball) const;
  void prefetch_trajectories(std::span<const std::int32_t> balls) const;
  void check_wall_and_cell(std::int32_t ball);
  void process_collision(std::int32_t ball);
  void reorganise();
  bool is_consistent(std::size_t count);
  void rebuild_queue();
  void check_zeno();
  void hand_over(scene::Observer& observer);

  // many_predictions.cpp: predictions and ball positions
  void predict_all();
  void predict_and_schedule(std::int32_t ball, std::span<const std::int32_t> others);
  void predict(std::int32_t ball, std::span<const std::int32_t> others);
  void predict_collisions_with(std::int32_t ball, std::span<const std::int32_t> others);
  void predict_collisions(std::int32_t ball, std::span<const std::int32_t> others);
  std::span<const std::int32_t> candidates(std::int32_t ball, std::size_t buffer = 0);
  PredictedCollision first_of_images(const CollisionQuery& query,
                                     std::span<const std::int32_t> others,
                                     PredictedCollision found) const;
  void advance_to_now(std::int32_t ball);
  void move_frame(double shift);
  const JarOffset& jar_offset();
  JarOffset jar_offset_at(double t) const;
  BallState ball_state(std::int32_t ball);

  // many_neighbourhoods.cpp: cells and neighbour lists
  double neighbourhood_safe_time(std::int32_t ball, const BallState& where) const;
  double cell_safe_time(std::int32_t ball, const BallState& where) const;
  bool has_left(std::int32_t ball, const BallState& where) const;
  void renew_neighbourhood(std::int32_t ball, const BallState& where);
  void change_cell(std::int32_t ball, const BallState& where);
  void make_neighbourhoods();
  void renew_list(std::int32_t ball, const Vec3& position);
  void sort();

  // many_collisions.cpp: impulses, records, energy balance
  void hit_wall(std::int32_t ball, int face);
  void hit_ball(std::int32_t ball, std::int32_t other);
  using Bounce = TcRule::Result;
  Bounce bounce(const contact::BounceRule& rule, const CollisionKinematics& touch,
                double effective_radius, double since, StoredEnergy stored);
  void apply_impulse(std::int32_t ball, const Vec3& impulse, const Vec3& arm);
  bool slow(const CollisionKinematics& touch) const {
    return touch.approach < tc_rule_.min_rebound_speed(0, touch.pressing_acceleration);
  }
  void add_contact_time(CollisionData& ball, bool slow);
  void update_energy_balance(const CollisionKinematics& touch, const Bounce& bounce, double gained,
                             double work, double before);
  bool twists(const Bounce& bounce) const { return rules_.twisting && !bounce.raised; }
  contact::EffectivePair wall_pair(const std::optional<contact::PairTable>& moduli,
                                   const Species& ball, int face) const;
  contact::EffectivePair ball_pair(const std::optional<contact::PairTable>& moduli,
                                   const Species& a, const Species& b) const;
  double longest_joining_time() const;
  void record(std::int32_t ball, std::int32_t other, const CollisionKinematics& touch,
              const Vec3& point, const Bounce& bounce, double since,
              const contact::EffectivePair& pair);
  double kinetic(std::int32_t ball, double t) const;

  /// Time argument for the jar's motion [s]. Where the motion repeats it is the clock itself, which
  /// differs from the mill time by whole periods, or by any time if the motion is steady.
  double motion_time(double clock) const { return jar_->repeats() ? clock : clock_origin_ + clock; }
  double mill_time() const { return clock_origin_ + now_; }
  Vec3 lab_velocity(const Trajectory& trajectory, double t) const {
    return trajectory.velocity + epoch_.velocity + t * gravity_;
  }

  /// Whether the data of all balls stays in the cache, so that prefetching gains nothing.
  bool fits_cache() const { return trajectories_.size() <= 4096; }

  Trajectory& trajectory(std::int32_t ball) {
    return trajectories_[static_cast<std::size_t>(ball)];
  }
  Prediction& prediction_of(std::int32_t ball) {
    return predictions_[static_cast<std::size_t>(ball)];
  }
  CollisionData& collision_data(std::int32_t ball) {
    return collision_data_[static_cast<std::size_t>(ball)];
  }
  int level(std::int32_t ball) const {
    return grid_->level_of(trajectories_[static_cast<std::size_t>(ball)].species);
  }
  const Species& species(const Trajectory& trajectory) const {
    return species_[trajectory.species];
  }

  std::unique_ptr<const MovingWall> jar_;
  Rules rules_;
  TcRule tc_rule_;
  contact::BounceTable bounces_;
  Vec3 gravity_, periods_;
  bool walls_, periodic_;
  geometry::AccelerationBound max_acceleration_;
  // [m/s2] largest acceleration with which the mill presses a ball to its wall (man.4)
  double pressing_acceleration_;

  HugePageVector<Trajectory> trajectories_;
  HugePageVector<Prediction> predictions_;
  HugePageVector<CollisionData> collision_data_;
  std::vector<Species> species_;
  std::vector<double> radii_;               // [m] by species
  std::vector<TouchTolerance> tolerances_;  // by species
  CollisionSearch* earliest_collision_ = collision_search();
  std::unique_ptr<HierarchicalGrid> grid_;
  std::unique_ptr<NeighbourLists> lists_;  // of a dense charge; else the cells name all neighbours
  CalendarQueue queue_;

  double start_;                   // [s] mill time at which the run began
  double now_ = 0;                 // [s] on the engine's clock
  double clock_origin_ = 0;        // [s] mill time = clock_origin_ + clock
  double horizon_ = 0;             // [s] clock: end of the present advance()
  kinematics::FrameMotion epoch_;  // the jar's frame motion at clock 0, start of the falling frame
  JarOffset jar_offset_;
  double reached_ = 0;  // [s] since the start
  std::int64_t events_ = 0, collisions_at_reorganisation_ = 0;
  double reorganised_ = 0;             // [s] clock
  std::int64_t zeno_first_event_ = 0;  // events_ when the present count of the Zeno guard began
  double zeno_since_ = 0;              // [s] mill time of that
  scene::EnergyBalance energy_balance_;
  ContactRecords contacts_;
  std::vector<scene::Collision> finished_;
};

}  // namespace mahlwerk::event
