// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/engine.hpp"
#include "mahlwerk/soft/energy_watch.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "mahlwerk/soft/few/particle_data.hpp"
#include "mahlwerk/soft/species_pairs.hpp"

namespace mahlwerk::soft {

/// The soft engine for few balls: every neighbour pair has a lane (docs/theory/soft.md).
class FewBodySolver final : public scene::Engine, private SlowPath {
 public:
  FewBodySolver(std::unique_ptr<const MovingWall> jar, const std::vector<scene::Ball>& balls,
                const Rules& rules, const contact::PairTable& pairs, double start);

  void advance(double time, scene::Observer& observer) override;
  scene::EnergyBalance energy_balance() const override;
  std::vector<scene::Ball> balls() const override;
  std::vector<Vec3> forces() const override;
  void serialize(Archive& archive) override;

 private:
  // The main loop (solver.cpp).
  void advance_block(std::int64_t until);
  double clock(std::int64_t step) const;    // [s] of the mill
  double time_of(std::int64_t step) const;  // [s] since the start of the run
  void refuse_overlaps() const;
  [[noreturn]] void stop(std::size_t ball, const char* why) const;

  // Energy (energy.cpp).
  struct ElasticEnergy {
    double normal = 0, tangential = 0;  // [J]
  };
  ElasticEnergy elastic_energy() const;  // in contacts, now
  void check_energy();

  // Neighbour list (neighbours.cpp).
  struct NearPair {
    std::int32_t i, j, face;  // face < 0: two balls
    friend auto operator<=>(const NearPair&, const NearPair&) = default;
  };
  void rebuild_neighbour_list() override;
  void find_wall_pairs(std::size_t ball);
  void test_pair(std::size_t i, std::size_t j);
  Vec3 nearest(const Vec3& separation) const {
    return periodic_ ? nearest_image(separation, jar_->periods()) : separation;
  }
  void find_ball_pairs();

  // Lane of each pair (lanes.cpp).
  bool sort_touching_first();
  void fill_lanes(const std::vector<NearPair>& wanted);
  void assign_lane(PairPacket& p, int lane, const NearPair& c);
  void find_wall_points();
  void build_gather_maps();

  // Contacts that begin and end (contacts.cpp).
  void begin(PairPacket& p, const LaneMask& begun, const ContactGeometry& m,
             const PairMotion& b) override;
  void end(PairPacket& p, const LaneMask& ended) override;
  void begin(PairPacket& p, int lane, const ContactGeometry& m, const PairMotion& b);
  void end(PairPacket& p, int lane);
  void flush_work(PairPacket& p, int lane);                // adds its work to the account
  void change_contact_count(std::int64_t body, int more);  // a contact more or less of a ball

  // Free flight (free_flight_skip.cpp).
  bool start_skip();
  std::int64_t collision_free_steps() const;
  struct FreeFlight {
    Vec3 shift, gain;  // of every position and velocity, besides those of straight flight
    double time = 0;
  };
  FreeFlight free_flight(std::int64_t steps) const;
  void end_skip();

  std::unique_ptr<const MovingWall> jar_;
  std::vector<scene::Ball> initial_balls_;  // radius, density, kind; positions of the start
  Rules rules_;
  SpeciesPairs pairs_;
  BlockStepper step_block_;
  double start_, skin_;
  double mass_ = 0;               // [kg] of all balls
  double pull_off_distance_ = 0;  // [m] farthest that a contact holds beyond touch
  bool skips_, periodic_;         // over free flight; the box repeats
  std::vector<double> gaps_;      // [m] of each ball to each face, when the list was built

  ParticleData particles_;
  std::vector<NearPair> found_pairs_, listed_pairs_;  // near each other now; that have a lane
  std::int64_t list_step_ = 0;
  std::int64_t next_skip_ = 0;  // not before this step
  std::int64_t skip_end_ = -1;  // of a skip under way; < 0: none
  std::int64_t now_ = 0;        // the step reached; ahead of the particles' in a skip
  bool touched_ = true;         // in the last step
  double target_time_ = 0;      // [s] where the last call wanted to go

  scene::EnergyBalance energy_balance_;    // of contacts that have ended
  std::vector<std::int32_t> contacts_of_;  // each ball
  std::int64_t balls_in_contact_ = 0;      // balls that touch something
  std::int64_t contact_count_step_ = 0;
  EnergyWatch watch_;
  std::vector<scene::Collision> finished_;
  std::vector<DriveSample> drive_;
};

}  // namespace mahlwerk::soft
