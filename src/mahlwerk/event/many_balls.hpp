// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mahlwerk/base/roomy.hpp"
#include "mahlwerk/contact/bounce_table.hpp"
#include "mahlwerk/event/calendar.hpp"
#include "mahlwerk/event/enclosure.hpp"
#include "mahlwerk/event/meetings.hpp"
#include "mahlwerk/event/neighbours.hpp"
#include "mahlwerk/event/rules.hpp"
#include "mahlwerk/event/sustained_contact.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The event engine for many balls. Every ball keeps its own earliest event; a calendar tells whose
/// is next. Balls run straight in the falling frame, in which meetings have a closed form, and are
/// looked at in the jar frame, in which walls and cells are.
class ManyBalls final : public scene::Engine {
 public:
  ManyBalls(std::unique_ptr<const Enclosure> jar, const std::vector<scene::Ball>& balls,
            const Rules& rules, const contact::BounceTable& bounces, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::Account account() const override;
  std::vector<scene::Ball> balls() const override;
  void carry(Archive& archive) override;

 private:
  /// Where the jar frame is in the falling frame.
  struct Drift {
    double time = -at_no_time;
    Vec3 place, velocity;
  };
  /// Two bodies as they touch; the second may be the wall.
  struct Touching {
    Vec3 normal;             ///< from the ball to the contact
    Vec3 gliding, slipping;  ///< [m/s] tangential, of the centres and of the surfaces
    double mass, approach, slip;
    double press;  ///< [m/s2] that holds them together, at most

    /// `glide` [m/s] of the centres, `rolling` [m/s] the spins times their radii, added.
    Touching(const Vec3& n, double mass_, const Vec3& glide, const Vec3& rolling, double press_)
        : normal(n),
          gliding(across(glide, n)),
          slipping(gliding + cross(rolling, n)),
          mass(mass_),
          approach(dot(glide, n)),
          slip(norm(slipping)),
          press(press_) {}

    Vec3 impulse(const contact::Impulse& j) const {  ///< [N s] on the ball
      return -j.normal * normal - (slip > 0 ? j.tangential / slip : 0.0) * slipping;
    }
  };

  // many_balls.cpp: what happens next
  void happen(std::int32_t ball);
  void fetch_ahead() const;
  void look(std::int32_t ball);
  void meet(std::int32_t ball);
  void renew();
  bool holds_together(std::size_t count);
  void start_calendar();
  void guard();
  void hand_over(scene::Observer& observer);

  // many_plans.cpp: predictions, and where balls are
  void plan_all();
  void plan(std::int32_t ball);
  void predict(std::int32_t ball);
  void plan_meeting(std::int32_t ball, std::span<const std::int32_t> others);
  void plan_meetings(std::int32_t ball);
  double leaves(std::int32_t ball, const Passing& where) const;
  bool has_left(std::int32_t ball, const Passing& where) const;
  Meeting first_of_images(const Asking& asking, std::span<const std::int32_t> others,
                          Meeting found) const;
  void change_cell(std::int32_t ball, const Passing& where);
  void bring_to_now(std::int32_t ball);
  void move_frame(double shift);
  void sort();
  void fill_cells();
  const Drift& drift();
  Drift drift_at(double t) const;
  Passing passing(std::int32_t ball);

  // many_collisions.cpp: impulses, records, the account
  void hit_wall(std::int32_t ball, int face);
  void hit_ball(std::int32_t ball, std::int32_t other);
  using Bounce = SustainedContact::Result;
  Bounce bounce(const contact::BounceRule& rule, const Touching& touch, double since,
                StoredEnergy stored);
  void kick(std::int32_t ball, const Vec3& impulse, const Vec3& arm);
  bool slow(const Touching& touch) const {
    return touch.approach < sustained_.slowest_rebound(0, touch.press);
  }
  void count_contact(Turning& ball, bool slow);
  void settle_account(const Touching& touch, const Bounce& bounce, double gained, double work,
                      double scale);
  void record(std::int32_t ball, std::int32_t other, const Touching& touch, const Vec3& point,
              double impulse, const contact::Loss& loss);
  double kinetic(std::int32_t ball, double t) const;

  double motion_time(double clock) const { return jar_->looks_still() ? clock : before_ + clock; }
  double mill_time() const { return before_ + now_; }
  Vec3 lab_velocity(const Line& line, double t) const {
    return line.velocity + epoch_.velocity + t * gravity_;
  }

  Line& line(std::int32_t ball) { return lines_[static_cast<std::size_t>(ball)]; }
  Plan& plan_of(std::int32_t ball) { return plans_[static_cast<std::size_t>(ball)]; }
  Turning& turning(std::int32_t ball) { return turnings_[static_cast<std::size_t>(ball)]; }
  int level(std::int32_t ball) const {
    return neighbours_->level_of(lines_[static_cast<std::size_t>(ball)].species);
  }
  const Species& species(const Line& line) const { return species_[line.species]; }

  std::unique_ptr<const Enclosure> jar_;
  Rules rules_;
  SustainedContact sustained_;
  contact::BounceTable bounces_;
  Vec3 gravity_, periods_;
  bool walls_, periodic_;
  geometry::Pull pull_;
  double press_;  // [m/s2] the most that the mill presses a ball with (man.4)

  RoomyVector<Line> lines_;
  RoomyVector<Plan> plans_;
  RoomyVector<Turning> turnings_;
  std::vector<Species> species_;
  std::vector<double> radii_;    // [m] by species
  std::vector<Feeler> feelers_;  // by species
  std::unique_ptr<Neighbours> neighbours_;
  Calendar calendar_;

  double start_;            // [s] mill time at which the run began
  double now_ = 0;          // [s] on the engine's clock
  double before_ = 0;       // [s] mill time = before_ + clock
  double horizon_ = 0;      // [s] clock: nothing at or after it happens in this call
  kinematics::Ride epoch_;  // of the falling frame: the jar's ride at clock 0
  Drift drift_;
  double reached_ = 0;  // [s] since the start
  std::int64_t events_ = 0, renewed_collisions_ = 0;
  double renewed_ = 0;  // [s] clock
  std::int64_t guarded_ = 0;
  double guarded_since_ = 0;  // [s] mill time
  scene::Account account_;
  std::vector<scene::Collision> finished_;
};

}  // namespace mahlwerk::event
